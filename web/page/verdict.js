// The answer on top: what the body does, whether that is enough, how near another answer is.

import { byId, element, put, whenChanged } from "dom";

export function connectVerdict(app) {
  const section = byId("verdict");
  const symbol = byId("symbol");
  const live = byId("live");
  let timer = 0;
  const rulers = whenChanged((list) => {
    byId("rulers").replaceChildren(...list.flatMap(({ name, words, value, required, at, bound, good }) => {
      const line = element("span", { className: good ? "ruler" : "ruler bad" });
      // Of a factor 1 is where the body moves; a bound lies in the middle of its line.
      const tick = element("i", { className: bound === null ? "" : "asked" });
      tick.style.left = "50%";
      const dot = element("b", { className: at >= 1 ? "beyond" : "" });
      dot.style.left = `${100 * at}%`;
      line.append(tick, dot);
      line.setAttribute("aria-hidden", "true");
      const said = required ? `${value} ${good ? "" : "not "}${required}` : good ? value : `${value} below 1`;
      return [element("dt", { title: words }, name), element("dd", {}, line), element("dd", { className: good ? "" : "bad" }, said)];
    }));
  });
  return (said) => {
    const { summary } = said;
    symbol.style.setProperty("--tint", said.tint);
    symbol.dataset.mode = said.mode;
    symbol.classList.toggle("several", !said.unique);
    // Made of the library's own symbols only, never of a person's text.
    if (symbol.innerHTML !== said.symbol) symbol.innerHTML = said.symbol;
    section.classList.toggle("not-met", summary?.met === false);
    put(byId("answer"), summary?.answer ?? "");
    put(byId("criteria"), said.criteria ?? "");
    put(byId("near"), summary?.near ?? "");
    put(byId("still"), said.fault ? `The text has a fault. This is still the answer to ${said.title ? `“${said.title}”` : "the text before"}.` : "");
    put(byId("warnings"), said.warnings.length === 0 ? "" : `Warnings: ${said.warnings.map(([name]) => name).join(", ")}`);
    rulers(said.rulers.slice(0, 3));
    // Read aloud when the hand rests.
    clearTimeout(timer);
    timer = setTimeout(() => put(live, [summary?.answer, said.criteria, summary?.near].filter(Boolean).join(" ")), 600);
  };
}
