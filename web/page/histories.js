// How loads and the base go with time: shapes from a menu, written into the text; their numbers are then fields of the form.

import { byId, element, whenChanged } from "dom";

export function connectHistories(app) {
  const selects = new Map();
  const fault = element("p", { id: "histories-fault", className: "bad" });
  fault.setAttribute("role", "alert");
  const row = ({ key, words, shapes, still }) => {
    const select = element("select", {}, ...(still ? [new Option("stays as it is", "")] : []), ...shapes.map((shape) => new Option(shape)));
    select.addEventListener("change", () => {
      fault.replaceChildren(app.explorer.set_history(key, select.value) ?? "");
      app.changed();
    });
    select.id = `history-${key}`;
    selects.set(key, select);
    return element("div", { className: "row" }, element("label", { htmlFor: select.id }, words), select);
  };
  const build = whenChanged((rows) => {
    selects.clear();
    const all = rows.length > 0 ? [element("section", {}, element("h3", {}, "With time"), ...rows.map(row), fault)] : [];
    byId("histories").replaceChildren(...all);
  });
  return () => {
    if (app.tab !== "inputs") return;
    const rows = JSON.parse(app.explorer.courses());
    build(rows.map(({ key, words, shape, shapes }) => ({ key, words, shapes, still: shape === "" })));
    for (const { key, shape } of rows) selects.get(key).value = shape;
  };
}
