// A motion in time: the transport, the body that moves, the line in the histories.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import path from "node:path";
import { after, before, test } from "node:test";
import { drawn, launch, open, program } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const still = { reducedMotion: "reduce" };

async function example(name, options = still) {
  const page = await open(browser, options);
  await page.evaluate((which) => {
    window.standfast.explorer.open_example(which);
    window.standfast.changed();
  }, name);
  await drawn(page);
  return page;
}

const clock = (page) => page.textContent("#clock");
const t = (page) => page.evaluate(() => window.standfast.time.t);
const body = (page) => page.getAttribute("#stage .sf-body", "transform");

test("a case at rest has no time, and one in time begins with the body as it stands", async () => {
  const page = await example("goda-2000");
  assert.equal(await page.isVisible("#transport"), false);
  assert.equal(await page.isVisible("#stage"), false);
  await page.evaluate(() => {
    window.standfast.explorer.open_example("server-rack-earthquake");
    window.standfast.changed();
  });
  await drawn(page);
  assert.equal(await page.isVisible("#transport"), true);
  assert.equal(await clock(page), "0.0 s");
  assert.match(await page.textContent("#moment"), /^stays at rest/);
  assert.match(await body(page), /rotate\(0\.000\)$/);
  assert.equal(await page.textContent("#run"), "Play");
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("where the body is on the page, the program says it is", async () => {
  const rack = path.join(import.meta.dirname, "../../examples/motion/server-rack-earthquake.toml");
  const series = execFileSync(program, ["simulate", rack, "--no-figures", "--no-strength", "--series", "-", "--dt", "0.5"], { encoding: "utf8" });
  const rows = series.trim().split("\n").map((line) => line.split(","));
  const theta = rows[0].indexOf("theta");
  const page = await example("server-rack-earthquake");
  let turned = 0;
  for (const row of rows.slice(1, 36)) {
    await page.evaluate((at) => {
      window.standfast.time.t = at;
      window.standfast.changed();
    }, Number(row[0]));
    await drawn(page);
    const degrees = Number(/rotate\((.*)\)/.exec(await body(page))[1]);
    // Clockwise on the page; between two poses the way is straight.
    assert.ok(Math.abs(degrees + (Number(row[theta]) * 180) / Math.PI) < 0.05, `${row}: ${degrees}`);
    turned = Math.max(turned, Math.abs(degrees));
  }
  assert.ok(turned > 3);
  await page.close();
});

test("time goes on with Space, and by keys, events and the hand", async () => {
  const page = await example("server-rack-earthquake");
  const drawings = await page.evaluateHandle(() => {
    const seen = { made: 0 };
    new MutationObserver((all) => (seen.made += all.filter((one) => one.target.id === "stage").length)).observe(document.getElementById("stage"), { childList: true });
    return seen;
  });
  await page.evaluate(() => document.activeElement.blur());
  await page.keyboard.press("Space");
  assert.equal(await page.textContent("#run"), "Pause");
  await page.waitForFunction(() => window.standfast.time.t > 4);
  // The first five seconds are rest: half a second of its beginning is shown, and then that of its end.
  assert.ok((await page.evaluate(() => performance.now() - window.standfast.ready)) < 60_000);
  await page.keyboard.press("Space");
  const stopped = await t(page);
  await page.waitForTimeout(120);
  assert.equal(await t(page), stopped);
  assert.equal(await drawings.evaluate((seen) => seen.made), 0, "no drawing is made anew");

  await page.focus("#time-bar");
  await page.keyboard.press("Home");
  assert.equal(await t(page), 0);
  await page.keyboard.press("ArrowRight");
  assert.ok((await t(page)) > 0);
  await page.keyboard.press("Home");
  await page.keyboard.press("PageDown");
  const first = await t(page);
  assert.ok(Math.abs(first - 5.124) < 1e-3, "the answer says when it leaves rest");
  await page.click("#event-after");
  assert.ok((await t(page)) > first);
  await page.click("#event-before");
  assert.equal(await t(page), first);
  await page.keyboard.press("Escape");
  const bar = await page.locator("#time-bar").boundingBox();
  await page.mouse.click(bar.x + bar.width / 4, bar.y + bar.height / 2);
  const [end, now] = await page.evaluate(() => [window.standfast.motion.end, window.standfast.time.t]);
  assert.ok(Math.abs(now - end / 4) < end / 400, `${now} of ${end}`);
  assert.equal(await page.getAttribute("#time-bar", "aria-valuenow"), now.toFixed(3));
  assert.match(await page.getAttribute("#time-bar", "aria-valuetext"), /^9\.0 s, .*corner/);
  await page.close();
});

test("the line in the histories is at the same moment, and moves it", async () => {
  const page = await example("statue-earthquake");
  const plot = await page.evaluate(() => window.standfast.explorer.histories_plot().map((place) => place * window.standfast.plateScale));
  const box = await page.locator("#map .picture").boundingBox();
  const x = box.x + plot[0] + 0.3 * (plot[2] - plot[0]);
  await page.mouse.move(box.x + plot[0] + 5, box.y + 60);
  await page.mouse.down();
  await page.mouse.move(x, box.y + 80);
  await page.mouse.up();
  const share = await page.evaluate(() => window.standfast.time.t / window.standfast.motion.end);
  assert.ok(Math.abs(share - 0.3) < 0.005, String(share));
  const cursor = await page.locator("#cursor").boundingBox();
  assert.ok(Math.abs(cursor.x - x) < 2, `${cursor.x} ${x}`);
  await page.click('[data-plate="load"]');
  await drawn(page);
  assert.equal(await page.isVisible("#cursor"), false);
  await page.close();
});

test("from the earth the floor moves, and small moves are drawn larger and say so", async () => {
  const page = await example("server-rack-earthquake");
  const floor = async (at) => {
    await page.evaluate((moment) => {
      window.standfast.time.t = moment;
      window.standfast.changed();
    }, at);
    await drawn(page);
    return page.getAttribute("#stage .sf-floor", "transform");
  };
  assert.equal(await floor(7), "translate(0.00 0)");
  await page.click("#from-earth");
  assert.notEqual(await floor(7), "translate(0.00 0)");
  await page.close();

  const caisson = await example("caisson-breaking-wave");
  assert.equal(await caisson.textContent("#moment"), "stays at rest · moves drawn 10 × as large");
  assert.equal(await caisson.isVisible("#views"), false, "its ground stands still");
  await caisson.close();
});

test("a motion runs when it is opened, not for those who want none, and a frame is short", async () => {
  const page = await example("server-rack-earthquake", { reducedMotion: "no-preference" });
  await page.waitForFunction(() => window.standfast.time.t > 6);
  const spans = await page.evaluate(async () => {
    const found = [];
    const { showMoment } = window.standfast;
    window.standfast.showMoment = (at) => {
      const began = performance.now();
      const shown = showMoment(at);
      found.push(performance.now() - began);
      return shown;
    };
    await new Promise((done) => setTimeout(done, 1500));
    return found.sort((one, other) => one - other);
  });
  assert.ok(spans.length > 10, `${spans.length} frames`);
  assert.ok(spans[Math.floor(spans.length / 2)] < 16, `${spans[Math.floor(spans.length / 2)]} ms`);
  await page.close();
  const quiet = await example("server-rack-earthquake");
  await quiet.waitForTimeout(150);
  assert.equal(await t(quiet), 0);
  await quiet.close();
});

test("another case may come while a motion runs", async () => {
  const page = await example("server-rack-earthquake", { reducedMotion: "no-preference" });
  await page.evaluate(async () => {
    window.standfast.explorer.open_example("goda-2000");
    await new Promise((done) => setTimeout(done, 80));
    window.standfast.changed();
  });
  await drawn(page);
  assert.equal(await page.isVisible("#transport"), false);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("how much stronger a shaking overturns the body comes by itself, as the program says it", async () => {
  const page = await example("server-rack-earthquake");
  const rack = path.join(import.meta.dirname, "../../examples/motion/server-rack-earthquake.toml");
  const { summary } = JSON.parse(execFileSync(program, ["simulate", rack, "--format", "json", "--no-figures"], { encoding: "utf8" }));
  await page.waitForSelector("#strengths:not([hidden]) svg", { timeout: 30_000 });
  assert.equal(await page.textContent("#near"), summary.near);
  assert.match(summary.near, /stronger \([\d.]+ g to the sides\) overturns it/);
  assert.match(await page.textContent("#strengths desc"), /^Of 47 factors on the loads \d+ overturn it/);
  // Of another text it is looked for anew.
  await page.evaluate(() => {
    window.standfast.explorer.set("body.friction", "0.36");
    window.standfast.changed();
  });
  await drawn(page);
  assert.equal(await page.isVisible("#strengths"), false);
  await page.close();
});
