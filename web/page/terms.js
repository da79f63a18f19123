// The case in the report's terms: its four numbers, the map of cases, and the report's 26 figures.

import { Explorer } from "library";
import { byId, element, put, whenChanged } from "dom";

const CHAPTERS = { 2: "Chapter II", 3: "Chapter III: force above the centre", 4: "Chapter IV: force below the centre" };
const NUMBERS = [["γ", "slenderness, height over width"], ["k′", "elevation of the force above the centre of mass, in half heights"], ["k", "force over weight"], ["μ", "friction"]];

export function connectTerms(app) {
  const select = byId("figure");
  for (const [chapter, name] of Object.entries(CHAPTERS)) {
    const figures = JSON.parse(Explorer.figure_list()).filter(([number]) => number.startsWith(`${chapter}.`));
    const options = figures.map(([number, caption]) => new Option(`Fig. ${number} ${caption}`, number));
    select.append(element("optgroup", { label: name }, ...options));
  }
  const show = (index) => {
    select.selectedIndex = (index + select.options.length) % select.options.length;
    app.changed();
  };
  select.addEventListener("change", () => show(select.selectedIndex));
  byId("previous").addEventListener("click", () => show(select.selectedIndex - 1));
  byId("next").addEventListener("click", () => show(select.selectedIndex + 1));
  const figure = whenChanged((number) => (byId("figure-picture").innerHTML = Explorer.report_figure(number)));
  const spot = document.querySelector("#cases .spot");
  const cases = whenChanged(([, width]) => {
    const drawn = JSON.parse(app.explorer.cases(width, Math.min(340, 0.75 * width)));
    byId("cases").hidden = !drawn;
    if (!drawn) return;
    const [svg, [x, y]] = drawn;
    byId("cases").querySelector(".picture").innerHTML = svg;
    spot.style.translate = `${x}px ${y}px`;
  });
  const numbers = whenChanged((point) => byId("numbers").tBodies[0].replaceChildren(...(point ?? []).map((value, i) => element("tr", {},
    element("td", {}, element("i", {}, NUMBERS[i][0])), element("td", {}, NUMBERS[i][1]), element("td", { className: "number-cell" }, String(Number(value.toPrecision(7))).replace("-", "−"))))));
  return (said) => {
    if (app.tab !== "terms") return;
    numbers(said.point);
    put(byId("no-point"), said.point ? "Of all loads together, water and uplift included." : "All loads together are no point of the report’s plane.");
    cases([said.point, Math.min(480, byId("panel-terms").clientWidth - 30)]);
    figure(select.value);
  };
}
