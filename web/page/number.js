// A number field. It is taken when it is left or at Enter, not at each key; Escape gives back what holds; arrows change it by one per
// cent, with Shift by ten. A text that is not taken stays, with its message, until another is typed or the case is another.

import { element } from "dom";

/** What stands in a field: what holds, what is being typed, or what was not taken. */
const [SHOWN, TYPING, REFUSED] = ["shown", "typing", "refused"];

let count = 0;

/** A field for the number under a key. */
export function numberField(app, key) {
  const id = `number-${(count += 1)}`;
  const input = element("input", { id, inputMode: "decimal", autocomplete: "off" });
  const unit = element("span", { className: "unit" });
  const fault = element("span", {});
  const holds = element("span", {});
  const message = element("span", { className: "message", id: `${id}-message` }, fault, holds);
  fault.setAttribute("role", "alert");
  input.setAttribute("aria-describedby", message.id);
  input.dataset.key = key;
  const box = element("span", { className: "number" }, input, unit, message);
  let state = SHOWN;
  // The text of the case for which what was typed was refused.
  let refusedBy = "";
  let shown = { digits: "", unit: "" };

  const accept = () => {
    state = SHOWN;
    delete input.dataset.typing;
    fault.replaceChildren();
    holds.textContent = "";
    input.removeAttribute("aria-invalid");
  };
  const refuse = (words) => {
    state = REFUSED;
    refusedBy = app.explorer.text();
    delete input.dataset.typing;
    // A new node, so that the same words are announced again.
    fault.replaceChildren(words);
    holds.textContent = `${/[.!?]$/.test(words) ? "" : "."} Until then ${`${shown.digits} ${shown.unit}`.trim()} holds.`;
    input.setAttribute("aria-invalid", "true");
    // The message stays on the page, wherever the field is.
    message.style.translate = "";
    message.style.translate = `${Math.min(0, document.documentElement.clientWidth - 12 - message.getBoundingClientRect().right)}px`;
  };
  const take = () => {
    const words = app.explorer.set(key, input.value);
    if (words) refuse(words);
    else accept();
    app.changed();
  };
  input.addEventListener("input", () => {
    state = TYPING;
    input.dataset.typing = "yes";
  });
  input.addEventListener("blur", () => state === TYPING && take());
  // What is shown is written over as a whole, by a second click too; what is being typed is not.
  for (const event of ["focus", "click"]) input.addEventListener(event, () => state === SHOWN && input.select());
  input.addEventListener("keydown", (event) => {
    if (event.isComposing) return;
    if (event.key === "Enter" && state !== SHOWN) take();
    if (event.key === "Escape") {
      accept();
      app.changed();
    }
    const way = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (way && state === SHOWN && !event.ctrlKey && !event.metaKey && !event.altKey) {
      event.preventDefault();
      app.explorer.step(key, way * (event.shiftKey ? 10 : 1));
      app.changed();
    }
  });
  return {
    box,
    input,
    isTyping: () => state === TYPING,
    /** Shows what holds, unless a person is typing. */
    show(field) {
      shown = field;
      // What was refused beside other numbers may go with those that hold now, as a height with a lower force.
      if (state === REFUSED && !app.held && app.explorer.text() !== refusedBy) take();
      if (unit.textContent !== field.unit) unit.textContent = field.unit;
      if (state === SHOWN && input.value !== field.digits) input.value = field.digits;
      input.style.setProperty("--letters", Math.max(3, field.digits.length));
      const label = field.units.length > 0 ? `${field.words}, ${field.unit}` : field.words;
      if (input.getAttribute("aria-label") !== label && !input.labels?.length) input.setAttribute("aria-label", label);
      if (input.title !== field.words) input.title = field.words;
    },
    /** Another case: what was typed for the last is gone. */
    reset: accept,
  };
}

/** Every number of the case by its key. */
export const byKey = (said) => new Map(said.tables.flatMap(({ numbers }) => numbers.map((number) => [number.key, number])));
