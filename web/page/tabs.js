// Tabs below the plates: one answer at a time.

import { byId } from "dom";

const NAMES = ["compare", "why", "help", "likely", "inputs", "whole", "terms"];

export function connectTabs(app) {
  app.tab = "why";
  const tab = (name) => byId(`tab-${name}`);
  // That of two cases is there while one is pinned.
  const shown = () => NAMES.filter((name) => name !== "compare" || app.explorer.pinned().length > 0);
  app.showTab = (name) => {
    if (!shown().includes(name) || app.tab === name) return;
    app.tab = name;
    app.changed();
  };
  for (const name of NAMES) {
    tab(name).addEventListener("click", () => app.showTab(name));
    tab(name).addEventListener("keydown", (event) => {
      const names = shown();
      const i = names.indexOf(name);
      const next = { ArrowRight: i + 1, ArrowLeft: i - 1, Home: 0, End: names.length - 1 }[event.key];
      if (next === undefined) return;
      event.preventDefault();
      const other = names[(next + names.length) % names.length];
      app.showTab(other);
      tab(other).focus();
    });
  }
  return ({ compared }) => {
    if (!compared && app.tab === "compare") app.tab = "why";
    tab("compare").hidden = !compared;
    for (const name of NAMES) {
      const chosen = name === app.tab;
      tab(name).setAttribute("aria-selected", String(chosen));
      tab(name).tabIndex = chosen ? 0 : -1;
      byId(`panel-${name}`).hidden = !chosen;
    }
  };
}
