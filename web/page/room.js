// How high a drawing may be: a share of the screen beside all else, or in a story and a frame what is left of it.

import { byId } from "dom";

/** Tabs with their first row, below everything else: its heading with a line of words, or of a table with a line under it. */
const FIRST = { words: 68, table: 84 };
/** Margins between the parts of a plate. */
const MARGINS = 27;
/** What was measured of a place before something was begun to be dragged: a drawing keeps its size under the hand. */
const measured = new WeakMap();

/** What `measure` finds of a place; while something is held what it found before, so that the page need not be laid out in between. */
export function kept(app, place, measure) {
  if (!app.held || !measured.has(place)) measured.set(place, measure());
  return measured.get(place);
}

/** True where a drawing takes what is left of the screen. */
export const isAlone = (app) => Boolean(app.story || app.only);

/** What is left for a drawing so that the tabs and the first row of one are on the screen, where plates stand side by side. */
function left(app, plate) {
  if (plate.clientWidth > 0.6 * innerWidth) return Infinity;
  const above = plate.getBoundingClientRect().top + scrollY + plate.querySelector(".bar").offsetHeight;
  const parts = [...plate.querySelectorAll(".moment, .loose, .legend > summary, #strengths"), byId("transport"), document.querySelector(".tabs")];
  return innerHeight - above - MARGINS - parts.reduce((sum, one) => sum + one.offsetHeight, app.motion ? FIRST.words : FIRST.table);
}

/** The height of a drawing so wide in a place, at most a share of its width and of the screen. */
export function room(app, place, width, ratio, share) {
  const plate = place.closest(".plate");
  if (!isAlone(app)) return Math.min(ratio * width, 620, share * innerHeight, left(app, plate));
  // One above the other they share a screen.
  if (app.story && !app.only && plate.clientWidth > 0.6 * innerWidth) {
    const left = innerHeight - plate.parentElement.getBoundingClientRect().top - scrollY - byId("loose").offsetHeight - byId("story-nav").offsetHeight - 24;
    return Math.min(0.7 * width, left / 2);
  }
  const above = plate.getBoundingClientRect().top + scrollY + plate.querySelector(".bar").offsetHeight;
  const below = ["moment", "loose", "strengths"].map((id) => byId(id)).filter((one) => plate.contains(one));
  const others = [...below, byId("transport"), byId("story-nav"), byId("whole-page")];
  return Math.min(0.85 * width, innerHeight - above - others.reduce((sum, one) => sum + one.offsetHeight, 26));
}
