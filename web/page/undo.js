// Undo and redo: of texts, by buttons and keys.

import { byId } from "dom";

export function connectUndo(app) {
  const go = (way) => {
    app.settleText();
    app.explorer[way]();
    app.changed();
  };
  byId("undo").addEventListener("click", () => go("undo"));
  byId("redo").addEventListener("click", () => go("redo"));
  addEventListener("keydown", (event) => {
    if ((!event.ctrlKey && !event.metaKey) || event.altKey || app.held) return;
    const key = event.key.toLowerCase();
    const way = key === "z" ? (event.shiftKey ? "redo" : "undo") : key === "y" ? "redo" : null;
    // In a number that is being typed the keys are the browser's.
    const typed = event.target.matches?.("input[data-typing]");
    if (!way || typed) return;
    event.preventDefault();
    go(way);
  });
  return (said) => {
    byId("undo").disabled = !said.can_undo;
    byId("redo").disabled = !said.can_redo;
  };
}
