// The page: one explorer in wasm, whose state is the text of a case; the modules beside this one hand it what a person does and show
// what it answers.

import { bytesOf, unzipped } from "letters";
import { startUnpacker, unpack } from "unpacker";
import { start, Explorer } from "library";
import { notStarted } from "fault";
import { byId, say } from "dom";
import { connectVerdict } from "verdict";
import { connectSection } from "section";
import { connectStage } from "stage";
import { connectPlate } from "plate";
import { connectTransport } from "transport";
import { connectStrengths } from "strengths";
import { connectHistories } from "histories";
import { connectForm } from "form";
import { connectPane } from "pane";
import { connectTabs } from "tabs";
import { connectWhy } from "why";
import { connectHelp } from "help";
import { connectLikely } from "likely";
import { connectTerms } from "terms";
import { connectMenus } from "menus";
import { connectFiles } from "files";
import { connectLink } from "link";
import { connectUndo } from "undo";
import { connectCompare } from "compare";
import { connectTheme } from "theme";
import { connectTeach } from "teach";
import { connectEmbed } from "embed";
import { connectAsking } from "asking";

async function library() {
  await startUnpacker({ module_or_path: await unzipped("unpacker").arrayBuffer() });
  const compiled = await WebAssembly.compile(unpack(bytesOf(byId("wasm").textContent)));
  await start({ module_or_path: compiled });
  return compiled;
}

async function type() {
  const faces = [false, true].map((italic) => new FontFace("Standfast", Explorer.font(italic), { style: italic ? "italic" : "normal" }));
  for (const face of await Promise.all(faces.map((face) => face.load()))) document.fonts.add(face);
}

async function connect(compiled) {
  const app = { explorer: new Explorer(), compiled, said: null, held: false, drag: null, frames: 0 };
  const parts = [];
  let due = 0;
  // Of all places that a hand came through since the last picture the last counts.
  app.settleDrag = () => {
    const drag = app.drag;
    app.drag = null;
    drag?.();
  };
  const draw = () => {
    due = 0;
    app.settleDrag();
    app.said = JSON.parse(app.explorer.said());
    parts.forEach((part) => part(app.said));
    const told = app.explorer.told();
    if (told) say(told);
    app.frames += 1;
  };
  // However many events come, the page is drawn once for each picture that the screen shows.
  app.changed = () => {
    due ||= requestAnimationFrame(draw);
  };
  connectAsking(app);
  for (const connectPart of [
    connectVerdict, connectTabs, connectSection, connectStage, connectPlate, connectTransport, connectStrengths, connectHistories, connectForm, connectPane,
    connectWhy, connectHelp, connectLikely, connectTerms, connectMenus, connectFiles, connectUndo, connectCompare, connectTeach,
  ]) {
    parts.push(connectPart(app));
  }
  connectEmbed(app);
  parts.push(await connectLink(app));
  // On paper stands what the tabs hide.
  for (const [event, printing] of [["beforeprint", true], ["afterprint", false]]) {
    addEventListener(event, () => {
      app.printing = printing;
      draw();
    });
  }
  new ResizeObserver(app.changed).observe(document.querySelector("main"));
  return { app, draw };
}

connectTheme();
try {
  const compiled = await library();
  await type();
  document.querySelector("main").hidden = false;
  const { app, draw } = await connect(compiled);
  draw();
  app.ready = performance.now();
  // For scripts in the browser's console, and for tests.
  window.standfast = app;
} catch (error) {
  notStarted(error);
}
