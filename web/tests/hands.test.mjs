// Mouse, fingers and keys.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { drawn, launch, mode, open, reading } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const given = async (page) => (await reading(page)).numbers.given;
const centre = async (page, selector) => {
  const box = await page.locator(selector).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};
const title = (page) => page.textContent("#map svg title");
const description = (page) => page.textContent("#map .picture svg desc");

test("every control is reached by the Tab key, in the order of the page", async () => {
  const page = await open(browser);
  await page.click("summary");
  await drawn(page);
  const all = await page.evaluate(() => {
    const selector = "a[href], button:not(:disabled), input, select, summary, .scroll";
    const found = [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility());
    found.forEach((one, i) => (one.dataset.order = i));
    found[0].focus();
    return found.length;
  });
  assert.ok(all > 35, `${all} controls`);
  const order = [0];
  for (let i = 1; i < all; i++) {
    await page.keyboard.press("Tab");
    order.push(await page.evaluate(() => Number(document.activeElement.dataset.order ?? -1)));
  }
  assert.deepEqual(order, Array.from({ length: all }, (_, i) => i));
  await page.close();
});

test("keys move the design point, the view and the sliders, and the verdict is read aloud", async () => {
  const page = await open(browser);
  await page.focus("#point");
  const [, , k, mu] = await given(page);
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowRight");
  for (let i = 0; i < 5; i++) await page.keyboard.press("ArrowDown");
  await drawn(page);
  const [, , k2, mu2] = await given(page);
  assert.ok(k2 > k && mu2 < mu);
  assert.equal(await page.evaluate(() => document.activeElement.id), "point");
  assert.match(await page.getAttribute("#point", "aria-label"), /Design point: k /);
  for (let i = 0; i < 40; i++) await page.keyboard.press("ArrowLeft");
  await drawn(page);
  assert.equal(await mode(page), "RE");
  await page.waitForFunction(() => document.getElementById("live").textContent.match(/^RE: the body stays at rest, with a safety factor of \S+ against \S+\. The answer is unique\./));

  const whole = await description(page);
  await page.keyboard.press("+");
  await drawn(page);
  const near = await description(page);
  assert.notEqual(near, whole);
  await page.keyboard.press("Shift+ArrowUp");
  await drawn(page);
  assert.notEqual(await description(page), near);
  await page.keyboard.press("0");
  await drawn(page);
  assert.equal(await description(page), whole);

  await page.focus('[data-slider="slenderness"]');
  const [gamma] = await given(page);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("ArrowRight");
  await drawn(page);
  assert.ok((await given(page))[0] > gamma);
  await page.keyboard.press("Home");
  await drawn(page);
  assert.equal((await given(page))[0], 0.1);

  await page.focus("#case-point");
  await page.keyboard.press("ArrowUp");
  await page.keyboard.press("ArrowRight");
  await drawn(page);
  assert.ok((await given(page))[0] > 0.1);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("the design point is dragged, and placed by a click, without the axes moving", async () => {
  const page = await open(browser);
  const axes = await description(page);
  const [x, y] = await centre(page, "#point");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y + 10, { steps: 4 });
  await page.mouse.move(x - 120, y - 40, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
  const [x2, y2] = await centre(page, "#point");
  assert.ok(Math.hypot(x2 - (x - 120), y2 - (y - 40)) < 1.5, "the point is where the hand left it");
  const [, , k, mu] = await given(page);
  assert.ok(k < 0.8 && mu > 0.6);
  assert.equal(await description(page), axes);

  await page.mouse.click(x + 100, y + 30);
  await drawn(page);
  const [x3, y3] = await centre(page, "#point");
  assert.ok(Math.hypot(x3 - (x + 100), y3 - (y + 30)) < 1.5);
  assert.equal(await page.evaluate(() => document.activeElement.id), "point");
  await page.close();
});

test("the background pans, the wheel zooms about its place, All shows all", async () => {
  const page = await open(browser);
  const before = await given(page);
  const box = await page.locator("#map .picture").boundingBox();
  const [x, y] = [box.x + box.width * 0.55, box.y + box.height * 0.5];
  const whole = await description(page);
  await page.mouse.move(x, y);
  await page.keyboard.down("Control");
  await page.mouse.wheel(0, -200);
  await page.keyboard.up("Control");
  await drawn(page);
  const near = await description(page);
  assert.notEqual(near, whole);
  await page.mouse.down();
  await page.mouse.move(x - 80, y + 60, { steps: 5 });
  await page.mouse.up();
  await drawn(page);
  assert.notEqual(await description(page), near);
  assert.deepEqual(await given(page), before, "moving about does not move the point");
  await page.click("#reset");
  await drawn(page);
  assert.equal(await description(page), whole);
  // As near and as far as it goes.
  await page.evaluate(() => {
    const times = (count, id) => Array.from({ length: count }, () => document.getElementById(id).click());
    times(80, "closer");
    times(160, "farther");
  });
  await drawn(page);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("two fingers zoom", async () => {
  const page = await open(browser, { hasTouch: true, viewport: { width: 420, height: 800 } });
  const whole = await description(page);
  await page.evaluate(() => {
    const picture = document.querySelector("#map .picture");
    const box = picture.getBoundingClientRect();
    const send = (type, pointerId, x, y) =>
      picture.dispatchEvent(new PointerEvent(type, { pointerId, pointerType: "touch", clientX: box.left + x, clientY: box.top + y, bubbles: true }));
    picture.setPointerCapture = () => {};
    send("pointerdown", 11, 120, 150);
    send("pointerdown", 12, 220, 150);
    for (let i = 1; i <= 5; i++) send("pointermove", 12, 220 + 12 * i, 150);
    send("pointerup", 11, 120, 150);
    send("pointerup", 12, 280, 150);
  });
  await drawn(page);
  assert.notEqual(await description(page), whole);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("a click in the map of cases takes the body there", async () => {
  const page = await open(browser);
  const picture = page.locator("#cases .picture");
  const box = await picture.boundingBox();
  const words = [];
  for (const [across, up] of [[0.3, 0.7], [0.85, 0.85], [0.85, 0.42], [0.3, 0.2]]) {
    await picture.click({ position: { x: box.width * across, y: box.height * (1 - up) } });
    await drawn(page);
    words.push((await page.textContent("#case")).match(/case 1a|cases 2 and 3|Δ > 0|Δ ≤ 0/)?.[0]);
  }
  assert.deepEqual(words, ["case 1a", "cases 2 and 3", "Δ > 0", "Δ ≤ 0"]);
  await page.close();
});

test("all 26 figures of the report are presets, and a moved slider returns to the map of all modes", async () => {
  const page = await open(browser);
  const numbers = await page.$$eval("#figure optgroup option", (options) => options.map((option) => option.value));
  assert.equal(numbers.length, 26);
  for (const number of numbers) {
    await page.selectOption("#figure", number);
    await drawn(page);
    assert.ok((await page.textContent("#map .picture svg title")).startsWith(`Fig. ${number} `), number);
  }
  await page.selectOption("#figure", "3.10");
  await page.click("#next");
  await drawn(page);
  assert.equal((await reading(page)).figure, "3.11");
  await page.focus('[data-slider="slenderness"]');
  await page.keyboard.press("ArrowLeft");
  await drawn(page);
  assert.match(await title(page), /^All modes/);
  assert.equal(await page.inputValue("#figure"), "");
  await page.close();
});

test("however many events come, there is one drawing a frame; the time it takes is reported", async (context) => {
  const page = await open(browser);
  const result = await page.evaluate(async () => {
    const slider = document.querySelector('[data-slider="slenderness"]');
    const { explorer } = window.standfast;
    const frame = () => new Promise(requestAnimationFrame);
    await frame();
    const drawnBefore = window.standfast.frames;
    const gaps = [];
    let last = performance.now();
    for (let i = 0; i < 120; i++) {
      for (let j = 0; j < 5; j++) {
        slider.value = 0.3 + (i + j / 5) / 300;
        slider.dispatchEvent(new Event("input"));
      }
      await frame();
      gaps.push(performance.now() - last);
      last = performance.now();
    }
    const started = performance.now();
    for (let i = 0; i < 50; i++) {
      explorer.slide("slenderness", 0.3 + i / 100);
      explorer.map(900, 560);
      explorer.reading();
    }
    const library = (performance.now() - started) / 50;
    return { drawn: window.standfast.frames - drawnBefore, library, median: gaps.sort((a, b) => a - b)[60] };
  });
  context.diagnostic(`diagram and reading by the library: ${result.library.toFixed(2)} ms; frame while dragging, without a graphics card: ${result.median.toFixed(1)} ms`);
  assert.ok(result.drawn <= 121, `${result.drawn} drawings in 120 frames`);
  assert.ok(result.drawn >= 100);
  await page.close();
});
