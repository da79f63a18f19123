// Tabs below the plates: one answer at a time.

import { byId } from "dom";

const NAMES = ["why", "help", "likely", "inputs", "whole", "terms"];

export function connectTabs(app) {
  app.tab = "why";
  const tabs = NAMES.map((name) => byId(`tab-${name}`));
  app.showTab = (name) => {
    if (!NAMES.includes(name) || app.tab === name) return;
    app.tab = name;
    app.changed();
  };
  tabs.forEach((tab, i) => {
    tab.addEventListener("click", () => app.showTab(NAMES[i]));
    tab.addEventListener("keydown", (event) => {
      const next = { ArrowRight: i + 1, ArrowLeft: i - 1, Home: 0, End: NAMES.length - 1 }[event.key];
      if (next === undefined) return;
      event.preventDefault();
      const at = (next + NAMES.length) % NAMES.length;
      app.showTab(NAMES[at]);
      tabs[at].focus();
    });
  });
  return () => {
    NAMES.forEach((name, i) => {
      const chosen = name === app.tab;
      tabs[i].setAttribute("aria-selected", String(chosen));
      tabs[i].tabIndex = chosen ? 0 : -1;
      byId(`panel-${name}`).hidden = !chosen;
    });
  };
}
