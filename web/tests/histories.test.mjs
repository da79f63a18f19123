// How loads and the base go with time: shapes from a menu, and records that are dropped.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { artefacts, drawn, drop, field, launch, open, program, text, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const still = { reducedMotion: "reduce" };
const CSV = `t,a_g\n${Array.from({ length: 101 }, (_, i) => `${(0.02 * i).toFixed(2)},${(0.5 * Math.sin(6 * 0.02 * i)).toFixed(5)}`).join("\n")}\n`;
const AT2 = `PEER STRONG MOTION DATABASE RECORD\nA test\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 100, DT= .02 SEC\n${Array.from({ length: 20 }, (_, i) => Array.from({ length: 5 }, (_, j) => (0.5 * Math.sin(0.12 * (5 * i + j))).toExponential(5)).join("  ")).join("\n")}\n`;
const SMC = readFileSync(path.join(import.meta.dirname, "../../examples/records/np01002p_4225a_a.smc"), "latin1");

test("a dropped record offers to shake the body, in one step, as the program does", async () => {
  for (const [name, content] of [["shake.csv", CSV], ["shake.AT2", AT2], ["np01002p_4225a_a.smc", SMC]]) {
    const page = await open(browser, still);
    await page.evaluate(() => {
      window.standfast.explorer.open_example("rack");
      window.standfast.changed();
    });
    const first = await text(page);
    await drop(page, [[name, content]]);
    assert.equal(await page.isVisible("#offer"), true);
    await page.click("#shake");
    await drawn(page);
    assert.equal(await page.textContent("#offer-fault"), "", name);
    assert.equal(await page.isVisible("#offer"), false);
    const shaken = await text(page);
    assert.ok(shaken.endsWith(`\n[motion.base]\nhorizontal = { shape = "file", file = "${name}", target_peak = "0.25 g" }\n`), shaken);
    assert.ok(!shaken.includes("[earthquake]"));
    assert.equal(await page.isVisible("#transport"), true);
    // The program moves it the same way.
    const folder = mkdtempSync(path.join(tmpdir(), "standfast-"));
    writeFileSync(path.join(folder, "case.toml"), shaken);
    writeFileSync(path.join(folder, name), content, "latin1");
    const { summary } = JSON.parse(execFileSync(program, ["simulate", "--format", "json", "--no-figures", "--no-strength", path.join(folder, "case.toml")], { encoding: "utf8" }));
    assert.equal(await page.textContent("#answer"), summary.answer);
    await page.click("#undo");
    await drawn(page);
    assert.equal(await text(page), first);
    assert.deepEqual(page.heard, []);
    await page.close();
  }
});

test("a record that the case names is not offered, and one that is none says why", async () => {
  const page = await open(browser, still);
  await drop(page, [["notes.csv", "no record at all"]]);
  await page.click("#shake");
  await drawn(page);
  assert.notEqual(await page.textContent("#offer-fault"), "");
  await page.click("#no-shake");
  assert.equal(await page.isVisible("#offer"), false);
  await page.evaluate(() => {
    window.standfast.explorer.open_example("server-rack-earthquake");
    window.standfast.changed();
  });
  await drop(page, [["np01002p_4225c_a.smc", SMC]]);
  assert.equal(await page.isVisible("#offer"), false);
  await page.close();
});

test("a shape from the menu gives the load a history, whose numbers are fields", async () => {
  const page = await open(browser, still);
  const first = await text(page);
  await page.click("#tab-inputs");
  await page.getByLabel("breaking wave", { exact: true }).selectOption("half-sine");
  await drawn(page);
  assert.match(await text(page), /direction = "left"\nhistory = \{ shape = "half-sine", duration = "0\.4 s" \}/);
  assert.equal(await page.isVisible("#transport"), true);
  await type(page, "load[1].history.duration", "0,6");
  assert.equal((await field(page, "load[1].history.duration")).text, "0.6");
  await page.getByLabel("breaking wave", { exact: true }).selectOption("triangle");
  await drawn(page);
  assert.match(await text(page), /history = \{ shape = "triangle", rise = "0\.2 s", duration = "0\.6 s" \}/);
  await page.getByLabel("shaking of the base").selectOption("sine");
  await drawn(page);
  assert.match(await text(page), /\[motion\.base\]\nhorizontal = \{ shape = "sine", duration = "0\.4 s", period = "0\.4 s", peak = "0\.3 g" \}/);
  mkdirSync(artefacts, { recursive: true });
  await page.screenshot({ path: path.join(artefacts, "histories.png"), fullPage: true });
  for (let i = 0; i < 4; i += 1) await page.click("#undo");
  await drawn(page);
  assert.equal(await text(page), first);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("a history is drawn by hand: points dragged, added and taken away, by mouse and by keys", async () => {
  const page = await open(browser, still);
  await page.evaluate(() => {
    window.standfast.explorer.open_example("A caisson under a wave");
    window.standfast.changed();
  });
  await page.click("#tab-inputs");
  const select = page.locator("#history-wave\\.history");
  await select.selectOption("triangle");
  await drawn(page);
  assert.equal(await page.locator(".course .ring").count(), 0, "a shape has fields, and no points");
  assert.ok(await page.isVisible(".course svg"));
  await select.selectOption("points");
  await drawn(page);
  const rings = page.locator(".course .ring");
  assert.equal(await rings.count(), 3);
  const first = await text(page);
  const before = await page.textContent("#answer");

  // Dragged: the answer is another, and only that line of the text.
  await rings.nth(1).scrollIntoViewIfNeeded();
  const peak = await rings.nth(1).boundingBox();
  await page.mouse.move(peak.x + peak.width / 2, peak.y + peak.height / 2);
  await page.mouse.down();
  await page.mouse.move(peak.x + peak.width / 2 + 20, peak.y + peak.height / 2 + 55, { steps: 8 });
  await drawn(page);
  assert.equal(await text(page), first);
  await page.screenshot({ path: path.join(artefacts, "history-by-hand.png") });
  await page.mouse.up();
  await drawn(page);
  const dragged = await text(page);
  const changed = first.split("\n").filter((line, i) => line !== dragged.split("\n")[i]);
  assert.equal(changed.length, 1, dragged);
  assert.ok(changed[0].startsWith("history = { shape = \"points\", times = ["), changed[0]);
  const values = (of) => JSON.parse(/values = (\[.*?\])/.exec(of)[1]);
  assert.ok(values(dragged)[1] < 0.7 && values(dragged)[1] > 0.2, dragged);
  assert.notEqual(await page.textContent("#near"), before);

  // A click adds one, keys move it and take it away, each one step.
  const drawing = page.locator(".course .picture.drawable");
  const { width, height } = await drawing.boundingBox();
  await drawing.click({ position: { x: 0.7 * width, y: 0.4 * height } });
  await drawn(page);
  assert.equal(await rings.count(), 4);
  const added = await text(page);
  await rings.nth(1).focus();
  await page.keyboard.press("ArrowUp");
  await drawn(page);
  assert.ok(values(await text(page))[1] > values(added)[1]);
  await page.keyboard.press("Delete");
  await drawn(page);
  assert.equal(await rings.count(), 3);
  for (let i = 0; i < 3; i += 1) await page.click("#undo");
  await drawn(page);
  assert.equal(await text(page), dragged);
  await rings.nth(1).dblclick();
  await drawn(page);
  assert.equal(await rings.count(), 2);
  assert.deepEqual(page.heard, []);
  await page.close();
});
