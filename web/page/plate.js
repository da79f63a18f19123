// The right plate: share of the load and friction, the report's plane of force and friction, or the histories of a motion.

import { byId, put } from "dom";
import { dragged } from "dragged";
import { redraw } from "redraw";
import { kept, room } from "room";

const STEP = 0.01;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
const TITLES = { load: "How much of the load, at which friction", "k-mu": "Force and friction", directions: "Rest over all directions", time: "The motion in time" };

export function connectPlate(app) {
  const map = byId("map");
  const picture = map.querySelector(".picture");
  const point = byId("point");
  const buttons = [...document.querySelectorAll("[data-plate]")];
  let scale = 1;
  let drawn = "";
  app.plate = "";
  const isMap = () => app.shownPlate === "k-mu";
  const place = (event) => {
    const box = picture.getBoundingClientRect();
    return [(event.clientX - box.left) / scale, (event.clientY - box.top) / scale];
  };
  for (const button of buttons) {
    button.addEventListener("click", () => {
      app.plate = button.dataset.plate;
      app.changed();
    });
  }

  // The point: dragged, or moved by keys.
  let offset = [0, 0];
  const gripped = (event) => {
    const [x, y] = app.explorer.point();
    const at = place(event);
    // The point keeps its place under the hand.
    offset = [x - at[0], y - at[1]];
  };
  const letGo = dragged(app, point, gripped, (event) => {
    const [x, y] = place(event);
    return () => app.explorer.drag_point(x + offset[0], y + offset[1]);
  });
  point.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape" && app.held) {
      letGo();
    } else if (arrow && event.shiftKey) {
      const size = picture.clientWidth / scale;
      app.explorer.pan(-arrow[0] * size * 0.05, arrow[1] * size * 0.05);
    } else if (arrow) {
      app.explorer.nudge(arrow[0] * STEP, arrow[1] * STEP);
    } else if (event.key === "+" || event.key === "=") {
      app.explorer.zoom(0.7);
    } else if (event.key === "-") {
      app.explorer.zoom(1 / 0.7);
    } else if (event.key === "0") {
      app.explorer.reset_view();
    } else {
      return;
    }
    event.preventDefault();
    app.changed();
  });

  // The background of the report's plane: a click places the point, a drag moves the view, two fingers zoom.
  const fingers = new Map();
  let travelled = 0;
  const span = () => {
    const [one, two] = [...fingers.values()];
    return { far: Math.hypot(one[0] - two[0], one[1] - two[1]), x: (one[0] + two[0]) / 2, y: (one[1] + two[1]) / 2 };
  };
  picture.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || app.shownPlate === "time") return;
    picture.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, place(event));
    travelled = fingers.size > 1 ? Infinity : 0;
  });
  picture.addEventListener("pointermove", (event) => {
    const last = fingers.get(event.pointerId);
    if (!last) return;
    const before = fingers.size === 2 ? span() : null;
    const now = place(event);
    fingers.set(event.pointerId, now);
    const [right, down] = [now[0] - last[0], now[1] - last[1]];
    travelled += Math.hypot(right, down);
    if (!isMap()) return;
    if (before) {
      const after = span();
      app.explorer.pan(after.x - before.x, after.y - before.y);
      if (after.far > 0) app.explorer.zoom(before.far / after.far, after.x, after.y);
      app.changed();
    } else if (travelled > 4 && fingers.size === 1) {
      map.classList.add("moving");
      app.explorer.pan(right, down);
      app.changed();
    }
  });
  const lift = (event) => {
    if (fingers.delete(event.pointerId) && travelled <= 4 && event.type === "pointerup" && !point.hidden) {
      app.explorer.grab();
      app.explorer.drag_point(...place(event));
      app.explorer.release();
      point.focus({ preventScroll: true });
      app.changed();
    }
    map.classList.remove("moving");
  };
  picture.addEventListener("pointerup", lift);
  picture.addEventListener("pointercancel", lift);
  map.addEventListener("wheel", (event) => {
    if ((!event.ctrlKey && !event.metaKey) || !isMap()) return;
    event.preventDefault();
    app.explorer.zoom(Math.exp(Math.max(-1, Math.min(1, event.deltaY / 200))), ...place(event));
    app.changed();
  }, { passive: false });
  const button = (id, action) => byId(id).addEventListener("click", () => {
    action();
    app.changed();
  });
  button("closer", () => app.explorer.zoom(0.7));
  button("farther", () => app.explorer.zoom(1 / 0.7));
  button("reset", () => app.explorer.reset_view());

  app.plateSize = () => kept(app, map, () => {
    // Where it is not seen it still has a size.
    const pixels = map.clientWidth || 560;
    // On a large screen the drawing is enlarged, on a small one laid out anew.
    const enlarged = pixels > 900 ? pixels / 900 : 1;
    return { scale: enlarged, width: pixels / enlarged, height: Math.max(app.story ? 200 : 236, room(app, map, pixels, 0.64, 0.52)) / enlarged, shown: map.clientWidth };
  });
  return (said) => {
    app.shownPlate = said.plates.includes(app.plate) ? app.plate : said.plates[0] ?? "";
    for (const one of buttons) {
      one.hidden = !said.plates.includes(one.dataset.plate);
      one.setAttribute("aria-pressed", String(one.dataset.plate === app.shownPlate));
    }
    put(byId("plane-title"), TITLES[app.shownPlate] ?? "No plane");
    put(byId("no-plate"), app.shownPlate ? "" : "No load varies, and all loads together have no point in the report’s plane.");
    document.querySelector(".zoom").hidden = !isMap();
    map.classList.toggle("free", app.shownPlate !== "time");
    const size = app.plateSize();
    // A plane of the load holds while its point is dragged: its regions do not hang on where the point is. Histories wait for the end.
    const waits = app.held && !isMap() && drawn === app.shownPlate;
    if (!waits) {
      picture.style.height = "";
      redraw(picture, app.shownPlate ? app.explorer.plate(app.shownPlate, size.width, size.height) : "");
      drawn = app.shownPlate;
      const svg = picture.querySelector("svg");
      const own = Number(svg?.getAttribute("width") ?? size.width);
      // What is too wide is made smaller as a whole, and the point with it.
      scale = svg ? Math.min(size.scale, (size.shown || own) / own) : 1;
      if (svg) svg.style.width = `${own * scale}px`;
      app.plateScale = scale;
      // The words below a plane of the load stand in the answer already.
      const bottom = app.explorer.plate_bottom();
      if (bottom > 0) picture.style.height = `${bottom * scale}px`;
    }
    const [x, y, shown, sideways, up] = app.explorer.point();
    point.hidden = x === undefined || (!sideways && !up);
    if (!point.hidden) {
      point.style.translate = `${x * scale}px ${y * scale}px`;
      point.classList.toggle("outside", shown === 0);
      point.setAttribute("aria-label", `Design point, at ${sideways ? "its force and friction" : "its friction"}${shown ? "" : ", outside the view"}`);
    }
    put(byId("point-help"), point.hidden ? (app.shownPlate === "time" ? "pull the line" : "") : sideways && up ? "drag the diamond, or use arrow keys" : up ? "drag the diamond up or down: friction" : "drag the diamond to the side");
  };
}
