// Compare: a case is pinned as A; it is drawn in dashes beside B, told with it in one sentence, and in a table.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { artefacts, drawn, faults, launch, lines, open, said, saved, take, text, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const example = (name) => readFileSync(path.join(import.meta.dirname, "../../examples", name), "utf8");
const DASHES = 'stroke-dasharray="7 4"';

/** A page with the first example pinned. */
async function pinned(options = {}) {
  const page = await open(browser, options);
  await page.click("#compare");
  await drawn(page);
  return page;
}

const dashes = (page, place) => page.$$eval(`${place} .picture path[stroke-dasharray="7 4"]`, (all) => all.length);
const table = (page, id) => page.$$eval(`#${id} tbody tr`, (rows) => rows.map((row) => [row.cells[0].firstChild.textContent, ...[...row.cells].slice(1).map((cell) => cell.textContent)]));
const rulers = (page) => page.$$eval("#rulers dd:not(:has(.ruler))", (all) => all.map((one) => one.textContent));

test("pinned, and nothing changed: nothing doubles, and one line says what to do", async () => {
  const page = await open(browser);
  const section = await page.innerHTML("#section .picture");
  const answer = await page.textContent("#answer");
  assert.equal(await page.getAttribute("#compare", "aria-pressed"), "false");
  assert.equal(await page.isVisible("#tab-compare"), false);
  await page.click("#compare");
  await drawn(page);
  assert.equal(await page.getAttribute("#compare", "aria-pressed"), "true");
  assert.equal(await page.getAttribute("#tab-compare", "aria-selected"), "true");
  assert.equal(await page.innerHTML("#section .picture"), section);
  assert.deepEqual([await dashes(page, "#map"), await page.textContent("#answer")], [0, answer]);
  assert.match(await page.textContent("#compare-same"), /^Nothing differs yet/);
  assert.ok(await page.isVisible("#compare-same"));
  assert.equal(await page.isVisible("#compare-inputs"), false);
  assert.ok(await page.isDisabled("#swap"));
  assert.deepEqual(await rulers(page), ["0.8240 below 1", "0.8957 below 1"]);
  // Pressed again it drops A, and the tab is the one before.
  await page.click("#compare");
  await drawn(page);
  assert.equal(await page.getAttribute("#tab-why", "aria-selected"), "true");
  assert.equal((await said(page)).compared, null);
  assert.deepEqual(page.heard, []);
  await page.close();
});

