// What all parts of the page do with its elements.

export const byId = (id) => document.getElementById(id);

/** An element with properties and children. */
export function element(name, properties, ...children) {
  const made = Object.assign(document.createElement(name), properties);
  made.append(...children);
  return made;
}

/** Calls `show` with what is shown, if that is not the same as the last time. What has not changed is left as it is: for speed, and for
 * readers who are in the middle of it. */
export function whenChanged(show) {
  let last;
  return (value) => {
    const key = JSON.stringify(value);
    if (key !== last) show(value);
    last = key;
  };
}

/** Puts a text, if it is another. */
export function put(target, text) {
  if (target.textContent !== text) target.textContent = text;
}

let timer = 0;
/** Says something for a while. */
export function say(text) {
  byId("note").textContent = text;
  clearTimeout(timer);
  timer = setTimeout(() => (byId("note").textContent = ""), 9000);
}

/** Copies a text and says so; where a browser does not copy, the text itself is said. */
export async function copy(text, words) {
  try {
    await navigator.clipboard.writeText(text);
    say(words);
  } catch {
    say(text);
  }
}

/** The day on this machine, as 2026-11-21. */
export function today() {
  const now = new Date();
  return [now.getFullYear(), now.getMonth() + 1, now.getDate()].map((part) => String(part).padStart(2, "0")).join("-");
}

/** The name of the case's file without its ending. */
export const stem = (name) => name.replace(/\.toml$/i, "").replace(/[^\p{L}\p{N}._-]+/gu, "-") || "case";

/** A symbol of the table of keys, such as ρ_b, with its index below. */
export function symbolOf(symbol) {
  const [letter, index] = symbol.split("_");
  return element("i", {}, letter.replace("'", "′"), ...(index ? [element("sub", {}, index)] : []));
}
