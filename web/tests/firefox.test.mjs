// The page in Firefox, as Debian has it: it opens, answers every example, is typed into and dragged, and its second thread answers.

import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import puppeteer from "puppeteer-core";
import { artefacts, onDisk } from "./browser.mjs";

const executablePath = process.env.FIREFOX;
const skip = executablePath ? false : "there is no Firefox";
const folder = path.join(artefacts, "firefox");
let browser;
before(async () => {
  if (!executablePath) return;
  // The window has the size, not the viewport: an older Firefox does not know all that setting one asks of it.
  const args = ["--width=1280", "--height=800"];
  browser = await puppeteer.launch({ browser: "firefox", executablePath, headless: true, defaultViewport: null, args });
  mkdirSync(folder, { recursive: true });
});
after(() => browser?.close());

async function open() {
  const page = await browser.newPage();
  page.heard = [];
  page.on("console", (message) => page.heard.push(message.text()));
  page.on("pageerror", (error) => page.heard.push(error.message));
  await page.goto(onDisk);
  await until(() => page.evaluate(() => window.standfast?.frames > 0));
  return page;
}
/** Waits for what is asked from outside: the page's policy leaves no function inside that would ask. */
async function until(asked) {
  for (let tries = 0; tries < 600; tries += 1) {
    if (await asked()) return;
    await new Promise((done) => setTimeout(done, 100));
  }
  assert.fail("waited for a minute");
}
const drawn = (page) => page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
const said = (page) => page.evaluate(() => window.standfast.said);

test("Firefox opens the page from disk and answers every example", { skip }, async (context) => {
  const page = await open();
  context.diagnostic(`${await browser.version()}, ready after ${(await page.evaluate(() => window.standfast.ready)).toFixed(0)} ms`);
  const names = await page.evaluate(() => [...document.querySelectorAll("#case-sheet [data-case]")].map((one) => one.dataset.case));
  assert.ok(names.length >= 10, `${names.length} examples`);
  for (const name of names) {
    await page.evaluate((one) => {
      window.standfast.explorer.open_example(one);
      window.standfast.changed();
    }, name);
    await drawn(page);
    const { summary, fault } = await said(page);
    assert.ok(summary?.answer && !fault, name);
    await page.screenshot({ path: path.join(folder, `${name}.png`) });
  }
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("Firefox: a number is typed, the diamond is dragged, both are undone, and a sheet is made", { skip }, async () => {
  const page = await open();
  const text = () => page.evaluate(() => window.standfast.explorer.text());
  const first = await text();
  await page.focus('input[data-key="body.width"]');
  await page.keyboard.down("Control");
  await page.keyboard.press("a");
  await page.keyboard.up("Control");
  await page.keyboard.type("16,5");
  await page.keyboard.press("Enter");
  await drawn(page);
  assert.ok((await text()).includes('width = "16.5 m"'));
  const { x, y } = await page.evaluate(() => {
    const box = document.getElementById("point").getBoundingClientRect();
    return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
  });
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 40, y - 60, { steps: 8 });
  await page.mouse.up();
  await drawn(page);
  assert.ok(!(await text()).includes("friction = 0.6\n"));
  for (let i = 0; i < 2; i++) {
    await page.click("#undo");
    await drawn(page);
  }
  assert.equal(await text(), first);
  const html = await page.evaluate(async () => (await window.standfast.askOnce("sheet 2026-11-25")).html);
  assert.ok(html.includes("Calculation sheet"));
  assert.deepEqual(page.heard, []);
  await page.close();
});
