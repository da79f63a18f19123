// What would help: a row for each number, the value written by a button, and the boundary of two numbers.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { artefacts, drawn, faults, launch, lines, open, program, said, take, text } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const example = (name) => readFileSync(path.join(import.meta.dirname, "../../examples", name), "utf8");
const criteria = "\n[criteria]\nSF_sliding = 1.2\nSF_overturning_net = 1.2\nbearing_max = \"400 kPa\"\n";
const goda = `${example("goda-2000.toml")}${criteria}`;

/** A page with a case and the tab open, all rows found. */
async function helped(content, options = {}) {
  const page = await open(browser, options);
  await take(page, "case.toml", content);
  await page.click("#tab-help");
  await found(page);
  return page;
}

const found = (page) => page.waitForFunction(() => document.getElementById("help-state").textContent.startsWith("Values are"), null, { timeout: 120_000 });
const boundary = (page) => page.waitForFunction(() => document.querySelector("#two-picture svg") !== null, null, { timeout: 240_000 });

/** The rows, as a person reads them. */
const rows = (page) => page.$$eval("#changes li", (all) => all.map((row) => ({
  what: row.querySelector(".what").firstChild.textContent,
  value: row.querySelector(".found").lastChild.textContent,
  way: row.querySelector(".way").textContent.trim(),
  share: row.querySelector(".share").textContent,
  button: row.querySelector("button")?.getAttribute("aria-label") ?? null,
})));

/** The program's list, by a file of the same text. */
function listed(content) {
  const folder = path.join(tmpdir(), `standfast-help-${process.pid}`);
  mkdirSync(folder, { recursive: true });
  const file = path.join(folder, "case.toml");
  writeFileSync(file, content);
  return JSON.parse(execFileSync(program, ["design", file, "--format", "json"], { encoding: "utf8" }));
}

/** What the program says of a text with another value, by a design of that number alone. */
function designed(content, vary, target, wanted) {
  const folder = path.join(tmpdir(), `standfast-help-${process.pid}`);
  mkdirSync(folder, { recursive: true });
  const file = path.join(folder, "one.toml");
  writeFileSync(file, content);
  return JSON.parse(execFileSync(program, ["design", file, "--vary", vary, "--target", target, `--${wanted}`, "--format", "json"], { encoding: "utf8" })).found.printed;
}

const minus = (words) => words.replaceAll("-", "−");

for (const [name, content] of [["goda", goda], ["goda-on-sand", example("goda-on-sand.toml")], ["server-rack", example("server-rack.toml")], ["quay", example("quay.toml")]]) {
  test(`the rows are those of the program: ${name}`, async () => {
    const page = await helped(content);
    const list = listed(content);
    const told = list.changes.filter((row) => row.printed !== null);
    const shown = await rows(page);
    assert.deepEqual(shown.map(({ what, value, share }) => [what, value, share]), told.map((row) => [row.words, minus(row.printed), minus(row.change)]));
    assert.ok(shown.length > 4);
    const others = await page.$$eval("#others li", (all) => all.map((row) => row.textContent));
    assert.deepEqual(others, list.changes.filter((row) => row.printed === null).map((row) => `${row.words}: ${row.why}.`));
    if (!list.summary.met) {
      for (const row of told.slice(0, 3)) assert.equal(row.printed, designed(content, row.vary, "criteria", row.wanted));
      assert.deepEqual(shown.map(({ button }) => button), told.map((row) => `Try ${row.words} ${minus(row.printed)}`));
    } else {
      assert.ok(shown.every(({ button, way }) => button === null && /^(down|up) to$/.test(way)));
    }
    assert.deepEqual(page.heard, []);
    await page.close();
  });
}

