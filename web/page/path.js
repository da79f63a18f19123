// The load path, drawn when it is open.

export function connectPath(app) {
  const details = document.getElementById("path");
  const picture = document.getElementById("path-picture");
  const words = document.getElementById("path-words");
  details.addEventListener("toggle", app.changed);
  let drawn = "";
  let wet = false;
  return (reading) => {
    // Loads that count are not to be hidden.
    if (reading.with_water && !wet) details.open = true;
    wet = reading.with_water;
    if (!details.open) return;
    const across = Math.max(200, Math.min(520, picture.clientWidth - 110));
    const key = `${app.explorer.fragment()} ${across}`;
    if (key === drawn) return;
    drawn = key;
    const path = JSON.parse(app.explorer.load_path(across));
    picture.innerHTML = path.svg;
    words.innerHTML = path.words.map((sentence) => `<p>${sentence}</p>`).join("");
  };
}
