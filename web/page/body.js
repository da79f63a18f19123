// The body, and an exaggerated picture of the motion that begins.

const WIDTH = 400;
const HEIGHT = 270;
const stills = matchMedia("(prefers-reduced-motion: reduce)");

export function connectBody(app) {
  const picture = document.getElementById("body");
  const play = document.getElementById("play");
  const note = document.getElementById("body-note");
  let running = !stills.matches;
  let animation = null;
  let settle = 0;
  let drawn = "";

  const animate = () => {
    animation?.cancel();
    animation = null;
    const body = picture.querySelector(".body");
    const [x, y, shift, turn] = app.explorer.pose(WIDTH, HEIGHT);
    if (!body || !running || (shift === 0 && turn === 0)) return;
    body.style.transformOrigin = `${x}px ${y}px`;
    const end = { translate: `${shift}px 0px`, rotate: `${turn}deg` };
    // From rest at constant acceleration: this easing is the square of the time.
    const start = { translate: "0px 0px", rotate: "0deg", easing: "cubic-bezier(0.3333, 0, 0.6667, 0.3333)" };
    animation = body.animate([start, { ...end, offset: 0.62 }, { ...end, offset: 1 }], { duration: 2400, iterations: Infinity });
  };
  play.addEventListener("click", () => {
    running = !running;
    animate();
    label(app.reading);
  });
  stills.addEventListener("change", () => {
    running = !stills.matches;
    animate();
    label(app.reading);
  });

  const label = (reading) => {
    const still = reading.mode === "RE" || !picture.firstChild;
    play.disabled = still;
    play.textContent = running && !still ? "Pause" : "Play";
    play.setAttribute("aria-pressed", String(running && !still));
    const forces = reading.with_water ? "Solid arrows: the loads as the one force F that they amount to, and the reactions" : "Solid arrows: forces";
    note.textContent = !picture.firstChild
      ? "No picture: these loads do not amount to one horizontal force on a pressed base."
      : still
        ? `To scale, at rest. ${forces}.`
        : `To scale; the motion is exaggerated. ${forces}; dashed: accelerations of the corners.`;
  };

  return (reading) => {
    const key = `${reading.numbers.given} ${reading.numbers.all_loads} ${reading.mirrored}`;
    if (key !== drawn) {
      drawn = key;
      animation?.cancel();
      picture.innerHTML = app.explorer.free_body(WIDTH, HEIGHT);
      // While a control is dragged the body stands still.
      clearTimeout(settle);
      settle = setTimeout(animate, 250);
    }
    label(reading);
  };
}
