// The left plate: the body to scale, on which numbers are fields and forces have rings to drag; or what begins, exaggerated.

import { byId, element, put, symbolOf, whenChanged } from "dom";
import { dragged } from "dragged";
import { numberField, byKey } from "number";
import { redraw } from "redraw";
import { isAlone, kept, room } from "room";

const stills = matchMedia("(prefers-reduced-motion: reduce)");
/** Numbers that stand beside the drawing, where the case has them. */
const LOOSE = [/^block\.(b1|b2|d|mu_s)$/, /^body\.(mass|density|friction|buoyant_weight)$/, /^load\[\d+\]\.elevation$/, /^wave\.(deep_water_height|Hmax|period)$/, /^earthquake\.(horizontal|vertical)$/, /^motion\.base\.(horizontal|vertical)\.(peak|target_peak|factor)$/, /^ground\.(strength|friction_angle_deg)$/, /^water\.(level|left|right)$/];
const MOST = 7;
/** Keys of the sides of the body. */
const SIDE = /^body\.(width|height)$/;
/** Between a number and what it stands beside, and half the width of a ring, pixels. */
const GAP = 6;
const RING = 8;

export function connectSection(app) {
  const place = byId("section");
  const picture = place.querySelector(".picture");
  const over = place.querySelector(".over");
  const body = byId("body");
  const play = byId("play");
  const fields = new Map();
  const rings = new Map();
  // What is shown: the section to scale, what begins, or the body in motion; of a case in time the last unless another is chosen.
  let view = "";
  let running = !stills.matches;
  // Pressures stand along their faces, or each as one arrow; until a person chooses, as leaves the body room.
  let summed = null;
  let animation = null;
  let settle = 0;
  let scale = 1;

  // What begins.
  const bodySize = () => kept(app, body, () => {
    const width = Math.max(260, Math.min(760, place.parentElement.clientWidth));
    return [width, Math.max(app.story ? 180 : 230, isAlone(app) ? room(app, place, width) : Math.min(420, width * 0.62))];
  });
  const sectionSize = () => kept(app, place, () => {
    const width = Math.max(280, place.parentElement.clientWidth);
    return [width, Math.max(app.story ? 180 : 240, room(app, place, width, 0.65, 0.52))];
  });
  const animate = () => {
    animation?.cancel();
    animation = null;
    const drawing = body.querySelector(".body");
    const [x, y, shift, turn] = app.explorer.pose(...bodySize());
    if (!drawing || !running || body.hidden || (shift === 0 && turn === 0)) return;
    drawing.style.transformOrigin = `${x}px ${y}px`;
    const end = { translate: `${shift}px 0px`, rotate: `${turn}deg` };
    // From rest at constant acceleration: this easing is the square of the time.
    const from = { translate: "0px 0px", rotate: "0deg", easing: "cubic-bezier(0.3333, 0, 0.6667, 0.3333)" };
    animation = drawing.animate([from, { ...end, offset: 0.62 }, { ...end, offset: 1 }], { duration: 2400, iterations: Infinity });
  };
  play.addEventListener("click", () => {
    running = !running;
    animate();
    app.changed();
  });
  stills.addEventListener("change", () => {
    running = !stills.matches;
    animate();
    app.changed();
  });
  const choose = (chosen) => () => {
    view = chosen;
    app.changed();
  };
  /** Shows a drawing of the body; without a name the one that comes first. */
  app.showBody = (which = "") => choose(which)();
  byId("begins").addEventListener("click", choose("begins"));
  byId("to-scale").addEventListener("click", choose("to-scale"));
  byId("moves").addEventListener("click", choose("moves"));
  const choosePressures = (chosen) => () => {
    summed = chosen;
    app.changed();
  };
  byId("pressures-along").addEventListener("click", choosePressures(false));
  byId("pressures-summed").addEventListener("click", choosePressures(true));
  const drawBody = whenChanged(() => {
    animation?.cancel();
    body.innerHTML = app.explorer.free_body(...bodySize());
    // While something is dragged the body stands still.
    clearTimeout(settle);
    settle = setTimeout(animate, 250);
  });

  const boxOf = () => {
    const { left, top } = picture.querySelector("svg").getBoundingClientRect();
    return { left, top };
  };
  let held = null;
  // Lengths of a side at which the answer changes: of which side, of which case, and those that are known.
  let notches = null;
  let corner = [0, 0];
  /** Notches take longer than a picture: they are looked for as soon as a hand comes to the side. */
  const lookForNotches = async (key) => {
    const of = `${app.explorer.answers()} ${key}`;
    if (notches?.of === of) return;
    const mine = (notches = { of, key, all: null });
    mine.all = await app.askOnce(`notches ${key}`).catch(() => []);
    if (notches === mine && app.held) app.changed();
  };
  const ring = (key) => {
    const handle = element("button", { type: "button", className: "ring" });
    handle.dataset.key = key;
    const at = (event) => [(event.clientX - held.left) / scale, (event.clientY - held.top) / scale];
    // What is held is measured in the drawing as it was, and a body whose side is held keeps its lower left corner.
    const gripped = () => (held = { ...boxOf(), corner, key });
    if (SIDE.test(key)) {
      handle.addEventListener("pointerenter", () => app.held || lookForNotches(key));
      dragged(app, handle, gripped, (event) => {
        lookForNotches(key);
        const [x, y] = at(event);
        return () => {
          app.explorer.set_notches(JSON.stringify(notches.all ?? []));
          app.explorer.drag_side(key, x, y, event.altKey);
        };
      });
      handle.addEventListener("keydown", (event) => {
        const way = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
        if (!way || event.ctrlKey || event.metaKey) return;
        event.preventDefault();
        app.explorer.step_side(key, way * (event.shiftKey ? 10 : 1), event.altKey);
        app.changed();
      });
      return handle;
    }
    dragged(app, handle, gripped, (event) => {
      const [x, y] = at(event);
      return () => app.explorer.drag_force(key, x, y);
    });
    handle.addEventListener("keydown", (event) => {
      const step = { ArrowRight: [key, 1], ArrowLeft: [key, -1], ArrowUp: [key.replace(/force$/, "elevation"), 1], ArrowDown: [key.replace(/force$/, "elevation"), -1] }[event.key];
      if (!step || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      app.explorer.step(step[0], step[1] * (event.shiftKey ? 10 : 1));
      app.changed();
    });
    return handle;
  };

  const field = (key) => {
    if (!fields.has(key)) fields.set(key, numberField(app, key));
    return fields.get(key);
  };
  const drawLegend = whenChanged((words) => byId("legend").replaceChildren(...words.map((line) => element("li", {}, line))));
  let name = "";

  const layOut = (drawing, numbers) => {
    const [width, height] = drawing.size;
    const svg = picture.querySelector("svg");
    if (!app.held) held = null;
    if (held && svg) {
      // What is held stays as large as it was.
      Object.assign(svg.style, { width: `${width * scale}px`, maxWidth: "none" });
    } else {
      Object.assign(svg?.style ?? {}, { width: "", maxWidth: "" });
      scale = svg && width > 0 ? svg.getBoundingClientRect().width / width : 1;
    }
    over.style.width = `${width * scale}px`;
    over.style.height = `${height * scale}px`;
    picture.style.translate = over.style.translate = "";
    const placed = new Map();
    for (const { key, x, y } of drawing.numbers) if (!placed.has(key) && numbers.has(key)) placed.set(key, [x, y]);
    const boxes = [...placed.keys()].map((key) => [key, field(key)]);
    for (const [key, { box, show }] of boxes) {
      show(numbers.get(key));
      if (box.parentElement !== over) over.append(box);
    }
    // All that is measured is measured before anything is placed: the page is laid out once.
    const sizes = boxes.map(([, { box }]) => [box.offsetWidth / 2, box.offsetHeight / 2]);
    const slack = Math.max(0, (place.clientWidth - width * scale) / 2) + GAP;
    const at = held ? boxOf() : null;
    // What stands beside the body does not reach over it, nor the number of a force over its ring; on either side the plate has some room.
    const [left, , right, base] = drawing.body.map((side) => side * scale);
    const ringAt = new Map(drawing.forces.map(({ key, x }) => [key, x * scale]));
    boxes.forEach(([key, { box }], i) => {
      const [x, y] = placed.get(key);
      const [half, halfHeight] = sizes[i];
      const toLeft = Math.min(left - GAP, ringAt.get(key) - RING || left) - half;
      const toRight = Math.max(right + GAP, ringAt.get(key) + RING || right) + half;
      const across = x * scale;
      const free = y * scale > base ? across : across < left ? Math.min(across, toLeft) : across > right ? Math.max(across, toRight) : across;
      const inside = Math.min(Math.max(free, half - slack), width * scale + slack - half);
      // Where the plate ends too near, the number stands below its ring.
      const covered = ringAt.has(key) && Math.abs(inside - ringAt.get(key)) < half + RING;
      box.style.left = `${inside}px`;
      box.style.top = `${y * scale + (covered ? RING + GAP + halfHeight : 0)}px`;
    });
    const handles = new Map([...drawing.forces, ...drawing.sides].filter(({ key }) => numbers.has(key)).map((one) => [one.key, one]));
    for (const [key, { x, y, words }] of handles) {
      if (!rings.has(key)) rings.set(key, ring(key));
      const handle = rings.get(key);
      if (handle.parentElement !== over) over.append(handle);
      const does = SIDE.test(key) ? "drag it, or use arrow keys; the density stays, with Alt the mass" : "drag along it for its size, across for its level; arrow keys change them";
      const said = `${words}, ${key}: ${does}`;
      if (handle.ariaLabel !== said) Object.assign(handle, { title: SIDE.test(key) ? "The density stays; with Alt the mass" : "", ariaLabel: said });
      handle.style.left = `${x * scale}px`;
      handle.style.top = `${y * scale}px`;
    }
    for (const [key, handle] of rings) if (!handles.has(key)) handle.remove();
    over.querySelectorAll(".notch").forEach((notch) => notch.remove());
    const line = notches && held?.key === notches.key && handles.get(notches.key);
    for (const { length, label } of (line && notches.all) || []) {
      const [wide, along] = [/width$/.test(notches.key), length * drawing.scale];
      const at = wide ? [left + along * scale, line.y * scale] : [line.x * scale, (drawing.body[3] - along) * scale];
      const notch = element("span", { className: wide ? "notch" : "notch upright" }, label);
      Object.assign(notch.style, { left: `${at[0]}px`, top: `${at[1]}px` });
      over.append(notch);
    }
    corner = [left, drawing.body[3] * scale];
    if (at) picture.style.translate = over.style.translate = `${held.left + held.corner[0] - corner[0] - at.left}px ${held.top + held.corner[1] - corner[1] - at.top}px`;
    return placed;
  };
  const loose = (placed, numbers) => {
    const free = [...numbers.keys()].filter((key) => !placed.has(key));
    // Of a step of a story those that it holds are left.
    const keys = app.story?.hold ? free : LOOSE.flatMap((pattern) => free.filter((key) => pattern.test(key))).slice(0, MOST);
    for (const key of keys) {
      const { box, show } = field(key);
      const number = numbers.get(key);
      show(number);
      if (box.parentElement?.parentElement !== byId("loose")) {
        // It may come from the drawing.
        Object.assign(box.style, { left: "", top: "" });
        const words = element("label", { className: "hint", htmlFor: box.querySelector("input").id }, `${number.label} `);
        if (number.symbol) words.append(symbolOf(number.symbol));
        byId("loose").append(element("span", { className: "number" }, words, box));
      }
    }
    for (const [key, { box }] of fields) {
      if (keys.includes(key) || placed.has(key)) continue;
      const around = box.parentElement?.parentElement === byId("loose") ? box.parentElement : box;
      around.remove();
    }
    for (const around of [...byId("loose").children]) if (!around.querySelector("input")) around.remove();
  };

  return (said) => {
    // Another case is another drawing; what was typed for the last is gone.
    if (name !== `${said.name} ${said.title}`) fields.forEach(({ reset }) => reset());
    name = `${said.name} ${said.title}`;
    const has = { moves: said.in_time, "to-scale": true, begins: said.point !== null };
    const shown = has[view] ? view : said.in_time ? "moves" : "to-scale";
    const only = Object.values(has).filter(Boolean).length === 1;
    for (const [id, exists] of Object.entries(has)) {
      byId(id).hidden = !exists || only;
      byId(id).setAttribute("aria-pressed", String(id === shown));
    }
    const begins = shown === "begins";
    place.hidden = shown !== "to-scale";
    body.hidden = !begins;
    byId("stage").hidden = shown !== "moves";
    play.hidden = !begins || said.mode === "RE";
    play.textContent = running ? "Pause" : "Play";
    play.setAttribute("aria-pressed", String(running));
    const numbers = byKey(said);
    // A step of a story says which numbers may be changed in it.
    if (app.story?.hold) for (const key of numbers.keys()) if (!app.story.hold.includes(key)) numbers.delete(key);
    if (shown !== "to-scale") document.querySelector(".legend").hidden = byId("sums").hidden = true;
    if (shown === "moves") {
      loose(new Map(), numbers);
      return;
    }
    if (begins) {
      drawBody([said.point, said.mode, bodySize()]);
      put(byId("body-hint"), said.mode === "RE" ? "to scale, at rest" : "the motion is exaggerated; dashed: accelerations of the corners");
      loose(new Map(), numbers);
      return;
    }
    const drawing = JSON.parse(app.explorer.section(...sectionSize(), summed));
    redraw(picture, drawing.svg);
    put(byId("body-hint"), drawing.body.some((side) => side !== 0) ? "type over a number, pull a ring" : "its positions: a body in pure numbers has no section");
    document.querySelector(".legend").hidden = drawing.words.length === 0;
    byId("sums").hidden = drawing.summed === null;
    byId("pressures-along").setAttribute("aria-pressed", String(!drawing.summed));
    byId("pressures-summed").setAttribute("aria-pressed", String(drawing.summed));
    const placed = layOut(drawing, numbers);
    loose(placed, numbers);
    drawLegend(drawing.words);
  };
}
