// Why: criteria, sentences on the full load, inequalities, the load as it grows, warnings; and the whole answer.

import { byId, element, put, whenChanged } from "dom";
import { refill } from "redraw";

const rows = (id, list) => refill(byId(id).tBodies[0], list.map((cells) => element("tr", {}, ...cells)));
const cell = (text, className = "") => element("td", { className }, text);
/** A cell of the library's own mathematics, never of a person's text. */
const formula = (html) => Object.assign(element("td", {}), { innerHTML: html });

export function connectWhy(app) {
  const checks = whenChanged((list) => rows("checks", list.map(({ name, words, required, value, met, met_words: met_or_not, place }) => {
    const what = element("td", {}, name, element("small", {}, place ? `${words}; in ${place}` : words));
    return [what, cell(value, "number-cell"), cell(required, "number-cell"), cell(met_or_not, met ? "number-cell" : "number-cell bad")];
  })));
  const sentences = whenChanged((list) => refill(byId("sentences"), list.map((sentence) => element("p", {}, sentence))));
  const because = whenChanged((list) => rows("because", list.map(([equation, statement, values]) => [cell(`(${equation})`), formula(statement), formula(values)])));
  const stages = whenChanged((list) => rows("stages", list.map(([share, words]) => [cell(share, "number-cell"), cell(words)])));
  const warnings = whenChanged((list) => refill(byId("warning-list"), list.flatMap(([name, message]) => [element("dt", {}, name), element("dd", {}, message)])));
  return (said) => {
    if (app.tab === "whole") put(byId("whole"), app.explorer.report());
    if (app.tab !== "why" && !app.printing) return;
    put(byId("sentences-title"), !said.in_time ? "Under the full load" : said.stages.length > 0 || said.because.length > 0 ? "At the first instant" : "The motion");
    checks(said.checks);
    sentences(said.sentences);
    because(said.because);
    stages(said.stages);
    warnings(said.warnings);
  };
}
