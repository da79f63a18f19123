// The γ–k′ map of the report's cases.

import { drawingSize } from "map";

const ARROWS = { ArrowLeft: ["slenderness", -1], ArrowRight: ["slenderness", 1], ArrowDown: ["elevation", -1], ArrowUp: ["elevation", 1] };
const STEP = 0.01;

export function connectCases(app) {
  const cases = document.getElementById("cases");
  const picture = cases.querySelector(".picture");
  const point = document.getElementById("case-point");
  const note = document.getElementById("cases-note");
  let scale = 1;
  let drawn = "";
  const pick = (event) => {
    const box = picture.getBoundingClientRect();
    app.explorer.pick_case((event.clientX - box.left) / scale, (event.clientY - box.top) / scale);
    app.changed();
  };
  for (const element of [picture, point]) {
    let down = false;
    element.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      down = true;
      element.setPointerCapture(event.pointerId);
      if (element === picture) pick(event);
    });
    element.addEventListener("pointermove", (event) => down && pick(event));
    for (const end of ["pointerup", "pointercancel"]) element.addEventListener(end, () => (down = false));
  }
  point.addEventListener("keydown", (event) => {
    const arrow = ARROWS[event.key];
    if (!arrow || event.ctrlKey || event.metaKey || event.altKey) return;
    const share = app.reading.sliders.find(([name]) => name === arrow[0])[1];
    app.explorer.slide(arrow[0], share + arrow[1] * STEP);
    event.preventDefault();
    app.changed();
  });
  return (reading) => {
    const pixels = cases.clientWidth;
    scale = drawingSize(pixels, 0).scale * (pixels > 500 ? pixels / 500 : 1);
    const [width, height] = [pixels / scale, Math.min(290, (pixels / scale) * 0.78)];
    const [gamma, kPrime] = reading.numbers.given;
    const key = `${width} ${height} ${gamma} ${kPrime} ${reading.numbers.all_loads} ${reading.with_water}`;
    if (key === drawn) return;
    drawn = key;
    picture.innerHTML = app.explorer.cases(width, height);
    const [x, y] = app.explorer.point_in_cases();
    point.style.translate = `${x * scale}px ${y * scale}px`;
    point.setAttribute("aria-label", `Body: slenderness γ ${gamma}, elevation k′ ${kPrime}${reading.with_water ? " of the force alone" : ""}`);
    const all = reading.numbers.all_loads ? `; all loads together have k′ = ${Number(reading.numbers.all_loads[1].toPrecision(4))}` : "";
    note.textContent = reading.with_water ? ` The mark is the body under the force alone, without water and uplift${all}.` : "";
  };
}
