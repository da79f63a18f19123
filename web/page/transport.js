// The time of a motion: run, speed, events, the bar, the clock; and the line at the same moment in the histories.

import { byId, put } from "dom";

const stills = matchMedia("(prefers-reduced-motion: reduce)");
/** Rest longer than this is jumped over, but for its first and last part, s. */
const LONG = 2;
const SHOWN = 0.5;

export function connectTransport(app) {
  const bar = byId("time-bar");
  const ticks = byId("ticks");
  const run = byId("run");
  const speed = byId("speed");
  const cursor = byId("cursor");
  const picture = byId("map").querySelector(".picture");
  let name = "";
  let drawnTicks = "";
  let last = 0;
  const time = { t: 0, running: false, motion: null };
  app.time = time;
  const longRests = () => time.motion.rests.filter(([from, to]) => to - from > LONG);

  const show = () => {
    const { t, motion } = time;
    const share = motion.end > 0 ? t / motion.end : 0;
    bar.style.setProperty("--at", share);
    const clock = app.showMoment(t);
    put(byId("clock"), clock);
    bar.setAttribute("aria-valuenow", t.toFixed(3));
    bar.setAttribute("aria-valuetext", `${clock}, ${byId("moment").textContent}`);
    const [x0, y0, x1, y1] = app.explorer.histories_plot();
    cursor.hidden = x0 === undefined;
    if (cursor.hidden) return;
    cursor.style.translate = `${(x0 + share * (x1 - x0)) * app.plateScale}px ${y0 * app.plateScale}px`;
    cursor.style.height = `${(y1 - y0) * app.plateScale}px`;
  };
  const go = (t) => {
    time.t = Math.min(Math.max(t, 0), time.motion.end);
    show();
  };
  const frame = (now) => {
    if (!time.running || !time.motion) return;
    // A page that was not looked at goes on where it was.
    let t = time.t + Math.min((now - last) / 1000, 0.1) * Number(speed.value);
    last = now;
    for (const [from, to] of longRests()) {
      if (t > from + SHOWN && t < to - SHOWN) t = to >= time.motion.end ? to : to - SHOWN;
    }
    go(t);
    if (time.t >= time.motion.end) setRunning(false);
    requestAnimationFrame(frame);
  };
  const setRunning = (running) => {
    if (running && !time.running) {
      if (time.t >= time.motion.end) time.t = 0;
      last = performance.now();
      requestAnimationFrame(frame);
    }
    time.running = running;
    put(run, running ? "Pause" : "Play");
  };
  const toggle = () => setRunning(!time.running);
  const event = (way) => {
    const { t, motion } = time;
    const near = 1e-6 * motion.end;
    const stops = [0, ...motion.events, motion.end];
    const next = way > 0 ? stops.find((stop) => stop > t + near) : stops.findLast((stop) => stop < t - near);
    setRunning(false);
    if (next !== undefined) go(next);
  };
  run.addEventListener("click", toggle);
  byId("event-before").addEventListener("click", () => event(-1));
  byId("event-after").addEventListener("click", () => event(1));
  stills.addEventListener("change", () => stills.matches && time.motion && setRunning(false));

  // The keys: on the bar, and wherever no field or button has them.
  addEventListener("keydown", (pressed) => {
    if (!time.motion || pressed.ctrlKey || pressed.metaKey || pressed.altKey) return;
    if (pressed.target !== bar && pressed.target !== document.body && pressed.target.id !== "story-head") return;
    // In a story the arrows lead from step to step.
    if (app.story && pressed.target !== bar && pressed.key.startsWith("Arrow")) return;
    const step = time.motion.end / (pressed.shiftKey ? 20 : 200);
    const action = {
      " ": toggle, ArrowLeft: () => go(time.t - step), ArrowRight: () => go(time.t + step), PageUp: () => event(-1), PageDown: () => event(1),
      Home: () => go(0), End: () => go(time.motion.end),
      ...(pressed.target === bar ? { ArrowDown: () => go(time.t - step), ArrowUp: () => go(time.t + step) } : {}),
    }[pressed.key];
    if (!action || (pressed.target !== bar && !/^( |Arrow)/.test(pressed.key))) return;
    pressed.preventDefault();
    if (pressed.key.startsWith("Arrow")) setRunning(false);
    action();
  });

  // The hand: on the bar, and in the histories.
  const pulled = (place, share) => {
    const pull = (pressed) => {
      setRunning(false);
      go(share(pressed) * time.motion.end);
    };
    place.addEventListener("pointerdown", (pressed) => {
      if (pressed.button !== 0 || !time.motion || (place === picture && app.shownPlate !== "time")) return;
      place.setPointerCapture(pressed.pointerId);
      pull(pressed);
    });
    place.addEventListener("pointermove", (pressed) => {
      if (time.motion && place.hasPointerCapture(pressed.pointerId) && (place !== picture || app.shownPlate === "time")) pull(pressed);
    });
  };
  pulled(bar, (pressed) => {
    const box = bar.getBoundingClientRect();
    return (pressed.clientX - box.left) / box.width;
  });
  pulled(picture, (pressed) => {
    const [x0, , x1] = app.explorer.histories_plot();
    return ((pressed.clientX - picture.getBoundingClientRect().left) / app.plateScale - x0) / (x1 - x0);
  });

  return (said) => {
    const motion = app.motion;
    byId("transport").hidden = motion === null;
    time.motion = motion;
    if (!motion) {
      time.running = false;
      cursor.hidden = true;
      name = "";
      return;
    }
    bar.setAttribute("aria-valuemax", motion.end.toFixed(3));
    const place = (t) => ((1000 * t) / motion.end).toFixed(1);
    const marks = motion.events.map((t) => `M${place(t)} 0V10`).join("");
    const rests = longRests().map(([from, to]) => `M${place(from)} 5H${place(to)}`).join("");
    if (drawnTicks !== marks + rests) {
      ticks.querySelector(".marks").setAttribute("d", marks);
      ticks.querySelector(".rests").setAttribute("d", rests);
      drawnTicks = marks + rests;
    }
    const other = name !== `${said.name} ${said.title}`;
    name = `${said.name} ${said.title}`;
    if (other) {
      time.t = app.startAt ?? 0;
      const starts = app.startAt === undefined && !stills.matches;
      app.startAt = undefined;
      setRunning(false);
      if (starts) setRunning(true);
    }
    go(time.t);
  };
}