// By hand: W = 2.1 t/m³ · 9.81 · 12 b kN/m, sliding from 0.6 W on, rocking from W b/23 on; factors are those over 2700 kN/m.
test("a caisson of 17.6 m beside one of 15 m: words, numbers, dashes in both plates, table", async () => {
  const page = await pinned();
  await type(page, "body.width", "17.6");
  const factor = (width) => [(0.6 * 2.1 * 9.81 * 12 * width) / 2700, (2.1 * 9.81 * 12 * width * width) / 23 / 2700];
  const [a, b] = [factor(15), factor(17.6)].map((both) => both.map((value) => value.toPrecision(4)));
  assert.deepEqual(await rulers(page), [`${a[0]} → ${b[0]} below 1`, `${a[1]} → ${b[1]}`]);
  assert.equal(await page.textContent("#answer"), "A slides and rocks about O (SRO-). B, 17.6 m wide, slides to the left (SL).");
  const forces = [15, 17.6].map((width) => `${(0.6 * 2.1 * 9.81 * 12 * width).toFixed(0)} kN/m`);
  assert.equal(await page.textContent("#near"), `A rests up to ${forces[0]}, B up to ${forces[1]}.`);
  assert.deepEqual(await table(page, "compare-inputs"), [["width of the body", "15 m", "17.6 m"]]);
  const answers = await table(page, "compare-answers");
  assert.deepEqual(answers[0], ["mode", "SRO−", "SL"]);
  assert.deepEqual(answers[1], ["leaves rest at", ...forces]);
  assert.deepEqual(answers[2], ["safety factor against sliding", a[0], b[0]]);
  assert.equal(await page.isVisible("#compare-same"), false);
  assert.equal(await dashes(page, "#section"), 1, "the right edge of A");
  assert.ok((await dashes(page, "#map")) > 0);
  // The hollow diamond is where k = 2700/3708.18 and μ = 0.6 lie.
  const hollow = await page.$eval('#map .picture path[stroke="var(--mark,#a3123f)"][stroke-width="1.6"]', (one) => {
    const box = one.getBBox();
    return [box.x + box.width / 2, box.y + box.height / 2];
  });
  const place = await page.evaluate(() => {
    const { explorer } = window.standfast;
    const [x, y] = explorer.point();
    return { x, y };
  });
  assert.ok(Math.abs(hollow[1] - place.y) < 0.1, "one friction");
  assert.ok(hollow[0] > place.x + 5, "a lighter body has the greater k");
  await page.click('[data-plate="load"]');
  await drawn(page);
  assert.ok((await dashes(page, "#map")) > 0);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("Swap is one step, undo and redo go through it, and A stays until it is dropped", async () => {
  const page = await pinned();
  const first = await text(page);
  await type(page, "body.width", "17.6");
  const second = await text(page);
  const both = () => page.evaluate(() => [window.standfast.explorer.pinned()[1], window.standfast.explorer.text()]);
  await page.click("#swap");
  await drawn(page);
  assert.deepEqual(await both(), [second, first]);
  assert.match(await page.textContent("#answer"), /^A slides to the left \(SL\)\. B, 15 m wide, slides and rocks/);
  assert.equal(await dashes(page, "#section"), 3, "the wider A: top, bottom and right of what stands out");
  for (const [key, expected] of [["Control+z", [first, second]], ["Control+Shift+z", [second, first]], ["Control+z", [first, second]], ["Control+z", [first, first]]]) {
    await page.keyboard.press(key);
    await drawn(page);
    assert.deepEqual(await both(), expected, key);
  }
  // Another example, and a fault in the text, leave A as it is.
  await take(page, "goda.toml", example("goda-2000.toml"));
  assert.equal((await both())[0], first);
  assert.match(await page.textContent("#answer"), /^A slides and rocks about O \(SRO-\)\. B /);
  await take(page, "x.toml", "[body]\nwidht = 1\n");
  assert.equal((await both())[0], first);
  assert.ok(await page.isDisabled("#swap"));
  await page.keyboard.press("Control+z");
  await page.click("#tab-compare");
  await page.click("#drop-pinned");
  await drawn(page);
  assert.equal((await said(page)).compared, null);
  assert.equal(await page.evaluate(() => document.activeElement.id), "compare");
  assert.equal(await dashes(page, "#section"), 0);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("what stands in one of two cases alone is told as such", async () => {
  const page = await pinned();
  await take(page, "goda.toml", example("goda-on-sand.toml"));
  const rows = await table(page, "compare-inputs");
  const row = (words) => rows.find((cells) => cells[0].startsWith(words));
  assert.deepEqual(row("title of the case").slice(1), ["Caisson in air", (await said(page)).title]);
  assert.deepEqual(row("force, load 1").slice(1), ["2700 kN/m", "not given"]);
  assert.equal(row("significant wave period")[1], "not given");
  const answers = await table(page, "compare-answers");
  assert.ok(answers.some((cells) => cells[1] === "not asked"), "criteria of B alone");
  assert.match(await page.textContent("#criteria"), /^A has no criteria\. Of B /);
  assert.ok((await dashes(page, "#section")) > 0);
  await page.close();
});

test("the address holds A, and is read again", async () => {
  const page = await pinned();
  await type(page, "body.width", "17.6");
  await page.waitForFunction(() => /&a=[\w-]+&an=caisson-in-air\.toml&v=k-mu,compare$/.test(location.hash));
  const link = await page.evaluate(() => location.href);
  const again = await open(browser, { url: link });
  assert.deepEqual(await again.evaluate(() => window.standfast.explorer.pinned()), await page.evaluate(() => window.standfast.explorer.pinned()));
  assert.deepEqual(await said(again), { ...(await said(page)), can_undo: true });
  for (const place of ["#map .picture", "#section .picture", "#panel-compare"]) assert.equal(await again.innerHTML(place), await page.innerHTML(place));
  assert.equal(await again.getAttribute("#tab-compare", "aria-selected"), "true");
  assert.deepEqual(again.heard, []);
  await again.close();
  // What is no text, or none that has an answer, is refused with words, and the case itself opens.
  for (const broken of ["&a=AAAA", "&a=%%%"]) {
    const odd = await open(browser, { url: link.replace(/&a=[\w-]+/, broken) });
    assert.equal((await said(odd)).compared, null);
    assert.match(await odd.textContent("#note"), /second case that has no answer/);
    assert.match(await text(odd), /17\.6 m/);
    await odd.close();
  }
  await page.close();
});

test("a ring is dragged beside A as before, and a frame is short", async () => {
  const page = await pinned();
  await type(page, "body.width", "17.6");
  const before = await text(page);
  const box = await page.locator(".ring[data-key$=force]").boundingBox();
  const spans = await page.evaluate(async () => {
    const { explorer } = window.standfast;
    const found = [];
    explorer.grab();
    for (let i = 0; i < 30; i += 1) {
      const began = performance.now();
      explorer.drag_point(300 + i, 200);
      explorer.said();
      explorer.section(600, 400, false);
      explorer.plate("k-mu", 600, 400);
      found.push(performance.now() - began);
    }
    explorer.let_go();
    return found.sort((one, other) => one - other);
  });
  assert.ok(spans[15] < 16, `${spans[15]} ms`);
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + 4, box.y + 60, { steps: 5 });
  await drawn(page);
  assert.match(await page.textContent("#answer"), /^A slides and rocks about O \(SRO-\)\. B /);
  await page.mouse.up();
  await drawn(page);
  assert.ok(lines(before, await text(page)).length >= 1);
  assert.match(await page.textContent("#compare-inputs"), /force, load 1load\[1\]\.force2700 kN\/m/);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("motions have their histories one behind the other", async () => {
  const page = await open(browser);
  await page.evaluate(() => {
    window.standfast.explorer.open_example("server-rack-earthquake");
    window.standfast.changed();
  });
  await drawn(page);
  await page.click("#compare");
  await type(page, "body.friction", "0.2");
  assert.match(await page.textContent("#answer"), /^A .* at t = .* s\. B, with friction 0\.2, /);
  assert.ok((await page.$$('#map .picture path[stroke-dasharray="6 3.4"]')).length > 0);
  assert.ok((await table(page, "compare-answers")).some((cells) => cells[0] === "slide" && cells[1] !== cells[2]));
  const plate = (await saved(page, "#save-plate")).content.toString();
  assert.ok(plate.includes('stroke-dasharray="6 3.4"') && plate.includes("Dashed: A, "));
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("figures that are saved show both, and say so", async () => {
  const page = await pinned({ acceptDownloads: true });
  await type(page, "body.width", "17.6");
  const body = (await saved(page, "#save-body")).content.toString();
  assert.ok(body.includes(DASHES) && !body.includes("var("));
  for (const plate of ["k-mu", "load"]) {
    await page.click(`[data-plate="${plate}"]`);
    await drawn(page);
    const svg = (await saved(page, "#save-plate")).content.toString();
    assert.ok(svg.includes(DASHES) && !svg.includes("var("), plate);
    assert.match(svg, /<desc>[^<]*Dashed: A, Caisson in air[^<]*hollow diamond/);
  }
  // A part of the plane, too.
  await page.click('[data-plate="k-mu"]');
  await page.click("#closer");
  await drawn(page);
  const part = (await saved(page, "#save-plate")).content.toString();
  assert.match(part, /<desc>[^<]*Dashed: A, Caisson in air/);
  assert.equal((await saved(page, "#save-png")).content.subarray(1, 4).toString(), "PNG");
  // Tables are of B alone.
  assert.ok(!(await saved(page, "#save-csv")).content.toString().includes("Dashed"));
  await page.close();
});

test("all of it by keys: pinned, swapped, dropped, and through the tabs", async () => {
  const page = await open(browser);
  await page.focus("#compare");
  await page.keyboard.press("Enter");
  await drawn(page);
  await type(page, "body.width", "17.6");
  await page.focus("#tab-compare");
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.evaluate(() => document.activeElement.id), "tab-why");
  await page.keyboard.press("ArrowLeft");
  await drawn(page);
  await page.keyboard.press("Tab");
  for (let i = 0; i < 6 && (await page.evaluate(() => document.activeElement.id)) !== "swap"; i += 1) await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.id), "swap");
  await page.keyboard.press("Enter");
  await drawn(page);
  assert.match(await page.textContent("#answer"), /B, 15 m wide,/);
  await page.keyboard.press("Tab");
  await page.keyboard.press("Enter");
  await drawn(page);
  assert.equal(await page.getAttribute("#compare", "aria-pressed"), "false");
  await page.focus("#tab-terms");
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.evaluate(() => document.activeElement.id), "tab-why", "the tab of two cases is gone");
  // What is read aloud has both.
  await page.click("#compare");
  await type(page, "body.width", "20");
  await page.waitForFunction(() => /^A slides to the left.* B, 20 m wide, /.test(document.getElementById("live").textContent) || /^A .*B, 20 m wide, /.test(document.getElementById("live").textContent));
  await page.close();
});

test("on paper A is dashed, and the table stands below", async () => {
  const page = await pinned();
  await type(page, "body.width", "17.6");
  await page.click("#tab-why");
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await drawn(page);
  assert.ok(await page.isVisible("#compare-inputs"));
  assert.equal(await page.isVisible("#swap"), false);
  assert.equal(await dashes(page, "#section"), 1);
  mkdirSync(artefacts, { recursive: true });
  await page.pdf({ path: path.join(artefacts, "compare.pdf"), preferCSSPageSize: true });
  await page.emulateMedia({ media: "screen" });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await page.click("#tab-compare");
  await page.click("#drop-pinned");
  await drawn(page);
  await page.emulateMedia({ media: "print" });
  assert.equal(await page.isVisible("#panel-compare"), false);
  await page.close();
});

test("looks right and reads well", async () => {
  const page = await pinned();
  await type(page, "body.width", "17.6");
  mkdirSync(artefacts, { recursive: true });
  for (const theme of ["light", "dark"]) {
    await page.evaluate((name) => (document.documentElement.dataset.theme = name), theme);
    for (const [width, height] of [[390, 844], [1280, 800], [1920, 1080]]) {
      await page.setViewportSize({ width, height });
      await page.evaluate(() => scrollTo(0, 0));
      await drawn(page);
      await drawn(page);
      assert.equal(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), true, `${width} wide`);
      const least = await page.evaluate(() => Math.min(...[...document.querySelectorAll("#panel-compare *, #rulers *")].filter((one) => one.textContent && one.offsetParent !== null).map((one) => parseFloat(getComputedStyle(one).fontSize))));
      assert.ok(least >= 12, `${width}: ${least}`);
      await page.screenshot({ path: path.join(artefacts, `compare-${width}-${theme}.png`) });
      await page.screenshot({ path: path.join(artefacts, `compare-page-${width}-${theme}.png`), fullPage: true });
    }
    assert.deepEqual(await faults(page), [], theme);
  }
  // On a phone the button is in the menu.
  await page.setViewportSize({ width: 390, height: 844 });
  await drawn(page);
  await page.click("#more-menu > summary");
  assert.ok(await page.isVisible("#more-menu #compare"));
  await page.close();
});
