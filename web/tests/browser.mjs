// A headless Chromium, and the explorer in it. What is where comes from `cargo xtask test` through the environment.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const wanted = (name) => process.env[name] ?? assert.fail(`${name} is not set; run \`cargo xtask test\``);
export const html = wanted("EXPLORER_HTML");
export const site = wanted("EXPLORER_SITE");
export const program = wanted("STANDFAST");
export const artefacts = wanted("EXPLORER_ARTEFACTS");
export const onDisk = pathToFileURL(path.resolve(html)).href;

const FLAGS = [
  "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-background-networking",
  "--disable-component-update", "--disable-sync",
];

export const launch = () => chromium.launch({ executablePath: wanted("CHROMIUM"), args: FLAGS });

/** A page with the explorer ready. `page.heard` has everything that its console said, `page.asked` every request. */
export async function open(browser, { url = onDisk, fragment = "", ...options } = {}) {
  const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, ...options });
  page.heard = [];
  page.asked = [];
  page.on("console", (message) => page.heard.push(`${message.type()}: ${message.text()}`));
  page.on("pageerror", (error) => page.heard.push(`error: ${error.message}`));
  page.on("request", (request) => page.asked.push(request.url()));
  await page.goto(fragment ? `${url}#${fragment}` : url);
  await page.waitForFunction(() => window.standfast?.frames > 0, null, { timeout: 60_000 });
  return page;
}

/** Waits until what was done is drawn. */
export const drawn = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What axe finds wrong with a page, or with a part of it. */
export async function faults(page, part = null) {
  if (await page.evaluate(() => !window.axe)) await page.evaluate(axe);
  const found = await page.evaluate(
    async (selector) => (await window.axe.run(selector ?? document, { resultTypes: ["violations"] })).violations,
    part,
  );
  return found.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 140)).join(" | ")}`);
}

/** The field of a number, by its key: on the drawing, beside it, or in the form. */
export const numberOf = (page, key) => page.locator(`input[data-key="${key}"]:visible`).first();

/** Types into the field of a number in place of its text, key by key, and ends with a key; without one it is still being typed in. */
export async function type(page, key, text, end = "Enter") {
  await numberOf(page, key).focus();
  await page.keyboard.press("Control+A");
  await page.keyboard.press("Delete");
  for (const letter of text) {
    // Keys that no keyboard has, such as the true minus sign, are put in as by a method of input.
    if (/[!-~]/.test(letter)) await page.keyboard.press(letter);
    else if (letter === " ") await page.keyboard.press("Space");
    else await page.keyboard.insertText(letter);
  }
  if (end) await page.keyboard.press(end);
  await drawn(page);
}

/** What stands in a field and what is said about it. */
export const field = (page, key) =>
  numberOf(page, key).evaluate((input) => {
    const message = document.getElementById(input.getAttribute("aria-describedby"));
    return {
      text: input.value,
      invalid: input.getAttribute("aria-invalid") === "true",
      message: message.textContent,
      announced: message.querySelector('[role="alert"]').textContent,
    };
  });

export const said = (page) => page.evaluate(() => window.standfast.said);
export const text = (page) => page.evaluate(() => window.standfast.explorer.text());
export const mode = (page) => page.getAttribute("#symbol", "data-mode");

/** Takes a case as if it were opened. */
export async function take(page, name, content) {
  const taken = await page.evaluate(([file, toml]) => {
    const { explorer } = window.standfast;
    window.standfast.plate = "";
    const answered = explorer.open(file, toml);
    window.standfast.changed();
    return answered;
  }, [name, content]);
  await drawn(page);
  return taken;
}

/** Drops files onto the page. */
export async function drop(page, files) {
  const transfer = await page.evaluateHandle((all) => {
    const data = new DataTransfer();
    for (const [name, content] of all) data.items.add(new File([content], name));
    return data;
  }, files);
  await page.dispatchEvent("body", "dragenter", { dataTransfer: transfer });
  await page.dispatchEvent("body", "drop", { dataTransfer: transfer });
  await page.waitForTimeout(60);
  await drawn(page);
}

/** What a button of a menu saves. */
export async function saved(page, id) {
  await page.click("#save-menu > summary");
  const [download] = await Promise.all([page.waitForEvent("download"), page.click(id)]);
  return { name: download.suggestedFilename(), content: readFileSync(await download.path()) };
}

/** Two texts line by line: those that differ. */
export function lines(before, after) {
  const [one, two] = [before.split("\n"), after.split("\n")];
  assert.equal(one.length, two.length);
  return two.filter((line, i) => line !== one[i]);
}

/** Numbers that look random and are the same every time. */
export function numbers(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}
