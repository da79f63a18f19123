// What is dragged: held from the press to the release, and given back where the drag is broken off.

/// `gripped` is told where it is pressed; `moved` gives what a move does, which is done once a frame. Gives back what breaks the drag off.
export function dragged(app, handle, gripped, moved) {
  handle.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    handle.setPointerCapture(event.pointerId);
    gripped(event);
    app.explorer.grab();
    app.held = true;
  });
  handle.addEventListener("pointermove", (event) => {
    if (!app.held || !handle.hasPointerCapture(event.pointerId)) return;
    app.drag = moved(event);
    app.changed();
  });
  const end = (taken) => () => {
    if (!app.held) return;
    app.settleDrag();
    app.held = false;
    if (taken) app.explorer.release();
    else app.explorer.let_go();
    app.changed();
  };
  handle.addEventListener("pointerup", end(true));
  handle.addEventListener("pointercancel", end(false));
  return end(false);
}
