// What is typed into a field, key by key.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { drawn, field, launch, lines, mode, numberOf, open, said, text, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const state = (page) => page.evaluate(() => JSON.stringify([window.standfast.explorer.text(), document.getElementById("answer").textContent]));
const AMBIGUOUS = "“2,700” could be 2.7 or 2700: type 2.7 or 2700.";
const FORCE = "load[1].force";

test("typing changes nothing until Enter, and then one line of the text", async () => {
  const page = await open(browser);
  const [before, first] = [await state(page), await text(page)];
  await numberOf(page, FORCE).focus();
  await page.keyboard.press("Control+A");
  for (const letter of "1 234,5") {
    await page.keyboard.press(letter === " " ? "Space" : letter);
    await drawn(page);
    assert.equal(await state(page), before);
  }
  await page.keyboard.press("Enter");
  await drawn(page);
  assert.deepEqual(await field(page, FORCE), { text: "1234.5", invalid: false, message: "", announced: "" });
  assert.deepEqual(lines(first, await text(page)), ['force = "1234.5 kN/m"']);
  // 1234.5 kN/m on 378 t/m.
  assert.ok(Math.abs((await said(page)).point[2] - 1234.5 / (378 * 9.81)) < 1e-12);
  await page.close();
});

// One page for all: to open one takes longer than to type into it.
test("what is one number is taken at Enter, and at Tab", async () => {
  const page = await open(browser);
  for (const [typed, key, shown, unit, line] of [
    ["0,6", "body.friction", "0.6", "", "friction = 0.6"],
    ["0.35", "body.friction", "0.35", "", "friction = 0.35"],
    ["10,5", "body.width", "10.5", "m", 'width = "10.5 m"'],
    ["12 m", "body.height", "12", "m", 'height = "12 m"'],
    ["1 200,0 cm", "body.height", "1200", "cm", 'height = "1200 cm"'],
    ["12.4m", "body.height", "12.4", "m", 'height = "12.4 m"'],
    ["2.700", FORCE, "2.7", "kN/m", 'force = "2.7 kN/m"'],
    ["2700 kN/m", FORCE, "2700", "kN/m", 'force = "2700 kN/m"'],
    ["2,7 MN/m", FORCE, "2.7", "MN/m", 'force = "2.7 MN/m"'],
    ["1 234,5 kN / m", FORCE, "1234.5", "kN/m", 'force = "1234.5 kN/m"'],
    ["2 100 kg/m3", "body.density", "2100", "kg/m3", 'density = "2100 kg/m3"'],
    ["2,1t/m3", "body.density", "2.1", "t/m3", 'density = "2.1 t/m3"'],
  ]) {
    for (const end of ["Enter", "Tab"]) {
      const where = `“${typed}” and ${end}`;
      await type(page, key, typed, end);
      const found = await field(page, key);
      assert.deepEqual([found.text, found.invalid, found.message], [shown, false, ""], where);
      assert.equal((await said(page)).tables.flatMap(({ numbers }) => numbers).find((number) => number.key === key).unit, unit, where);
      assert.ok((await text(page)).split("\n").includes(line), where);
    }
  }
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("what is none, or could be two, is refused, and stays with its message", async () => {
  const page = await open(browser);
  const before = await state(page);
  for (const [key, typed, message] of [
    [FORCE, "2,700", AMBIGUOUS],
    [FORCE, "2,700 kN/m", AMBIGUOUS],
    [FORCE, "1.234,5", "“1.234,5” has more than one point or comma: type 1234.5 if that is meant."],
    ["body.friction", "abc", "“abc” is not a number."],
    ["body.width", "12 yd", "“yd” is not a unit of this field, which takes mm, cm, m, ft or in."],
    ["body.friction", "", "A number is missing."],
    ["body.width", "0", "`width` is \"0 m\"; expected a finite number above zero"],
    ["load[1].elevation", "13", "`elevation` is above the crest of the body, which is 12 m high"],
  ]) {
    for (const end of ["Enter", "Tab"]) {
      const where = `“${typed}” and ${end}`;
      const { text: good } = await field(page, key);
      await type(page, key, typed, end);
      const refused = async () => {
        const found = await field(page, key);
        assert.deepEqual([found.text, found.invalid], [typed, true], where);
        assert.ok(found.announced.startsWith(message), found.announced);
        assert.ok(found.message.includes(`Until then ${good}`) && found.message.endsWith("holds."), found.message);
        assert.equal(await state(page), before, where);
      };
      await refused();
      await page.keyboard.press("Tab");
      await page.keyboard.press("Tab");
      await drawn(page);
      await refused();
      await numberOf(page, key).focus();
      await page.keyboard.press("Escape");
      await drawn(page);
      assert.deepEqual(await field(page, key), { text: good, invalid: false, message: "", announced: "" }, where);
      assert.equal(await state(page), before, where);
    }
  }
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("a message is not hidden by the drawing", async () => {
  const page = await open(browser);
  await type(page, "body.width", "2,700", "Tab");
  const message = page.locator(".message:visible");
  const box = await message.boundingBox();
  const hit = await page.evaluate(({ x, y }) => document.elementFromPoint(x, y)?.closest(".message") !== null, { x: box.x + 20, y: box.y + box.height / 2 });
  assert.ok(hit && box.width > 120);
  await page.close();
});

test("Escape gives back the number before the typing", async () => {
  const page = await open(browser);
  const before = await state(page);
  await type(page, FORCE, "7", "Escape");
  assert.equal((await field(page, FORCE)).text, "2700");
  await page.keyboard.press("Tab");
  await drawn(page);
  assert.equal(await state(page), before);
  await page.close();
});

test("a refused text stays while other numbers change, and goes with another case", async () => {
  const page = await open(browser);
  await type(page, "body.friction", "0,600,1", "Tab");
  await type(page, FORCE, "1000");
  assert.equal(await mode(page), "RE");
  assert.deepEqual([(await field(page, "body.friction")).text, (await field(page, "body.friction")).invalid], ["0,600,1", true]);
  await page.click("#case-menu > summary");
  await page.click('[data-case="Goda’s caisson"]');
  await drawn(page);
  assert.deepEqual([(await field(page, "body.friction")).text, (await field(page, "body.friction")).invalid], ["0.6", false]);
  await page.close();
});

test("a refused number is taken once the number that stood against it has changed", async () => {
  const page = await open(browser);
  await type(page, "body.height", "3");
  assert.match((await field(page, "body.height")).message, /above the crest.* Until then 12 m holds\.$/);
  await type(page, "body.width", "2");
  assert.equal((await field(page, "body.height")).invalid, true);
  await type(page, "load[1].elevation", "2");
  await drawn(page);
  assert.deepEqual([(await field(page, "body.height")).text, (await field(page, "body.height")).invalid], ["3", false]);
  assert.match(await text(page), /height = "3 m"/);
  await page.close();
});

test("2,700 is not 2 kN/m", async () => {
  const page = await open(browser);
  await type(page, FORCE, "2,700", "Tab");
  assert.equal(await mode(page), "SRO-");
  assert.equal((await field(page, FORCE)).announced, AMBIGUOUS);
  await type(page, FORCE, "2700", "Tab");
  assert.ok(Math.abs((await said(page)).point[2] - 2700 / (378 * 9.81)) < 1e-12);
  await page.close();
});

test("arrows change a number by one per cent, with Shift by ten", async () => {
  const page = await open(browser);
  await numberOf(page, FORCE).focus();
  await page.keyboard.press("ArrowUp");
  await drawn(page);
  assert.equal((await field(page, FORCE)).text, "2727");
  await page.keyboard.press("Shift+ArrowDown");
  await drawn(page);
  assert.equal((await field(page, FORCE)).text, "2454");
  await page.close();
});

test("every number of a case is a field with its words, unit and range, in the form", async () => {
  const page = await open(browser);
  for (const name of ["Goda’s caisson", "Quay wall with backfill", "Server rack in an earthquake", "Block in pure numbers"]) {
    await page.click("#case-menu > summary");
    await page.click(`[data-case="${name}"]`);
    await page.click("#tab-inputs");
    await drawn(page);
    const numbers = (await said(page)).tables.flatMap((table) => table.numbers);
    const shown = await page.$$eval("#form input", (inputs) => inputs.map((input) => [input.dataset.key, input.value, input.labels[0].textContent.length > 3]));
    assert.deepEqual(shown, numbers.map(({ key, digits }) => [key, digits, true]), name);
    assert.ok(numbers.length > 5 && numbers.every(({ words, range }) => words && range), name);
  }
  await type(page, "block.mu_s", "0,3");
  assert.ok((await text(page)).includes("mu_s = 0.3"));
  await page.close();
});
