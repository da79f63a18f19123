// Links, files, motion, looks.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import path from "node:path";
import { after, before, test } from "node:test";
import { artefacts, drawn, launch, mode, numbers, onDisk, open, reading, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const MODES = {
  RE: "g=0.8&kp=0.9&k=0.3&mu=0.6",
  SL: "g=1&kp=0.4&k=0.8&mu=0.4",
  RO: "g=3&kp=0.8&k=0.6&mu=0.4",
  "SRO-": "g=0.8&kp=0.9&k=0.8&mu=0.6",
  "SRO+": "g=3&kp=0.8&k=1.7&mu=0.05",
  "SRO'-": "g=1&kp=-0.6&k=5&mu=0.5",
  "RO'": "g=3&kp=0.8&k=0.6&mu=0.4&to=right",
  "SL+": "g=1&kp=0.4&k=0.8&mu=0.4&to=right",
  "SRO'+": "g=0.8&kp=0.9&k=0.8&mu=0.6&to=right",
};

test("a link holds the whole state", async () => {
  const next = numbers(11);
  for (let i = 0; i < 6; i++) {
    const page = await open(browser);
    await type(page, "slenderness", String(0.3 + 3 * next()));
    await type(page, "elevation", String(2 * next() - 1));
    await type(page, "force", String(2 * next()));
    await type(page, "friction", String(2 * next()));
    await type(page, "width", String(5 + 10 * next()));
    await page.selectOption('[data-unit="force"]', "MN/m");
    if (i % 2 === 0) await page.selectOption("#direction", "right");
    if (i === 3) await page.selectOption("#figure", "4.7a");
    await page.click("#closer");
    await page.waitForTimeout(500);
    const link = page.url();
    const again = await browser.newPage({ viewport: { width: 1280, height: 900 } });
    await again.goto(link);
    await again.waitForFunction(() => window.standfast?.frames > 0);
    assert.deepEqual(await reading(again), await reading(page));
    assert.equal(await again.innerHTML("#map .picture"), await page.innerHTML("#map .picture"));
    await again.close();
    await page.close();
  }
});

test("nonsense in a link does no harm, and a changed link changes the page", async () => {
  const page = await open(browser, { fragment: "g=-1&kp=NaN&view=3,2,1&fig=<script>&%%%" });
  assert.equal(await mode(page), "SRO-");
  await page.evaluate(() => (location.hash = "g=1&kp=1&k=2&mu=5"));
  await page.waitForFunction(() => document.getElementById("symbol").dataset.mode === "RO");
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("the diagram is saved as SVG and PNG, its curves as CSV", async () => {
  const page = await open(browser, { acceptDownloads: true, fragment: "g=3&kp=0.8&k=1.7&mu=0.05" });
  const saved = async (id) => {
    const [download] = await Promise.all([page.waitForEvent("download"), page.click(id)]);
    return { name: download.suggestedFilename(), content: readFileSync(await download.path()) };
  };
  const svg = await saved("#save-svg");
  assert.match(svg.name, /\.svg$/);
  const text = svg.content.toString();
  assert.ok(!text.includes("var("), "colours are fixed");
  assert.match(text, /<title>All modes/);
  const sound = await page.evaluate((source) => new DOMParser().parseFromString(source, "image/svg+xml").querySelector("parsererror") === null, text);
  assert.ok(sound);

  const png = await saved("#save-png");
  assert.equal(png.content.subarray(1, 4).toString(), "PNG");
  assert.ok(png.content.readUInt32BE(16) > 1500, "wide enough to print");

  const csv = await saved("#save-csv");
  const [header, ...rows] = csv.content.toString().trim().split("\n");
  assert.equal(header, "what,k,mu");
  const parsed = rows.map((row) => row.match(/^"([^"]+)",([^,]+),([^,]+)$/) ?? assert.fail(row));
  // μ* = (|a|k − b)/(ck + d) with a = 13 − 27 k', b = 9, c = 9 (1 + k'), d = 37.
  const rising = parsed.filter(([, name]) => name.includes("(|a|k − b)"));
  assert.equal(rising.length, 101);
  for (const [, , k, mu] of rising) {
    assert.ok(Math.abs(Number(mu) - (8.6 * k - 9) / (16.2 * k + 37)) < 1e-12);
  }
  assert.ok(parsed.some(([, name, k]) => name === "point E" && Math.abs(k - 9 / 8.6) < 1e-12));
  await page.close();
});

test("the motion of every mode is shown, and none where a reader wants none", async () => {
  const moves = (page) => page.evaluate(() => document.querySelector("#body .body").getAnimations().length);
  for (const [symbol, fragment] of Object.entries(MODES)) {
    const page = await open(browser, { fragment });
    assert.equal(await mode(page), symbol);
    await page.waitForTimeout(450);
    assert.equal(await moves(page), symbol === "RE" ? 0 : 1, symbol);
    const ghost = await page.locator('#body [stroke-dasharray="3 2.4"]').count();
    assert.equal(ghost, symbol === "RE" ? 0 : 1, symbol);
    assert.match(await page.textContent("#body-note"), symbol === "RE" ? /at rest/ : /exaggerated/);
    await page.close();
  }
  const page = await open(browser, { fragment: MODES.RO, reducedMotion: "reduce" });
  await page.waitForTimeout(450);
  assert.equal(await moves(page), 0);
  await page.click("#play");
  assert.equal(await moves(page), 1);
  await page.click("#play");
  assert.equal(await moves(page), 0);
  await page.close();
});

test("uplift lowers the load factor at which the body leaves rest", async () => {
  const page = await open(browser, { fragment: "g=0.8&kp=0.2&k=0.5&mu=0.6" });
  await page.click("summary");
  await page.waitForSelector("#path-picture svg");
  const factor = async () => Number((await page.textContent("#path-words")).match(/λ = ([\d.]+)/)[1]);
  assert.equal(await factor(), 1.2); // μ/k: it slides
  await type(page, "uplift", "60");
  // 60 kPa under 15 m, triangular: 450 kN/m of 3708.18 kN/m; λ k = μ (1 − λ 450/3708.18).
  assert.ok(Math.abs((await factor()) - 0.6 / (0.5 + (0.6 * 450) / 3708.18)) < 1e-3);
  assert.deepEqual(page.heard, []);
  await page.close();
});

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
for (const colorScheme of ["light", "dark"]) {
  test(`axe finds no fault, ${colorScheme}`, async () => {
    for (const [width, fragment] of [[1280, MODES["SRO'-"]], [360, MODES["SRO+"]], [1280, "g=1&kp=-0.6&k=9&mu=5"], [1280, "fig=2.1"], [1280, "sea=8&up=60000"], [360, "sea=8&k=0&up=500000"]]) {
      const page = await open(browser, { colorScheme, viewport: { width, height: 900 }, fragment });
      if ((await page.getAttribute("#path", "open")) === null) await page.click("summary");
      await page.waitForSelector("#path-picture svg");
      await type(page, "mass", "0");
      await page.evaluate(axe);
      const { violations } = await page.evaluate(() => window.axe.run());
      const faults = violations.map(({ id, nodes }) => `${id}: ${nodes.map((node) => node.html.slice(0, 120)).join(" | ")}`);
      assert.deepEqual(faults, []);
      await page.close();
    }
  });
}

test("pictures of the page at three widths, without sideways scrolling", async () => {
  mkdirSync(artefacts, { recursive: true });
  const looks = [["", "case"], ["g=0.8&kp=0.9&k=0.5&mu=0.6&sea=8&lee=8&up=60000", "water"], ["g=1&kp=-0.6&k=9&mu=5", "indeterminate"], ["fig=3.11", "figure"], ["g=10&kp=1&k=0.2&mu=0.05", "slender"]];
  for (const [width, height] of [[320, 640], [360, 740], [1280, 900], [2560, 1440], [3840, 2160]]) {
    for (const colorScheme of ["light", "dark"]) {
      for (const [fragment, name] of looks) {
        const page = await open(browser, { colorScheme, viewport: { width, height }, fragment });
        const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.equal(over, 0, `${name} at ${width}`);
        await page.waitForTimeout(50);
        if ([360, 1280, 2560].includes(width)) {
          await page.screenshot({ path: path.join(artefacts, `${name}-${width}-${colorScheme}.png`), fullPage: width === 360 });
        }
        await page.close();
      }
    }
  }
});

test("works with the network off", async () => {
  const context = await browser.newContext({ offline: true });
  const page = await context.newPage();
  await page.goto(onDisk);
  await page.waitForFunction(() => window.standfast?.frames > 0);
  assert.equal(await mode(page), "SRO-");
  await context.close();
});
