// What is typed into a field, key by key.

import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { drawn, field, launch, mode, open, reading, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const answer = (page) =>
  page.evaluate(() => JSON.stringify([window.standfast.reading.numbers, document.getElementById("sentence").textContent]));
const AMBIGUOUS = "“2,700” could be 2.7 or 2700: type 2.7 or 2700.";

test("typing changes nothing until Enter", async () => {
  const page = await open(browser);
  const before = await answer(page);
  await page.focus("#thrust");
  await page.keyboard.press("Control+A");
  for (const letter of "1 234,5") {
    await page.keyboard.press(letter === " " ? "Space" : letter);
    await drawn(page);
    assert.equal(await answer(page), before);
  }
  await page.keyboard.press("Enter");
  await drawn(page);
  assert.deepEqual(await field(page, "thrust"), { text: "1234.5", invalid: false, message: "", announced: "" });
  // 1234.5 kN/m on 378 t/m.
  assert.ok(Math.abs((await reading(page)).numbers.given[2] - 1234.5 / (378 * 9.81)) < 1e-12);
  await page.close();
});

// One page for all: to open one takes longer than to type into it.
test("what is one number is taken at Enter, and at Tab", async () => {
  const page = await open(browser);
  for (const [typed, id, shown, at, value] of [
    ["0,6", "friction", "0.6", 3, 0.6],
    ["0.35", "friction", "0.35", 3, 0.35],
    ["10,5", "force", "10.5", 2, 10.5],
    ["−0,25", "elevation", "−0.25", 1, -0.25],
    ["-0.5", "elevation", "−0.5", 1, -0.5],
    ["12 m", "height", "12", 0, 12 / 15],
    ["1 200,0 cm", "height", "12", 0, 12 / 15],
    ["9m", "height", "9", 0, 0.6],
    ["2.700", "thrust", "2.7", 2, 2.7 / (378 * 9.81)],
    ["2700 kN/m", "thrust", "2700", 2, 2700 / (378 * 9.81)],
    ["2,7 MN/m", "thrust", "2700", 2, 2700 / (378 * 9.81)],
    ["1 234,5", "thrust", "1234.5", 2, 1234.5 / (378 * 9.81)],
  ]) {
    for (const end of ["Enter", "Tab"]) {
      const where = `“${typed}” and ${end}`;
      await type(page, id, "1.5", "Enter");
      await type(page, id, typed, end);
      const said = await field(page, id);
      assert.deepEqual([said.text, said.invalid, said.message], [shown, false, ""], where);
      const { given } = (await reading(page)).numbers;
      assert.ok(Math.abs(given[at] - value) < 1e-12, `${where}: ${given}`);
    }
  }
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("what is none, or could be two, is refused, and stays with its message", async () => {
  const page = await open(browser);
  const before = await answer(page);
  for (const [id, typed, message] of [
    ["thrust", "2,700", AMBIGUOUS],
    ["thrust", "2,700 kN/m", AMBIGUOUS],
    ["thrust", "1.234,5", "“1.234,5” has more than one point or comma: type 1234.5 if that is meant."],
    ["force", "abc", "“abc” is not a number."],
    ["width", "12 ft", "“ft” is not a unit of this field, which takes m, cm, mm."],
    ["friction", "", "A number is missing."],
    ["slenderness", "0", "Slenderness γ is 0; expected a number above zero"],
    ["mass", "-1", "Mass is −1000; expected a number above zero"],
  ]) {
    for (const end of ["Enter", "Tab"]) {
      const where = `“${typed}” and ${end}`;
      const { text: good } = await field(page, id);
      await type(page, id, typed, end);
      const refused = async () => {
        const said = await field(page, id);
        assert.deepEqual([said.text, said.invalid], [typed, true], where);
        assert.ok(said.announced.startsWith(message), said.announced);
        assert.ok(said.message.includes(`Until then ${good}`) && said.message.endsWith("holds."), said.message);
        assert.ok(await page.locator(`#${id}-error`).isVisible());
        assert.equal(await answer(page), before, where);
      };
      await refused();
      await page.keyboard.press("Tab");
      await page.keyboard.press("Tab");
      await drawn(page);
      await refused();
      await page.focus(`#${id}`);
      await page.keyboard.press("Escape");
      await drawn(page);
      assert.deepEqual(await field(page, id), { text: good, invalid: false, message: "", announced: "" }, where);
      assert.equal(await answer(page), before, where);
    }
  }
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("Escape gives back the number before the typing", async () => {
  const page = await open(browser);
  const before = await answer(page);
  await type(page, "force", "7", "Escape");
  assert.equal((await field(page, "force")).text, "0.8");
  await page.keyboard.press("Tab");
  await drawn(page);
  assert.equal(await answer(page), before);
  await page.close();
});

test("a refused text stays while other numbers change, and goes when its own is moved", async () => {
  const page = await open(browser);
  await type(page, "friction", "0,600,1", "Tab");
  await type(page, "force", "0,3");
  assert.equal(await mode(page), "RE");
  assert.deepEqual([(await field(page, "friction")).text, (await field(page, "friction")).invalid], ["0,600,1", true]);
  await page.focus('[data-slider="friction"]');
  await page.keyboard.press("ArrowRight");
  await drawn(page);
  const said = await field(page, "friction");
  assert.equal(said.invalid, false);
  assert.equal(Number(said.text), (await reading(page)).numbers.given[3]);
  await page.close();
});

test("2,700 is not 2 kN/m", async () => {
  const page = await open(browser);
  await type(page, "thrust", "2,700", "Tab");
  assert.notEqual(await mode(page), "RE");
  assert.equal((await field(page, "thrust")).announced, AMBIGUOUS);
  await type(page, "thrust", "2700", "Tab");
  assert.ok(Math.abs((await reading(page)).numbers.given[2] - 2700 / (378 * 9.81)) < 1e-12);
  await page.close();
});
