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

/** Types into a number field. */
export async function type(page, id, text) {
  await page.fill(`#${id}`, text);
  await drawn(page);
}

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
