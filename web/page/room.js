// How high a drawing may be: a share of the screen beside all else, or in a story and a frame what is left of it.

import { byId } from "dom";

/** True where a drawing takes what is left of the screen. */
export const isAlone = (app) => Boolean(app.story || app.only);

/** The height of a drawing so wide in a place, at most a share of its width and of the screen. */
export function room(app, place, width, ratio, share) {
  if (!isAlone(app)) return Math.min(ratio * width, 620, share * innerHeight);
  const plate = place.closest(".plate");
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
