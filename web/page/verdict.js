// The answer on top: what the body does, whether that is enough, how near another answer is.

import { byId, element, put, whenChanged } from "dom";
import { likelihood } from "likely";
import { refill } from "redraw";

/** Shares beside each other, in their colours. */
function stacked(strip) {
  let at = 0;
  const stops = strip.flatMap(([share, tint]) => [`${tint} ${100 * at}%`, `${tint} ${100 * (at += share)}%`]);
  return `linear-gradient(to right, ${stops.join(", ")})`;
}

export function connectVerdict(app) {
  const section = byId("verdict");
  const symbol = byId("symbol");
  const live = byId("live");
  let timer = 0;
  const rulers = whenChanged((list) => {
    refill(byId("rulers"), list.flatMap(({ name, words, value, before, required, at, bound, good }) => {
      const line = element("span", { className: good ? "ruler" : "ruler bad" });
      // Of a factor 1 is where the body moves; a bound lies in the middle of its line.
      const tick = element("i", { className: bound === null ? "" : "asked" });
      tick.style.left = "50%";
      const dot = element("b", { className: at >= 1 ? "beyond" : "" });
      dot.style.left = `${100 * at}%`;
      line.append(tick, dot);
      line.setAttribute("aria-hidden", "true");
      const said = required ? `${value} ${good ? "" : "not "}${required}` : good ? value : `${value} below 1`;
      const of_a = before === null ? [] : [element("span", { className: "before" }, `${before} → `)];
      return [element("dt", { title: words }, name), element("dd", {}, line), element("dd", { className: good ? "" : "bad" }, ...of_a, said)];
    }));
  });
  return (said) => {
    const { summary } = said;
    // Of random numbers the probability is on top as soon as it is known; a motion is the answer to a case in time.
    const chances = said.in_time || app.held ? undefined : likelihood(app, said)?.chances;
    symbol.style.setProperty("--tint", said.tint);
    symbol.style.background = chances ? stacked(chances.strip) : "";
    symbol.dataset.mode = said.mode;
    symbol.classList.toggle("several", !said.unique);
    // Made of the library's own symbols only, never of a person's text.
    const shown = chances?.percent ?? said.symbol;
    if (symbol.innerHTML !== shown) symbol.innerHTML = shown;
    section.classList.toggle("not-met", summary?.met === false || chances?.summary.met === false);
    // Two that differ are told in one sentence.
    const both = said.compared?.answer ? said.compared : null;
    const answer = both?.answer ?? chances?.summary.answer ?? summary?.answer ?? "";
    const criteria = [chances?.criteria, both?.criteria ?? said.criteria].filter(Boolean).join(" ");
    const alone = [chances && [said.standing, summary?.answer], summary?.near];
    const near = (both ? [both.near, chances?.summary.answer] : alone).flat().filter(Boolean).join(" ");
    put(byId("answer"), answer);
    put(byId("criteria"), criteria);
    put(byId("near"), near);
    put(byId("still"), said.fault ? `The text has a fault. This is still the answer to ${said.title ? `“${said.title}”` : "the text before"}.` : "");
    put(byId("warnings"), said.warnings.length === 0 ? "" : `Warnings: ${said.warnings.map(([name]) => name).join(", ")}`);
    rulers(said.rulers.slice(0, 3));
    // Read aloud when the hand rests.
    clearTimeout(timer);
    timer = setTimeout(() => put(live, [answer, criteria, near].filter(Boolean).join(" ")), 600);
  };
}
