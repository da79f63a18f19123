// The page: one explorer in wasm, which holds the state and does all mechanics; the modules beside this one hand it what a
// person does and show what it answers.

import start, { Explorer } from "library";
import { connectMap } from "map";
import { connectCases } from "cases";
import { connectBody } from "body";
import { connectFields } from "fields";
import { connectFigures } from "figures";
import { connectPath } from "path";
import { connectPanel } from "panel";
import { connectShare } from "share";
import { connectTheme } from "theme";

const byId = (id) => document.getElementById(id);

async function library() {
  const packed = Uint8Array.from(atob(byId("wasm").textContent), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  await start({ module_or_path: await new Response(stream).arrayBuffer() });
}

async function type() {
  for (const italic of [false, true]) {
    const face = new FontFace("Standfast", Explorer.font(italic), { style: italic ? "italic" : "normal" });
    document.fonts.add(await face.load());
  }
}

function connect() {
  const app = { explorer: new Explorer(location.hash), reading: null, frames: 0 };
  const parts = [];
  let due = 0;
  const draw = () => {
    due = 0;
    app.reading = JSON.parse(app.explorer.reading());
    parts.forEach((part) => part(app.reading));
    app.frames += 1;
  };
  // However many events come, the page is drawn once for each picture that the screen shows.
  app.changed = () => {
    due ||= requestAnimationFrame(draw);
  };
  for (const connectPart of [
    connectMap, connectCases, connectBody, connectFields, connectFigures, connectPath, connectPanel, connectShare,
  ]) {
    parts.push(connectPart(app));
  }
  addEventListener("hashchange", () => {
    if (location.hash.slice(1) !== app.explorer.fragment()) {
      app.explorer.free();
      app.explorer = new Explorer(location.hash);
      app.changed();
    }
  });
  new ResizeObserver(app.changed).observe(document.querySelector("main"));
  return { app, draw };
}

connectTheme();
try {
  await library();
  await type();
  document.querySelector("main").hidden = false;
  const { app, draw } = connect();
  draw();
  // For scripts in the browser's console, and for tests.
  window.standfast = app;
} catch (error) {
  byId("fault").hidden = false;
  byId("fault").textContent = `The explorer did not start in this browser: ${error}`;
  throw error;
}
