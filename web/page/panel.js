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
    html("scope", reading.scope);
    html("uniqueness", reading.uniqueness);
    rows("relations", reading.relations.map(relation));
    html("factors", reading.factors.map(({ name, formula, value, holds }) =>
      `<dt>${name}</dt><dd class="quiet">${formula}</dd><dd class="value">${value} ${holds ? "≥" : "&lt;"} 1</dd>`).join(""));
    html("departure", reading.departure);
    rows("motion", reading.motion.map(({ symbol: quantity, words, value, unit, real }) => [
      cell(quantity), cell(words, "words"), cell(`${value} ${unit}`, "number"), cell(real, "number"),
    ]));
    const change = (from, to) => cell(`${from} → ${to}`);
    const changes = ({ rows: list, none }, row) => (list.length === 0 ? [[cell(none, "words")]] : list.map(row));
    html("along-force-heading", reading.along_k.heading);
    rows("along-force", changes(reading.along_k, ({ at, force, from, to }) => [cell(at), cell(force ?? ""), change(from, to)]));
    rows("along-friction", changes(reading.along_mu, ({ at, from, to }) => [cell(at), change(from, to)]));
    const untried = reading.mode === "RE" ? "None: rest is tried first, and holds." : "Not listed for these loads.";
    rows("failed", reading.failed.length === 0 ? [[cell(untried, "words")]]
      : reading.failed.flatMap(({ symbol: mode, rows: failing }) => failing.map(({ equation, statement, values }) => [
        cell(mode), cell(`(${equation})`, "equation"), cell(`${statement}<br><span class="quiet">but not ${values}</span>`),
      ])));
    rows("points", reading.points.map(([letter, k, mu]) => [cell(letter), cell(`<i>k</i> = ${k}`), cell(`<i>μ</i> = ${mu}`)]));
    html("case", reading.case);
    html("map-note", reading.map_note);
    // Read aloud when the hand rests.
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (live.textContent !== reading.plain) live.textContent = reading.plain;
    }, 600);
  };
}
