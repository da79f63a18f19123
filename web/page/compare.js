// Compare: the case of a moment is pinned as A; what is in the hand from then on is B. The tab that has both in a table.

import { byId, element, whenChanged } from "dom";

/** A text of more letters goes on in the next line. */
const LONG = 12;

const rows = (id, list) => byId(id).tBodies[0].replaceChildren(...list.map(({ words, name, cells, bad }) => element("tr", {},
  element("th", { scope: "row" }, words, ...(name ? [element("small", {}, name)] : [])),
  ...cells.map((cell, i) => element("td", { className: `${bad[i] ? "bad" : ""} ${cell.length > LONG ? "long" : ""}`.trim() }, cell)))));

export function connectCompare(app) {
  const button = byId("compare");
  // A narrow head has no room for it.
  const narrow = matchMedia("(max-width: 46rem)");
  const move = () => (narrow.matches ? byId("more-menu").querySelector(".sheet").prepend(button) : byId("redo").after(button));
  narrow.addEventListener("change", move);
  move();
  let before = "why";
  const drop = () => {
    app.explorer.drop_pinned();
    if (app.tab === "compare") app.showTab(before);
    app.changed();
  };
  button.addEventListener("click", () => {
    app.settleText();
    if (app.said.compared) {
      drop();
      return;
    }
    app.explorer.pin();
    before = app.tab;
    app.showTab("compare");
    app.changed();
  });
  byId("drop-pinned").addEventListener("click", () => {
    drop();
    button.focus();
  });
  byId("swap").addEventListener("click", () => {
    app.settleText();
    app.explorer.swap();
    app.changed();
  });
  const inputs = whenChanged((list) => rows("compare-inputs", list));
  const answers = whenChanged((list) => rows("compare-answers", list));
  return ({ compared }) => {
    button.setAttribute("aria-pressed", String(compared !== null));
    document.documentElement.classList.toggle("compares", compared !== null);
    if (!compared) return;
    byId("swap").disabled = !compared.can_swap;
    byId("compare-same").hidden = compared.inputs.length > 0;
    byId("compare-inputs-part").hidden = compared.inputs.length === 0;
    inputs(compared.inputs);
    answers(compared.answers);
  };
}
