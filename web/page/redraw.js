// Drawings, tables and lists come from the library whole. What of one is as it was before stays on the page, so that the browser sets and
// paints only what has changed.

const reader = document.createElement("template");
const shown = new WeakMap();

/** Puts a drawing into its place, or with an empty text nothing. */
export function redraw(place, svg) {
  if (shown.get(place) === svg) return;
  shown.set(place, svg);
  reader.innerHTML = svg.trim();
  refill(place, [...reader.content.childNodes]);
}

/** Puts nodes into a place in which no others are but those of the time before. */
export function refill(place, nodes) {
  const olds = [...place.childNodes];
  nodes.forEach((node, i) => (i < olds.length ? fit(olds[i], node, true) : place.append(node)));
  olds.slice(nodes.length).forEach((node) => node.remove());
}

/** Makes of a node what another one is, which may take its place. How large a whole drawing is shown is the page's to say. */
function fit(old, made, isWhole = false) {
  if (old.isEqualNode(made)) return;
  if (old.nodeType !== made.nodeType || old.nodeName !== made.nodeName) return old.replaceWith(made);
  if (old.nodeType !== Node.ELEMENT_NODE) {
    old.data = made.data;
    return;
  }
  const keeps = (name) => made.hasAttribute(name) || (isWhole && name === "style");
  for (const { name } of [...old.attributes]) if (!keeps(name)) old.removeAttribute(name);
  for (const { name, value } of made.attributes) {
    if (old.getAttribute(name) === value) continue;
    // The page's policy lets no text be a style, but lets scripts set one.
    if (name === "style") old.style.cssText = value;
    else old.setAttribute(name, value);
  }
  const [olds, mades] = [[...old.childNodes], [...made.childNodes]];
  mades.forEach((child, i) => (i < olds.length ? fit(olds[i], child) : old.append(child)));
  olds.slice(mades.length).forEach((child) => child.remove());
}
