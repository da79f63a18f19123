// The report's figures, shown in place of the map of all modes.

import { Explorer } from "library";

const CHAPTERS = { 2: "Chapter II", 3: "Chapter III: force above the centre", 4: "Chapter IV: force below the centre" };

export function connectFigures(app) {
  const select = document.getElementById("figure");
  select.append(new Option("all modes of this body", ""));
  for (const [chapter, name] of Object.entries(CHAPTERS)) {
    const group = document.createElement("optgroup");
    group.label = name;
    const figures = JSON.parse(Explorer.figure_list()).filter(([number]) => number.startsWith(`${chapter}.`));
    group.append(...figures.map(([number, caption]) => new Option(`Fig. ${number} ${caption}`, number)));
    select.append(group);
  }
  const show = (index) => {
    select.selectedIndex = (index + select.options.length) % select.options.length;
    app.explorer.show_figure(select.value);
    app.changed();
  };
  select.addEventListener("change", () => show(select.selectedIndex));
  document.getElementById("previous").addEventListener("click", () => show(select.selectedIndex - 1));
  document.getElementById("next").addEventListener("click", () => show(select.selectedIndex + 1));
  return (reading) => {
    select.value = reading.figure ?? "";
  };
}
