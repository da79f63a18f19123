// All numbers of the case as a form, table by table.

import { byId, element, symbolOf, whenChanged } from "dom";
import { numberField, byKey } from "number";

export function connectForm(app) {
  const form = byId("form");
  const fields = new Map();
  let name = "";
  const build = whenChanged((tables) => {
    fields.clear();
    form.replaceChildren(...tables.map(([header, words, numbers]) => element("section", {},
      element("h3", {}, header ? `[${header}] ${words}` : "Above all tables"),
      ...numbers.map(([key, label, symbol]) => {
        const field = numberField(app, key);
        fields.set(key, field);
        const text = element("label", { htmlFor: field.input.id }, `${label} `);
        if (symbol) text.append(symbolOf(symbol));
        return element("div", { className: "row" }, text, field.box);
      }))));
  });
  return (said) => {
    if (name !== `${said.name} ${said.title}`) fields.forEach(({ reset }) => reset());
    name = `${said.name} ${said.title}`;
    if (app.tab !== "inputs" && !app.printing) return;
    build(said.tables.map(({ header, words, numbers }) => [header, words, numbers.map(({ key, words: label, symbol }) => [key, label, symbol])]));
    const numbers = byKey(said);
    for (const [key, field] of fields) if (numbers.has(key)) field.show(numbers.get(key));
  };
}
