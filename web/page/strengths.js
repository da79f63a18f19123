// How much stronger the loads have to be to overturn the body: tried one factor after the other once the page is drawn, so that nothing waits.

import { byId } from "dom";
import { redraw } from "redraw";

/** Between two tries the page has its turn, ms. */
const TURN = 25;

export function connectStrengths(app) {
  const place = byId("strengths");
  let timer = 0;
  // The answer of which all is tried.
  let tried = { from: null, answers: 0 };
  let known = false;
  const step = () => {
    timer = 0;
    if (app.held || !app.motion) return;
    if (app.explorer.try_strength()) timer = setTimeout(step, TURN);
    else tried = { from: app.explorer, answers: app.explorer.answers() };
    if (!known && app.explorer.strengths(300)) app.changed();
  };
  return () => {
    const svg = app.motion && app.shownPlate === "time" ? app.explorer.strengths(Math.floor(byId("map").clientWidth)) : "";
    known = app.motion !== null && app.explorer.strengths(300) !== "";
    place.hidden = !svg;
    redraw(place, svg);
    clearTimeout(timer);
    const isTried = tried.from === app.explorer && tried.answers === app.explorer.answers();
    if (app.motion && !app.held && !isTried) timer = setTimeout(step, TURN);
  };
}
