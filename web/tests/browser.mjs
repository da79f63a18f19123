// A headless Chromium, and the explorer in it. What is where comes from `cargo xtask test` through the environment.

import assert from "node:assert/strict";
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

/** Types into a number field in place of its text, key by key, and ends with a key; without one the field is still being typed in. */
export async function type(page, id, text, end = "Enter") {
  await page.focus(`#${id}`);
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
export const field = (page, id) =>
  page.evaluate((name) => {
    const input = document.getElementById(name);
    const message = document.getElementById(input.getAttribute("aria-describedby"));
    return {
      text: input.value,
      invalid: input.getAttribute("aria-invalid") === "true",
      message: message.textContent,
      announced: message.querySelector('[role="alert"]').textContent,
    };
  }, id);

export const reading = (page) => page.evaluate(() => window.standfast.reading);
export const mode = (page) => page.getAttribute("#symbol", "data-mode");

/** Numbers that look random and are the same every time. */
export function numbers(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Whether a text speaks of a body in these words, and of one at rest with the lesser of its factors, if there is one. */
export function says(text, words, { mode, sliding, overturning }) {
  const said = text.match(/he body (.*?)(?:, with a safety factor of (\S+) against (sliding|overturning))?\.(?: |$)/);
  if (!said || said[1] !== words.replaceAll("'", "′")) return false;
  const lesser = Math.min(sliding ?? Infinity, overturning ?? Infinity);
  if (mode !== "RE" || lesser === Infinity) return said[2] === undefined;
  const against = overturning < sliding ? "overturning" : "sliding";
  // Three digits are shown.
  return said[3] === against && Math.abs(Number(said[2]) / lesser - 1) <= 5e-3;
}
