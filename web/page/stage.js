// The body in motion: a drawing made once, of which one group is moved.

import { byId, put } from "dom";
import { redraw } from "redraw";
import { kept, room } from "room";

/** Numbers of a pose: x, y, degrees clockwise, shift of the ground, mode. */
const STRIDE = 5;
const LINES = ["arc", "balance", "slid", "push"];

export function connectStage(app) {
  const stage = byId("stage");
  let fromEarth = false;
  let poses = new Float32Array();
  let parts = null;
  let shownMode = -1;
  app.motion = null;

  const look = (earth) => () => {
    fromEarth = earth;
    app.changed();
  };
  byId("from-floor").addEventListener("click", look(false));
  byId("from-earth").addEventListener("click", look(true));

  const move = (t) => {
    const place = Math.min(t / app.motion.step, poses.length / STRIDE - 1);
    const i = Math.floor(place);
    const after = Math.min(i + 1, poses.length / STRIDE - 1);
    const between = (which) => poses[i * STRIDE + which] + (place - i) * (poses[after * STRIDE + which] - poses[i * STRIDE + which]);
    parts.body.setAttribute("transform", `translate(${between(0).toFixed(2)} ${between(1).toFixed(2)}) rotate(${between(2).toFixed(3)})`);
    parts.floor.setAttribute("transform", `translate(${between(3).toFixed(2)} 0)`);
    const mode = poses[i * STRIDE + 4];
    if (mode === shownMode) return;
    for (const group of parts.modes) {
      if (Number(group.dataset.mode) === mode) group.removeAttribute("display");
      else group.setAttribute("display", "none");
    }
    shownMode = mode;
  };
  /** Shows a moment; gives back the clock. */
  app.showMoment = (t) => {
    // Between another case and its picture the motion is one that was.
    const json = app.explorer.moment(t);
    if (!json) return "";
    const moment = JSON.parse(json);
    const scale = stage.hidden ? "" : app.motion.times;
    put(byId("moment"), [...moment.words, scale].filter(Boolean).join(" · "));
    if (!stage.hidden) {
      move(t);
      LINES.forEach((line, i) => parts.lines[i].setAttribute("d", moment[line]));
    }
    return moment.clock;
  };
  return () => {
    const json = app.explorer.stage(fromEarth, ...kept(app, stage, () => {
      const width = Math.max(280, stage.parentElement.clientWidth);
      return [Math.floor(width), Math.round(Math.max(app.story ? 180 : 230, room(app, stage, width, 0.6, 0.45)))];
    }));
    app.motion = json ? JSON.parse(json) : null;
    byId("views").hidden = stage.hidden || !app.motion?.shaken;
    byId("moment").hidden = !app.motion;
    if (!app.motion) return;
    if (!stage.hidden) {
      byId("from-floor").setAttribute("aria-pressed", String(!fromEarth));
      byId("from-earth").setAttribute("aria-pressed", String(fromEarth));
      put(byId("body-hint"), app.motion.times ? "" : "true scale");
    }
    poses = app.explorer.poses();
    redraw(stage, app.motion.svg);
    parts = {
      floor: stage.querySelector(".sf-floor"),
      body: stage.querySelector(".sf-body"),
      modes: [...stage.querySelectorAll(".sf-mode")],
      lines: LINES.map((line) => stage.querySelector(`.sf-${line}`)),
    };
    shownMode = -1;
  };
}
