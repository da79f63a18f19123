// What stands in place of the page where a browser cannot run it.

/** Says that the explorer did not start, and hands the error on. */
export function notStarted(error) {
  const fault = document.getElementById("fault") ?? document.body.appendChild(document.createElement("p"));
  fault.hidden = false;
  fault.textContent = `The explorer did not start in this browser: ${error}`;
  throw error;
}
