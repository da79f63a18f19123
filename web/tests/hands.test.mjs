// Mouse, fingers and keys; files dropped, changed, undone, saved.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { artefacts, drawn, drop, launch, lines, mode, numberOf, open, said, saved, take, text, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const example = (name) => readFileSync(path.join(root, "examples", name), "utf8");
const centre = async (page, selector) => {
  const box = await page.locator(selector).boundingBox();
  return [box.x + box.width / 2, box.y + box.height / 2];
};
const description = (page) => page.textContent("#map .picture svg desc");
const choose = async (page, name) => {
  await page.click("#case-menu > summary");
  await page.click(`[data-case="${name}"]`);
  await drawn(page);
};

test("every control is reached by the Tab key, in the order of the page", async () => {
  const page = await open(browser);
  for (const tab of ["why", "likely", "inputs", "terms"]) {
    await page.click(`#tab-${tab}`);
    await drawn(page);
    const all = await page.evaluate(() => {
      document.querySelectorAll("[data-order]").forEach((one) => delete one.dataset.order);
      const selector = "a[href], button:not(:disabled):not([tabindex='-1']), input, select, textarea, summary, .scroll, [role=tabpanel]";
      const found = [...document.querySelectorAll(selector)].filter((one) => one.checkVisibility());
      found.forEach((one, i) => (one.dataset.order = i));
      found[0].focus();
      return found.length;
    });
    assert.ok(all > 24, `${all} controls`);
    const order = [0];
    for (let i = 1; i < all; i++) {
      await page.keyboard.press("Tab");
      order.push(await page.evaluate(() => Number(document.activeElement.dataset.order ?? -1)));
    }
    assert.deepEqual(order, Array.from({ length: all }, (_, i) => i), tab);
  }
  await page.close();
});

test("keys move the design point and the view, and the answer is read aloud", async () => {
  const page = await open(browser);
  await page.focus("#point");
  const [, , k, mu] = (await said(page)).point;
  for (let i = 0; i < 5; i++) {
    await page.keyboard.press("ArrowRight");
    await drawn(page);
  }
  for (let i = 0; i < 5; i++) {
    await page.keyboard.press("ArrowDown");
    await drawn(page);
  }
  const [, , k2, mu2] = (await said(page)).point;
  assert.ok(k2 > k && mu2 < mu, `${k2} ${mu2}`);
  assert.equal(await page.evaluate(() => document.activeElement.id), "point");
  assert.match(await page.getAttribute("#point", "aria-label"), /^Design point/);
  for (let i = 0; i < 40; i++) {
    await page.keyboard.press("ArrowLeft");
    await drawn(page);
  }
  assert.equal(await mode(page), "RE");
  await page.waitForFunction(() => document.getElementById("live").textContent.match(/^The body stays at rest \(RE\)\. At \S+ % of the breaking wave/));

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
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("tabs and menus go by keys", async () => {
  const page = await open(browser);
  await page.focus("#tab-why");
  for (const [key, tab] of [["ArrowRight", "help"], ["ArrowRight", "likely"], ["ArrowRight", "inputs"], ["ArrowRight", "whole"], ["End", "terms"], ["ArrowRight", "why"], ["ArrowLeft", "terms"], ["Home", "why"]]) {
    await page.keyboard.press(key);
    await drawn(page);
    assert.equal(await page.evaluate(() => document.activeElement.id), `tab-${tab}`);
    assert.ok(await page.isVisible(`#panel-${tab}`));
    assert.equal(await page.locator("[role=tabpanel]:visible").count(), 1);
  }
  await page.focus("#case-menu > summary");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.id), "open");
  await page.keyboard.press("Escape");
  assert.ok(!(await page.isVisible("#open")));
  await page.close();
});

