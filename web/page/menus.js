// Menus of the header: each closes at Escape, and when something else is pressed. The way in: open, new, examples.

import { Explorer } from "library";
import { byId, element, put, today } from "dom";

export function connectMenus(app) {
  const menus = [...document.querySelectorAll("details.menu")];
  const close = () => menus.forEach((menu) => (menu.open = false));
  document.addEventListener("pointerdown", (event) => {
    for (const menu of menus) if (!menu.contains(event.target)) menu.open = false;
  });
  for (const menu of menus) {
    menu.addEventListener("keydown", (event) => {
      if (event.key !== "Escape" || !menu.open) return;
      menu.open = false;
      menu.querySelector("summary").focus();
    });
    menu.addEventListener("toggle", () => {
      if (menu.open) menus.filter((other) => other !== menu).forEach((other) => (other.open = false));
    });
  }
  byId("save-menu").addEventListener("click", (event) => {
    if (event.target.closest("button")) close();
  });

  const take = (name) => () => {
    close();
    app.plate = "";
    app.explorer.open_example(name);
    app.changed();
  };
  const list = (name, cases) => element("section", {}, element("h2", {}, name), element("ul", {}, ...cases.map((one) => {
    const choice = element("button", { type: "button" }, one.name, element("small", {}, one.words));
    choice.dataset.case = one.name;
    choice.addEventListener("click", take(one.name));
    return element("li", {}, choice);
  })));
  const [shelves, fresh] = JSON.parse(Explorer.examples());
  const open = element("button", { type: "button", id: "open" }, "Open…");
  open.addEventListener("click", () => {
    close();
    byId("file").click();
  });
  byId("case-sheet").append(
    element("div", { className: "open-row" }, open, element("span", { className: "hint" }, "or drop a case file anywhere on the page, with the records that it names")),
    list("New", fresh), ...shelves.map((shelf) => list(shelf.name, shelf.cases)),
  );
  return (said) => {
    const title = said.fault ? said.name : (said.title ?? said.name);
    put(byId("case-name"), title);
    document.title = `${title} · standfast explorer`;
    put(byId("print-head"), `${title} · ${said.name} · ${today()} · standfast explorer`);
  };
}
