// The text of the case: read at each pause, with its fault marked where it is and the cure as a button.

import { byId, element, put } from "dom";

const PAUSE = 350;

export function connectPane(app) {
  const text = byId("text");
  const marks = document.querySelector(".marks");
  const gutter = document.querySelector(".gutter");
  const wide = matchMedia("(min-width: 106rem), (min-width: 1700px)");
  let timer = 0;
  let typing = false;
  let shown = null;

  const settle = () => {
    clearTimeout(timer);
    if (!typing) return;
    typing = false;
    app.explorer.edit(text.value);
    app.changed();
  };
  /** Takes what is being typed into the text. */
  app.settleText = settle;
  text.addEventListener("input", () => {
    typing = true;
    number();
    marks.replaceChildren();
    clearTimeout(timer);
    timer = setTimeout(settle, PAUSE);
  });
  text.addEventListener("blur", settle);
  const scroll = () => {
    marks.style.translate = `${-text.scrollLeft}px ${-text.scrollTop}px`;
    gutter.scrollTop = text.scrollTop;
  };
  text.addEventListener("scroll", scroll);
  const number = () => put(gutter, `${Array.from({ length: text.value.split("\n").length }, (_, i) => i + 1).join("\n")}\n\n`);

  byId("cure").addEventListener("click", () => {
    app.explorer.cure();
    app.changed();
  });
  byId("leave").addEventListener("click", () => {
    app.explorer.undo();
    app.changed();
  });
  // From some width on the text is a column of its own.
  const move = () => byId(wide.matches ? "text-plate" : "text-place").append(byId("pane"));
  wide.addEventListener("change", move);
  move();

  // The number that is in hand is marked in the text.
  let lit = "";
  const light = (event) => {
    const key = event.type === "focusin" ? event.target.dataset?.key ?? "" : "";
    if (key === lit) return;
    lit = key;
    app.changed();
  };
  addEventListener("focusin", light);
  addEventListener("focusout", light);
  const mark = (from, to, className = "") => {
    const marked = element("mark", { className }, text.value.slice(from, to) || " ");
    marks.replaceChildren(text.value.slice(0, from), marked, text.value.slice(Math.max(to, from)));
    return marked;
  };

  let told = "";
  return (said) => {
    if (!typing && !app.held) {
      const now = app.explorer.text();
      if (now !== text.value) {
        text.value = now;
        number();
      }
    }
    const { fault } = said;
    const key = JSON.stringify(fault) + (shown ?? "");
    byId("pane-fault").hidden = !fault;
    if (!fault) {
      const [from, to] = lit && !typing ? app.explorer.place_of(lit) : [];
      if (to === undefined) marks.replaceChildren();
      else mark(from, to, "lit");
      told = "";
      return;
    }
    if (key === told) return;
    told = key;
    put(byId("fault-where"), `Line ${fault.line}:`);
    put(byId("fault-message"), fault.message);
    put(byId("fault-help"), fault.help);
    put(byId("fault-example"), fault.example);
    byId("cure").hidden = !fault.cure;
    put(byId("cure"), fault.cure ?? "");
    byId("leave").disabled = !said.can_undo;
    const [from, to] = fault.place;
    const marked = mark(from, to);
    // A fault of what was dropped or opened is brought into sight.
    if (document.activeElement !== text) {
      app.showTab("inputs");
      text.scrollTop = Math.max(0, marked.offsetTop - text.clientHeight / 2);
      scroll();
      requestAnimationFrame(() => byId("pane").scrollIntoView({ block: "nearest" }));
    }
  };
}