test("the design point is dragged, and placed by a click, without the axes moving; one step undoes it", async () => {
  for (const plate of ["k-mu", "load"]) {
    const page = await open(browser);
    await page.click(`[data-plate="${plate}"]`);
    await drawn(page);
    const before = await text(page);
    const axes = (await description(page)).match(/to the right[^.]*/)?.[0];
    const [x, y] = await centre(page, "#point");
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x - 60, y + 10, { steps: 4 });
    await page.mouse.move(x - 120, y - 40, { steps: 4 });
    await drawn(page);
    const [x1, y1] = await centre(page, "#point");
    assert.ok(Math.hypot(x1 - (x - 120), y1 - (y - 40)) < 1.5, `${plate}: the point is under the hand`);
    assert.equal(await text(page), before, "nothing is written before the hand lets go");
    await page.mouse.up();
    await drawn(page);
    const changed = lines(before, await text(page));
    assert.equal(changed.length, 2, changed.join(" "));
    assert.match(changed[0], /^friction = 0\.[678]\d*$/);
    assert.match(changed[1], /^force = "\d{3,4} kN\/m"$/);
    if (plate === "k-mu") {
      const [x2, y2] = await centre(page, "#point");
      assert.ok(Math.hypot(x2 - (x - 120), y2 - (y - 40)) < 2, "the point is where the hand left it");
      assert.equal((await description(page)).match(/to the right[^.]*/)?.[0], axes);
      await page.mouse.click(x + 100, y + 30);
      await drawn(page);
      const [x3, y3] = await centre(page, "#point");
      assert.ok(Math.hypot(x3 - (x + 100), y3 - (y + 30)) < 2, `${x3 - x}, ${y3 - y}, ${await text(page)}`);
      assert.equal(await page.evaluate(() => document.activeElement.id), "point");
      await page.keyboard.press("Control+z");
      await drawn(page);
    }
    await page.keyboard.press("Control+z");
    await drawn(page);
    assert.equal(await text(page), before);
    assert.deepEqual(page.heard, []);
    await page.close();
  }
});

test("under a wave the point goes up and down only", async () => {
  const page = await open(browser);
  await choose(page, "Goda’s caisson");
  const before = await text(page);
  const [x, y] = await centre(page, "#point");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 80, y + 60, { steps: 4 });
  await page.mouse.up();
  await drawn(page);
  const changed = lines(before, await text(page));
  assert.ok(changed.length === 1 && /^friction = 0\.\d+$/.test(changed[0]), changed.join(" "));
  assert.match(await page.textContent("#point-help"), /up or down/);
  await page.close();
});