test("Try writes the value and what goes with it, as one step; the criteria are met", async () => {
  const page = await helped(goda);
  assert.equal((await said(page)).summary.met, false);
  const count = (await rows(page)).length;
  for (let i = 0; i < count; i += 1) {
    const button = page.locator("#changes li button").nth(i);
    const label = await button.getAttribute("aria-label");
    await button.focus();
    await page.keyboard.press("Enter");
    await drawn(page);
    const now = await said(page);
    assert.equal(now.summary.met, true, label);
    assert.match(await page.textContent("#criteria"), /met/);
    const changed = lines(goda, await text(page));
    assert.ok(changed.length >= 1 && changed.length <= 4, `${label}: ${changed.join("\n")}`);
    assert.equal(await page.evaluate(() => document.activeElement.id), "help-heading");
    // What is met has reserves, and no buttons.
    await page.waitForFunction(() => document.querySelector("#changes li .way")?.textContent.includes("to"), null, { timeout: 60_000 });
    assert.equal(await page.locator("#changes button").count(), 0);
    await page.keyboard.press("Control+z");
    await drawn(page);
    assert.equal(await text(page), goda);
    await found(page);
    await page.waitForFunction((all) => document.querySelectorAll("#changes li button").length === all, count, { timeout: 60_000 });
  }
  await page.locator("#changes li button").first().click();
  await drawn(page);
  // Wider: the mass, the buoyant weight and the base in the waves' formula go with it, and the comment says of which weight it is.
  const changed = lines(goda, await text(page));
  assert.deepEqual(changed.map((line) => line.split(" = ")[0]), ["width", "mass", "buoyant_weight", "caisson_width"]);
  assert.ok(changed[2].endsWith("# was 2318.64 kN/m: 15 m (3.4 m 2400 + 7.1 m (2100 - 1030)) kg/m3 9.81 m/s2"), changed[2]);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("a Try of a case that is gone does nothing", async () => {
  const page = await helped(goda);
  const later = await page.evaluate(() => {
    const button = document.querySelector("#changes li button");
    window.standfast.explorer.set("body.friction", "0.55");
    button.click();
    return window.standfast.explorer.text();
  });
  assert.match(later, /friction = 0\.55/);
  assert.match(later, /width = "15 m"/);
  await page.close();
});

test("of a case that rests or of a motion the reserve is told; of what cannot be assessed, why", async () => {
  const page = await helped(example("caisson-in-air.toml"));
  assert.match(await page.textContent("#help-heading"), /^(One change with which the body rests|The body rests under the full load\. How far)/);
  await page.evaluate(() => {
    window.standfast.explorer.open_example("block-base-pulse");
    window.standfast.changed();
  });
  await page.waitForFunction(() => document.getElementById("help-fault").textContent !== "", null, { timeout: 60_000 });
  assert.match(await page.textContent("#help-fault"), /has no first instant/);
  assert.equal(await page.locator("#changes li").count(), 0);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("two numbers have the boundary of the program, and others may be chosen", async () => {
  const content = example("server-rack.toml");
  const page = await helped(content);
  await boundary(page);
  const chosen = await page.$$eval("#two select", (all) => all.map((select) => select.value));
  assert.equal(chosen[0], "body.width");
  const first = await page.innerHTML("#two-picture");
  assert.match(first, /var\(--feasible,/);
  // The case as it stands is marked.
  assert.match(first, /var\(--mark,/);
  await page.selectOption("#two-across", "load[1].force");
  await page.waitForFunction((before) => document.getElementById("two-picture").innerHTML !== before, first, { timeout: 240_000 });
  assert.match(await page.textContent("#two-words"), /^Shaded: .*Of body\.width, all from 0\.16 m to 4 m was searched/);
  assert.equal(await page.$eval('#two-across option[value="body.width"]', (option) => option.disabled), true);
  assert.deepEqual(page.heard, []);
  await page.close();
});

const STATES = [["not-met", goda], ["met", example("quay.toml")], ["sand", example("goda-on-sand.toml")]];
for (const [name, content] of STATES) {
  test(`looks right and reads well: ${name}`, async () => {
    const page = await helped(content);
    await boundary(page);
    mkdirSync(artefacts, { recursive: true });
    for (const theme of ["light", "dark"]) {
      await page.evaluate((dark) => (document.documentElement.dataset.theme = dark), theme);
      for (const [width, height] of [[390, 844], [1280, 800], [1920, 1080]]) {
        await page.setViewportSize({ width, height });
        await drawn(page);
        await page.locator(".tabs").scrollIntoViewIfNeeded();
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true, `${width} wide`);
        // No label of the drawing is under 12 px, and no words of the tab.
        const least = await page.evaluate(() => {
          const sizes = [...document.querySelectorAll("#panel-help *")].filter((one) => one.childNodes.length > 0 && !one.closest("svg") && one.offsetParent !== null).map((one) => parseFloat(getComputedStyle(one).fontSize));
          const svg = document.querySelector("#two-picture svg");
          const scale = svg.getBoundingClientRect().width / svg.viewBox.baseVal.width;
          return [Math.min(...sizes), 12.5 * scale];
        });
        assert.ok(least[0] >= 12 && least[1] >= 12, `${width}: ${least}`);
        await page.locator("#panel-help").screenshot({ path: path.join(artefacts, `help-${name}-${width}-${theme}.png`) });
        await page.evaluate(() => scrollTo(0, 0));
        if (name === "not-met") await page.screenshot({ path: path.join(artefacts, `help-page-${width}-${theme}.png`), fullPage: true });
      }
      assert.deepEqual(await faults(page, "#panel-help"), [], theme);
    }
    await page.close();
  });
}
