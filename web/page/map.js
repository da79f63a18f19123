// The k–μ diagram: drawing, the design point, moving about.

const STEP = 0.01;
const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };

/** Width and height of the drawing in its own units, and how many pixels a unit has. */
export function drawingSize(pixels, tallest) {
  const scale = pixels > 900 ? pixels / 900 : pixels < 480 ? 0.94 : 1;
  const height = Math.min(Math.max(pixels * 0.64, 330), Math.max(tallest, 330));
  return { width: pixels / scale, height: height / scale, scale };
}

export function connectMap(app) {
  const map = document.getElementById("map");
  const picture = map.querySelector(".picture");
  const point = document.getElementById("point");
  const hint = document.getElementById("point-help").parentElement;
  let size = drawingSize(800, 600);
  const place = (event) => {
    const box = picture.getBoundingClientRect();
    return [(event.clientX - box.left) / size.scale, (event.clientY - box.top) / size.scale];
  };

  // The point: dragged, or moved by keys.
  let wasFree = false;
  let dragging = false;
  const grab = (event, element) => {
    element.setPointerCapture(event.pointerId);
    wasFree = app.explorer.hold_view();
    dragging = true;
  };
  const drag = (event) => {
    app.explorer.move_point(...place(event));
    app.changed();
  };
  const drop = () => {
    if (dragging && wasFree) app.explorer.reset_view();
    dragging = false;
    app.changed();
  };
  point.addEventListener("pointerdown", (event) => {
    if (event.button === 0) grab(event, point);
  });
  point.addEventListener("pointermove", (event) => dragging && drag(event));
  point.addEventListener("pointerup", drop);
  point.addEventListener("pointercancel", drop);

  point.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (arrow && event.shiftKey) {
      app.explorer.pan(-arrow[0] * 40, arrow[1] * 40);
    } else if (arrow) {
      app.explorer.nudge_point(arrow[0] * STEP, arrow[1] * STEP);
    } else if (event.key === "+" || event.key === "=") {
      app.explorer.zoom(0.8);
    } else if (event.key === "-" || event.key === "−") {
      app.explorer.zoom(1.25);
    } else if (event.key === "0") {
      app.explorer.reset_view();
    } else {
      return;
    }
    event.preventDefault();
    app.changed();
  });

  // The background: a click places the point, a drag moves the view, two fingers zoom.
  const fingers = new Map();
  let travelled = 0;
  const span = () => {
    const [one, two] = [...fingers.values()];
    return { far: Math.hypot(one[0] - two[0], one[1] - two[1]), x: (one[0] + two[0]) / 2, y: (one[1] + two[1]) / 2 };
  };
  picture.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
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
    if (fingers.delete(event.pointerId) && travelled <= 4 && event.type === "pointerup") {
      const free = app.explorer.hold_view();
      app.explorer.move_point(...place(event));
      if (free) app.explorer.reset_view();
      point.focus({ preventScroll: true });
      app.changed();
    }
    map.classList.remove("moving");
  };
  picture.addEventListener("pointerup", lift);
  picture.addEventListener("pointercancel", lift);
  map.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && !event.metaKey) return;
    event.preventDefault();
    app.explorer.zoom(Math.exp(Math.max(-1, Math.min(1, event.deltaY / 200))), ...place(event));
    app.changed();
  }, { passive: false });

  const button = (id, action) =>
    document.getElementById(id).addEventListener("click", () => {
      action();
      app.changed();
    });
  button("closer", () => app.explorer.zoom(0.7));
  button("farther", () => app.explorer.zoom(1 / 0.7));
  button("reset", () => app.explorer.reset_view());

  app.mapSize = () => size;
  return (reading) => {
    size = drawingSize(map.clientWidth, innerHeight * 0.66);
    picture.innerHTML = app.explorer.map(size.width, size.height);
    const [x, y, shown] = app.explorer.point_in_map();
    point.hidden = x === undefined;
    if (x !== undefined) {
      point.style.translate = `${x * size.scale}px ${y * size.scale}px`;
      point.classList.toggle("outside", shown === 0);
      const [, , k, mu] = reading.numbers.all_loads;
      const loads = reading.with_water ? " of all loads" : "";
      const where = shown ? "" : ", outside the view";
      point.setAttribute("aria-label", `Design point: k${loads} ${Number(k.toPrecision(7))}, μ ${mu}${where}`);
    }
    hint.hidden = !reading.is_drawn;
    for (const id of ["closer", "farther", "reset"]) document.getElementById(id).disabled = !reading.is_map;
  };
}
