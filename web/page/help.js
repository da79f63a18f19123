// What would help: the least change of each number, a row as it is found; and for two numbers the boundary of the values that would do.

import { byId, element, put, say } from "dom";
import { redraw } from "redraw";

/** Below this a column is a phone's. */
const NARROW = 520;
/** So much larger than it was laid out a drawing is shown at most. */
const ENLARGED = 1.35;

export function connectHelp(app) {
  const [list, others, heading] = [byId("changes"), byId("others"), byId("help-heading")];
  const selects = [byId("two-up"), byId("two-across")];
  let shown = { answer: null, parts: 0 };
  /** The two numbers, and of which case they were chosen by the page. */
  let two = { of: null, chosen: [], wanted: false };

  const cell = (className, ...content) => element("span", { className }, ...content);
  const take = (answer, row) => {
    app.settleText();
    // Another case by now has other answers.
    if (app.asked("help") !== answer) return;
    app.explorer.edit(row.text);
    say(`${row.words}: ${row.printed}. Undo takes it back.`);
    heading.focus({ preventScroll: true });
    app.changed();
  };
  const told = (answer, row) => {
    const way = row.does === "helps" ? "→ " : row.wanted === "least" ? "down to " : "up to ";
    const small = row.with.length > 0 ? `with it ${row.with.join(", ")}` : row.does === "reserve" ? row.why : "";
    const cells = [
      cell("what", row.words), cell("present", row.present_printed),
      cell("found", cell("way", way), row.printed), cell("share", row.change),
    ];
    if (row.text) {
      const button = element("button", { type: "button", title: row.why ? `Just short of it, ${row.why}` : "" }, "Try");
      button.setAttribute("aria-label", `Try ${row.words} ${row.printed}`);
      button.addEventListener("click", () => take(answer, row));
      cells.push(button);
    }
    if (small) cells.push(element("small", {}, small));
    return Object.assign(element("li", {}, ...cells), { share: Math.abs(row.share) });
  };
  const show = (answer, { fault, heading: words, caution, met, row, numbers }) => {
    if (fault) put(byId("help-fault"), fault);
    if (words) {
      put(heading, words);
      put(byId("help-caution"), caution ?? "");
      put(byId("others-title"), met ? "These may go as far as was tried" : "These do not help");
      list.classList.toggle("reserve", met);
    }
    if (row?.printed) {
      // The nearest limit stands first; of what helps the order stays, for a hand on its way to a button.
      const item = told(answer, row);
      const before = row.does === "reserve" ? [...list.children].find((other) => other.share > item.share) : null;
      list.insertBefore(item, before ?? null);
    } else if (row) {
      others.append(element("li", {}, `${row.words}: ${row.why}.`));
    }
    if (numbers.length > 0) {
      for (const select of selects) select.replaceChildren(...numbers.map(([key, name]) => new Option(name, key)));
    }
  };
  selects.forEach((select, i) => select.addEventListener("change", () => {
    two.chosen[i] = select.value;
    app.changed();
  }));
  byId("two-find").addEventListener("click", () => {
    two.wanted = true;
    app.changed();
  });

  const picture = byId("two-picture");
  const boundary = (answer) => {
    const choice = answer.parts.at(-1);
    byId("two").hidden = !choice || choice.numbers.length < 2;
    if (byId("two").hidden) return;
    const keys = choice.numbers.map(([key]) => key);
    if (two.of !== answer) two = { of: answer, chosen: two.chosen, wanted: false };
    // What a person chose stays, as long as the case has it.
    if (!two.chosen.every((key) => keys.includes(key)) || two.chosen.length < 2) {
      two.chosen = [...choice.two, ...keys.filter((key) => !choice.two.includes(key))].slice(0, 2);
    }
    selects.forEach((select, i) => {
      if (select.value !== two.chosen[i]) select.value = two.chosen[i];
      for (const option of select.options) option.disabled = option.value === two.chosen[1 - i];
    });
    const waits = choice.slow && !two.wanted;
    byId("two-find").hidden = !waits;
    const found = waits ? { parts: [], done: true, fault: "" } : app.asked(`two ${two.chosen.join(" ")}`);
    const [part] = found.parts;
    put(byId("two-words"), part?.words ?? (waits ? "Each value takes a while: the boundary is found if you ask." : found.fault || "The boundary is being found …"));
    const width = Math.floor(byId("two").clientWidth);
    const svg = part ? (width < NARROW ? part.narrow : part.wide) : "";
    // The drawing before stays until the next is there.
    if (part || waits) redraw(picture, svg);
    const image = picture.querySelector("svg");
    if (image) image.style.width = `${Math.min(width, ENLARGED * Number(image.getAttribute("width")))}px`;
  };
  return () => {
    if (app.tab !== "help") return;
    const answer = app.asked("help");
    put(byId("help-state"), answer.fault || (answer.done ? "Values are rounded to the safe side." : "Other numbers are being tried …"));
    // What was found before stays until there is something new.
    if (answer.parts.length === 0) return;
    if (shown.answer !== answer) {
      shown = { answer, parts: 0 };
      list.replaceChildren();
      others.replaceChildren();
      put(byId("help-fault"), "");
      put(byId("help-caution"), "");
      put(heading, "The least change of each number");
    }
    for (; shown.parts < answer.parts.length; shown.parts += 1) show(answer, answer.parts[shown.parts]);
    byId("others-part").hidden = others.children.length === 0;
    if (answer.done) boundary(answer);
  };
}