test("the arrow of a force is dragged by its ring: along for its size, across for its level", async () => {
  const page = await open(browser);
  const before = await text(page);
  const [x, y] = await centre(page, ".ring[data-key$=force]");
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 12, y + 60, { steps: 6 });
  await page.mouse.up();
  await drawn(page);
  const changed = lines(before, await text(page));
  assert.equal(changed.length, 2, changed.join(" "));
  const [force, level] = changed.map((line) => Number(line.match(/"([\d.]+) /)[1]));
  assert.ok(force < 2300 && force > 1000 && level < 10.5 && level > 7, changed.join(" "));
  await page.focus(".ring[data-key$=force]");
  await page.keyboard.press("ArrowRight");
  await drawn(page);
  const [stepped] = lines(before, await text(page)).map((line) => Number(line.match(/"([\d.]+) /)[1]));
  assert.ok(Math.abs(stepped - force * 1.01) <= 1, `${stepped}`);
  await page.close();
});

test("a side of the body is dragged by its ring, which stays under the hand; of the file its line alone differs", async () => {
  for (const width of [1280, 390]) {
    const page = await open(browser, { viewport: { width, height: 844 }, acceptDownloads: true });
    const before = await text(page);
    for (const [key, [right, up], most] of [["body.width", [30, 0], 21], ["body.height", [0, 22], 15]]) {
      const ring = `.ring[data-key="${key}"]`;
      const [x, y] = await centre(page, ring);
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x + right, y - up, { steps: 5 });
      await drawn(page);
      const [at, level] = await centre(page, ring);
      // Along the way it goes; a longer number beside it may push its line aside.
      const off = key === "body.width" ? at - x - right : y - up - level;
      assert.ok(Math.abs(off) < 2.5, `${width}, ${key}: ${off} px from the hand`);
      if (width === 1280) await page.screenshot({ path: path.join(artefacts, `held-${key}.png`) });
      await page.mouse.up();
      await drawn(page);
      const changed = lines(before, await text(page));
      assert.equal(changed.length, 1, changed.join(" "));
      assert.ok(changed[0].startsWith(key.split(".")[1]), changed[0]);
      const value = Number(changed[0].match(/"([\d.]+) m"/)[1]);
      assert.ok(value > 12.2 && value < most, changed[0]);
      assert.equal(await page.evaluate(() => document.querySelector("#section .over").style.translate), "");
      await page.click("#undo");
      await drawn(page);
      assert.equal(await text(page), before);
    }
    await page.focus('.ring[data-key="body.width"]');
    await page.keyboard.press("ArrowRight");
    await drawn(page);
    assert.deepEqual(lines(before, await text(page)), ['width = "15.15 m"']);
    await page.keyboard.press("Alt+ArrowRight");
    await drawn(page);
    assert.equal(lines(before, await text(page)).length, 2, "with Alt the mass stays, and the density does not");
    assert.deepEqual(page.heard, []);
    await page.close();
  }
});

test("a side that is pulled has a notch where the body begins to rest, and halts there", async () => {
  for (const [key, label, line] of [["body.width", "rests: 18.21 m", 'width = "18.21 m"'], ["body.height", "rests: 14.57 m", 'height = "14.57 m"']]) {
    const page = await open(browser, { viewport: { width: 1280, height: 800 } });
    const [x, y] = await centre(page, `.ring[data-key="${key}"]`);
    assert.equal(await page.locator(".notch").count(), 0);
    const isWidth = key === "body.width";
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(isWidth ? x + 20 : x, isWidth ? y : y - 20, { steps: 3 });
    await page.waitForSelector(".notch");
    assert.equal(await page.textContent(".notch"), label);
    await page.screenshot({ path: path.join(artefacts, `notch-${key}.png`) });
    // Its tick is in the middle of its width, or of its height; a little beside it is on it.
    const [right, level] = await centre(page, ".notch");
    await page.mouse.move(isWidth ? right + 3 : x, isWidth ? y : level - 3, { steps: 12 });
    await drawn(page);
    await page.mouse.up();
    await drawn(page);
    assert.ok((await text(page)).includes(line), await text(page));
    assert.equal(await mode(page), "RE");
    assert.equal(await page.locator(".notch").count(), 0);
    await page.close();
  }
});

test("where a hand goes farther than there are answers, the page says why it ended before", async () => {
  const page = await open(browser);
  const ring = page.locator('.ring[data-key="body.height"]');
  const { x, y } = await ring.boundingBox();
  const far = await page.evaluate(() => document.querySelector("#section svg").getBoundingClientRect().bottom);
  await page.mouse.move(x + 8, y + 8);
  await page.mouse.down();
  await page.mouse.move(x + 8, (y + far) / 2, { steps: 8 });
  await drawn(page);
  await page.mouse.up();
  await drawn(page);
  assert.match(await page.textContent("#note"), /^No farther: `elevation` is above the crest of the body/);
  await page.close();
});

test("the number in hand is marked in the text beside it", async () => {
  const page = await open(browser, { viewport: { width: 1760, height: 1000 } });
  await page.focus('[data-key="body.friction"]');
  await drawn(page);
  assert.equal(await page.textContent(".marks mark.lit"), "0.6");
  await page.focus('.ring[data-key="load[1].force"]');
  await drawn(page);
  assert.equal(await page.textContent(".marks mark.lit"), '"2700 kN/m"');
  await page.screenshot({ path: path.join(artefacts, "lit-1760.png") });
  await page.focus("#undo").catch(() => {});
  await page.focus("#link");
  await drawn(page);
  assert.equal(await page.locator(".marks mark").count(), 0);
  await page.close();
});

test("the background pans, the wheel zooms about its place, All shows all", async () => {
  const page = await open(browser);
  const before = await text(page);
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
  assert.equal(await text(page), before, "moving about does not move the point");
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

test("a file is dropped, its width changed, undone, done again and saved: only that line differs", async () => {
  const page = await open(browser, { acceptDownloads: true });
  const file = example("goda-on-sand.toml");
  await drop(page, [["north wall.toml", file]]);
  assert.equal(await text(page), file);
  assert.equal(await mode(page), "BF");
  assert.equal(await page.textContent("#warnings"), "Warnings: impulsive-breaking");
  await type(page, "wave.period", "10,5");
  assert.deepEqual(lines(file, await text(page)), ['period = "10.5 s"']);
  await page.keyboard.press("Control+z");
  await drawn(page);
  assert.equal(await text(page), file);
  await page.keyboard.press("Control+Shift+z");
  await drawn(page);
  assert.deepEqual(lines(file, await text(page)), ['period = "10.5 s"']);
  await page.click("#undo");
  await drawn(page);
  await page.click("#tab-inputs");
  await drawn(page);
  await type(page, "wave.berm_width", "9");
  const { name, content } = await saved(page, "#save-toml");
  assert.equal(name, "north-wall.toml");
  assert.deepEqual(lines(file, content.toString()), ['berm_width = "9 m"']);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("a faulty file changes nothing but the text, opens at its fault, and is mended by its cure", async () => {
  const page = await open(browser);
  const before = await page.textContent("#answer");
  const file = example("goda-2000.toml").replace("period =", "perriod =");
  await drop(page, [["breakwater-north.toml", file]]);
  assert.equal(await page.textContent("#answer"), before);
  assert.match(await page.textContent("#still"), /still the answer to “Caisson in air”/);
  const line = file.split("\n").findIndex((one) => one.startsWith("perriod")) + 1;
  assert.equal(await page.textContent("#fault-where"), `Line ${line}:`);
  assert.equal(await page.textContent("#fault-message"), "[wave] has no key `perriod`");
  assert.match(await page.textContent("#fault-help"), /^did you mean `period`\?/);
  assert.equal(await page.textContent(".marks mark"), "perriod");
  assert.ok(await page.isVisible("#text"));
  assert.equal(await page.textContent("#case-name"), "breakwater-north.toml");
  await page.click("#cure");
  await drawn(page);
  assert.equal(await text(page), example("goda-2000.toml"));
  assert.ok(await page.isHidden("#pane-fault"));
  assert.equal(await mode(page), "RE");
  await page.keyboard.press("Control+z");
  await drawn(page);
  await page.click("#leave");
  await drawn(page);
  assert.equal(await page.textContent("#case-name"), "Caisson in air");
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("the text is read at each pause, and keys undo it", async () => {
  const page = await open(browser);
  await page.click("#tab-inputs");
  await drawn(page);
  const before = await text(page);
  await page.focus("#text");
  await page.evaluate(() => {
    const pane = document.getElementById("text");
    const at = pane.value.indexOf("friction = 0.6") + "friction = 0.6".length;
    pane.setSelectionRange(at, at);
  });
  await page.keyboard.type("5 # rough");
  assert.equal(await text(page), before);
  await page.waitForFunction(() => window.standfast.explorer.text().includes("friction = 0.65 # rough"));
  await drawn(page);
  assert.ok(Math.abs((await said(page)).point[3] - 0.65) < 1e-12);
  assert.equal(await numberOf(page, "body.friction").inputValue(), "0.65");
  await page.keyboard.press("Control+z");
  await drawn(page);
  assert.equal(await text(page), before);
  assert.equal(await page.inputValue("#text"), before);
  // A fault is marked while the caret stays, and the answer before it holds.
  await page.keyboard.press("Control+Home");
  await page.keyboard.type("x");
  await page.waitForFunction(() => !document.getElementById("pane-fault").hidden);
  assert.match(await page.textContent("#fault-message"), /^the case file has no key `xtitle`$/);
  await page.keyboard.press("Backspace");
  await page.waitForFunction(() => document.getElementById("pane-fault").hidden);
  assert.equal(await text(page), before);
  await page.close();
});

test("a record is dropped for the case that names it", async () => {
  const page = await open(browser);
  const block = '[block]\nb1 = 1\nb2 = 1\nd = 3\nmu_s = 0.6\ngravity = 9.81\n\n[motion.base]\nhorizontal = { shape = "file", file = "records/shake.csv" }\n';
  await drop(page, [["block.toml", block]]);
  assert.equal(await page.textContent("#fault-message"), "cannot read records/shake.csv: the page does not have it; open or drop it here");
  await drop(page, [["shake.csv", "t,a\n0,0\n0.2,6\n0.4,0\n"]]);
  assert.ok(await page.isHidden("#pane-fault"));
  assert.equal(await page.locator("#map .picture svg").count(), 1);
  // Both at once, the case first.
  const again = await open(browser);
  await drop(again, [["block.toml", block], ["shake.csv", "t,a\n0,0\n0.2,6\n0.4,0\n"]]);
  assert.ok(await again.isHidden("#pane-fault"));
  await again.close();
  await page.close();
});

test("examples stand on four shelves, new cases beside them, and each opens", async () => {
  const page = await open(browser);
  await page.click("#case-menu > summary");
  assert.deepEqual(await page.$$eval("#case-sheet h2", (all) => all.map((one) => one.textContent)), ["New", "Sea", "Ground", "Earthquake", "Chance"]);
  const names = await page.$$eval("[data-case]", (all) => all.map((one) => one.dataset.case));
  assert.ok(names.length >= 22);
  assert.ok((await page.$$eval("[data-case] small", (all) => all.every((one) => one.textContent.length > 20))));
  await page.keyboard.press("Escape");
  for (const name of names) {
    await choose(page, name);
    assert.ok(await page.isHidden("#pane-fault"), name);
    assert.ok((await page.textContent("#answer")).length > 10, name);
    assert.ok(await page.isHidden("#case-sheet"));
  }
  await choose(page, "Block in pure numbers");
  assert.match(await page.textContent("#stage svg title"), /in motion$/);
  await page.click("#to-scale");
  await drawn(page);
  assert.match(await page.textContent("#section svg title"), /[Pp]osition/);
  assert.match(await page.textContent("#sentences"), /unique/);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("a newcomer's own body has its verdict", async () => {
  const page = await open(browser);
  await choose(page, "A block");
  for (const [key, typed] of [["body.width", "0,8"], ["body.height", "1,9 m"], ["body.density", "2300 kg/m3"], ["load[1].force", "12"], ["load[1].elevation", "1,8"]]) await type(page, key, typed, "Tab");
  assert.equal(await page.textContent("#answer"), "The body rocks about O, the bottom left corner (RO).");
  // 0.8 × 1.9 m² of 2300 kg/m³ on its half width, over 12 kN/m at 1.8 m.
  const factor = (0.8 * 1.9 * 2.3 * 9.81 * 0.4) / (12 * 1.8);
  const share = `At ${(100 * factor).toPrecision(4)} % of the push (${(12 * factor).toPrecision(4)} kN/m) it rocks`;
  assert.ok((await page.textContent("#near")).startsWith(share));
  await page.close();
});

test("however many events come, there is one drawing a frame; frames while dragging are measured for every example", async (context) => {
  const page = await open(browser, { viewport: { width: 1280, height: 800 } });
  const names = await page.$$eval("[data-case]", (all) => all.map((one) => one.dataset.case));
  const medians = [];
  for (const name of names) {
    const result = await page.evaluate(async (example) => {
      const app = window.standfast;
      app.explorer.open_example(example);
      app.plate = "";
      app.changed();
      const frame = () => new Promise(requestAnimationFrame);
      await frame();
      await frame();
      const point = document.getElementById("point");
      if (point.hidden) return null;
      const box = point.getBoundingClientRect();
      const send = (type, x, y) => point.dispatchEvent(new PointerEvent(type, { pointerId: 1, button: 0, clientX: x, clientY: y, bubbles: true }));
      point.setPointerCapture = () => {};
      point.hasPointerCapture = () => true;
      const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
      send("pointerdown", x, y);
      const before = app.frames;
      const gaps = [];
      await frame();
      let last = performance.now();
      for (let i = 0; i < 40; i++) {
        for (let j = 0; j < 5; j++) send("pointermove", x - i / 2, y + i / 2 + j / 10);
        await frame();
        gaps.push(performance.now() - last);
        last = performance.now();
      }
      send("pointerup", x, y);
      gaps.sort((a, b) => a - b);
      return { median: gaps[20], most: gaps.at(-1), drawn: app.frames - before };
    }, name);
    if (!result) continue;
    medians.push([name, result]);
    assert.ok(result.drawn <= 42 && result.drawn >= 30, `${name}: ${result.drawn} drawings in 40 frames`);
  }
  for (const [name, { median, most }] of medians) context.diagnostic(`${name}: median frame ${median.toFixed(1)} ms, longest ${most.toFixed(1)} ms`);
  assert.ok(medians.length >= 12);
  await page.close();
});
