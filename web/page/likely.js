// How likely each outcome is: the laws of the random numbers as fields, and the answer of the second thread, part by part as it comes.

import { byId, element, put, whenChanged } from "dom";
import { numberField } from "number";
import { redraw } from "redraw";

/** What is known so far of a case with random numbers: the last probabilities, the draws, what went wrong, and whether that is all. */
export function likelihood(app, said) {
  if (!said.standing) return null;
  const { parts, done, fault } = app.asked("likely");
  const last = (kind) => parts.findLast((part) => part[kind] !== undefined)?.[kind];
  return { chances: last("chances"), draws: last("draws"), fault: last("fault") ?? fault, done };
}

export function connectLikely(app) {
  const fields = new Map();
  const fault = byId("spread-fault");
  const say = (words) => {
    fault.replaceChildren(words ?? "");
    app.changed();
  };
  byId("propose").addEventListener("click", () => say(app.explorer.take_proposed()));
  const row = ({ key, name, words, laws }) => {
    const law = element("select", {}, ...laws.map((one) => new Option(one)));
    law.setAttribute("aria-label", `Law of ${words}`);
    law.addEventListener("change", () => say(app.explorer.set_law(name, law.value)));
    const field = numberField(app, key);
    const sign = element("span", { className: "hint" }, "±");
    const [of, says] = [element("small", {}), element("small", {})];
    fields.set(key, { law, field, sign, of, says });
    return element("div", { className: "spread" }, element("span", {}, words, of), law, element("span", { className: "deviation" }, sign, field.box), says);
  };
  const build = whenChanged((rows) => {
    fields.clear();
    byId("spreads").replaceChildren(...rows.map(row));
  });
  const spreads = ({ rows, words, can_take }) => {
    build(rows.map(({ key, name, words: label, laws }) => ({ key, name, words: label, laws })));
    for (const { key, words: label, law: now, digits, unit, units, of, proposed, says } of rows) {
      const { law, field, sign, of: beside, says: below } = fields.get(key);
      law.value = now;
      sign.hidden = field.box.hidden = digits === "";
      field.show({ digits, unit, units, words: `${label}, standard deviation` });
      put(beside, of);
      put(below, proposed && `proposed: ${proposed}. ${says}`);
    }
    put(byId("spread-words"), words);
    byId("propose").hidden = !can_take;
  };

  const cell = (text, below) => element("td", { className: "number-cell" }, text, ...(below ? [element("small", {}, below)] : []));
  const chanceRow = ({ words, symbol, tint, share, value, within }) => {
    const bar = element("i", {});
    bar.style.width = `${100 * share}%`;
    if (tint) bar.style.background = tint;
    const strip = element("span", { className: "chance" }, bar);
    strip.setAttribute("aria-hidden", "true");
    return element("tr", {}, element("td", {}, words, " ", element("span", { className: "hint" }, symbol.replace("'", "′").replace("-", "−"))), element("td", { className: "strip" }, strip), cell(value, within));
  };
  const part = (id, isThere) => (byId(id).hidden = !isThere);
  const numbers = whenChanged((chances) => {
    const { groups, slides, known, matters, how, text } = chances ?? { groups: [], slides: [], known: [], matters: [], how: [], text: "" };
    const head = (words) => element("tr", {}, element("th", { colSpan: 3, className: "hint", scope: "colgroup" }, words));
    byId("chances").tBodies[0].replaceChildren(...groups.flatMap(([words, rows]) => [head(words), ...rows.map(chanceRow)]));
    byId("slides").tBodies[0].replaceChildren(...slides.map(([words, value, within]) => element("tr", {}, element("td", {}, words), cell(value, within))));
    byId("known").tBodies[0].replaceChildren(...known.map(([words, value]) => element("tr", {}, element("td", {}, words), cell(value))));
    byId("matters").replaceChildren(...matters.map((sentence) => element("p", { className: "hint" }, sentence)));
    byId("how").replaceChildren(...how.map((sentence) => element("p", {}, sentence)));
    put(byId("chance-text"), text);
    part("chances-part", groups.length > 0);
    part("slides-part", slides.length > 0);
    part("known-part", matters.length > 0);
    part("how-part", how.length > 0);
  });
  const figures = whenChanged((list) => {
    // Drawn by the library.
    byId("chance-figures").replaceChildren(...list.flatMap(([name, svg]) => {
      const place = element("div", { className: "scroll picture", innerHTML: svg, tabIndex: 0 });
      place.setAttribute("role", "region");
      place.setAttribute("aria-label", name);
      return [element("h3", {}, name), place];
    }));
    part("figures-part", list.length > 0);
  });

  const over = byId("draws-over");
  let name = "";
  return (said) => {
    const known = likelihood(app, said);
    const inPlane = known?.draws?.in_plane ?? [];
    redraw(over, inPlane.length > 0 && !app.held && app.shownPlate === "k-mu" ? app.explorer.draws_over(new Float64Array(inPlane.flat())) : "");
    const svg = over.querySelector("svg");
    if (svg) svg.style.width = `${Number(svg.getAttribute("width")) * app.plateScale}px`;
    if (name !== `${said.name} ${said.title}`) {
      fields.forEach(({ field }) => field.reset());
      fault.replaceChildren();
    }
    name = `${said.name} ${said.title}`;
    if (app.tab !== "likely") return;
    spreads(JSON.parse(app.explorer.spreads()));
    numbers(known?.chances ?? null);
    figures(known?.draws?.figures ?? []);
    put(byId("draws-words"), known?.draws?.words ?? "");
    put(byId("likely-fault"), known?.fault ?? "");
    put(byId("likely-state"), !known || known.done ? "" : known.chances ? "A first answer: it becomes finer." : "The answer comes.");
  };
}
