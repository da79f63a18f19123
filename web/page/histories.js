// How loads and the base go with time: shapes from a menu, and points that a hand drags, written into the text; other numbers are fields
// of the form.

import { byId, element, whenChanged } from "dom";
import { dragged } from "dragged";
import { redraw } from "redraw";

const HEIGHT = 190;
/** Of the drawing's width or height, with an arrow key. */
const STEP = 0.01;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
const HINT = "Drag a point; click beside the line for another; a double click or Delete takes one away.";

/** The course of a history: its line, and a ring at each of its points. */
function courseOf(app, key) {
  const picture = element("div", { className: "picture" });
  const hint = element("p", { className: "hint" }, HINT);
  const place = element("div", { className: "drawing course" }, picture);
  const rings = [];
  const at = (event) => {
    const box = picture.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  const done = (change) => {
    change();
    app.changed();
  };
  const ring = (i) => {
    const handle = element("button", { type: "button", className: "ring" });
    dragged(app, handle, () => {}, (event) => {
      const [x, y] = at(event);
      return () => app.explorer.drag_corner(key, i, x, y);
    });
    handle.addEventListener("dblclick", () => done(() => app.explorer.remove_corner(key, i)));
    handle.addEventListener("keydown", (event) => {
      if (event.ctrlKey || event.metaKey || event.altKey) return;
      const arrow = ARROWS[event.key];
      const far = STEP * (event.shiftKey ? 10 : 1);
      if (arrow) done(() => app.explorer.nudge_corner(key, i, arrow[0] * far, arrow[1] * far));
      else if (event.key === "Delete" || event.key === "Backspace") done(() => app.explorer.remove_corner(key, i));
      else return;
      event.preventDefault();
    });
    return handle;
  };
  picture.addEventListener("click", (event) => {
    if (rings.length > 0) done(() => app.explorer.add_corner(key, ...at(event)));
  });
  return {
    parts: [place, hint],
    show() {
      const json = app.explorer.course(key, Math.max(280, place.parentElement.clientWidth), HEIGHT);
      const { svg, corners } = json ? JSON.parse(json) : { svg: "", corners: [] };
      place.hidden = !svg;
      hint.hidden = corners.length === 0;
      redraw(picture, svg);
      picture.classList.toggle("drawable", corners.length > 0);
      while (rings.length < corners.length) rings.push(ring(rings.length));
      for (const gone of rings.splice(corners.length)) gone.remove();
      corners.forEach(({ x, y, words }, i) => {
        if (!rings[i].parentElement) place.append(rings[i]);
        rings[i].style.left = `${x}px`;
        rings[i].style.top = `${y}px`;
        rings[i].setAttribute("aria-label", `${words}; drag it, or use arrow keys; Delete takes it away`);
      });
    },
  };
}

export function connectHistories(app) {
  const rows = new Map();
  const fault = element("p", { id: "histories-fault", className: "bad" });
  fault.setAttribute("role", "alert");
  const row = ({ key, words, shapes, still }) => {
    const name = (shape) => new Option(shape === "points" ? "points, drawn by hand" : shape, shape);
    const select = element("select", {}, ...(still ? [new Option("does not change in time", "")] : []), ...shapes.map(name));
    select.addEventListener("change", () => {
      fault.replaceChildren(app.explorer.set_history(key, select.value) ?? "");
      app.changed();
    });
    select.id = `history-${key}`;
    const course = courseOf(app, key);
    rows.set(key, { select, course });
    return element("div", { className: "history" }, element("div", { className: "row" }, element("label", { htmlFor: select.id }, words), select), ...course.parts);
  };
  const build = whenChanged((list) => {
    rows.clear();
    const all = list.length > 0 ? [element("section", {}, element("h3", {}, "With time"), ...list.map(row), fault)] : [];
    byId("histories").replaceChildren(...all);
  });
  return () => {
    if (app.tab !== "inputs") return;
    const list = JSON.parse(app.explorer.courses());
    build(list.map(({ key, words, shape, shapes }) => ({ key, words, shapes, still: shape === "" })));
    for (const { key, shape } of list) {
      rows.get(key).select.value = shape;
      rows.get(key).course.show();
    }
  };
}
