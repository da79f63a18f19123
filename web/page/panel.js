// The answer in words and tables. The explorer's strings are HTML made of its own words only, never of a person's input.

const shown = new Map();
const html = (id, content) => {
  // What has not changed is left as it is: for speed, and for readers who are in the middle of it.
  if (shown.get(id) === content) return;
  shown.set(id, content);
  const element = document.getElementById(id);
  (element.tBodies?.[0] ?? element).innerHTML = content;
};
const rows = (id, list) => html(id, list.map((cells) => `<tr>${cells.join("")}</tr>`).join(""));
const cell = (content, kind = "") => `<td class="${kind}">${content}</td>`;

export function connectPanel() {
  let timer = 0;
  const live = document.getElementById("live");
  const symbol = document.getElementById("symbol");
  const relation = ({ equation, statement, values, margin }) => [
    cell(`(${equation})`, "equation"),
    cell(`${statement}<br><span class="quiet">${values}</span>`),
    cell(`by ${margin}`, "number"),
  ];
  return (reading) => {
    symbol.style.setProperty("--tint", reading.tint);
    symbol.dataset.mode = reading.mode;
    html("symbol", reading.symbol);
    html("sentence", reading.sentence);
    html("uniqueness", reading.uniqueness);
    rows("relations", reading.relations.map(relation));
    html("factors", reading.factors.map(({ name, formula, value, holds }) =>
      `<dt>${name}</dt><dd class="quiet">${formula}</dd><dd class="value">${value} ${holds ? "≥" : "&lt;"} 1</dd>`).join(""));
    html("departure", reading.departure);
    rows("motion", reading.motion.map(({ symbol: quantity, words, value, unit, real }) => [
      cell(quantity), cell(words, "words"), cell(`${value} ${unit}`, "number"), cell(real, "number"),
    ]));
    const change = (from, to) => cell(`${from} → ${to}`);
    const none = [[cell("It does not.", "words")]];
    rows("along-force", reading.along_force.length === 0 ? none
      : reading.along_force.map(({ at, force, from, to }) => [cell(`<i>k</i> = ${at}`), cell(force ?? ""), change(from, to)]));
    rows("along-friction", reading.along_friction.length === 0 ? none
      : reading.along_friction.map(({ at, from, to }) => [cell(`<i>μ</i> = ${at}`), change(from, to)]));
    rows("failed", reading.failed.length === 0 ? [[cell("None: rest is tried first, and holds.", "words")]]
      : reading.failed.flatMap(({ symbol: mode, rows: failing }) => failing.map(({ equation, statement, values }) => [
        cell(mode), cell(`(${equation})`, "equation"), cell(`${statement}<br><span class="quiet">but not ${values}</span>`),
      ])));
    rows("points", reading.points.map(([letter, k, mu]) => [cell(letter), cell(`<i>k</i> = ${k}`), cell(`<i>μ</i> = ${mu}`)]));
    html("case", reading.case);
    // Read aloud when the hand rests.
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (live.textContent !== reading.plain) live.textContent = reading.plain;
    }, 600);
  };
}
