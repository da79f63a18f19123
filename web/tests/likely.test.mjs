// How likely: the laws of random numbers as fields, the probability on top, the draws in the plane, the program's answer.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { after, before, test } from "node:test";
import { artefacts, drawn, faults, field, launch, numberOf, open, program, take, text, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const examples = path.join(import.meta.dirname, "../../examples");

/** A page with a case and the tab open. */
async function likely(name, options = {}) {
  const page = await open(browser, options);
  if (name) {
    await page.evaluate((which) => {
      window.standfast.explorer.open_example(which);
      window.standfast.changed();
    }, name);
  }
  await page.click("#tab-likely");
  await drawn(page);
  return page;
}

/** Waits until all is told. */
const told = async (page) => {
  await page.waitForFunction(() => {
    const { parts, done } = window.standfast.asked("likely");
    return done && parts.length > 0;
  }, null, { timeout: 120_000 });
  await drawn(page);
};
const parts = (page) => page.evaluate(() => window.standfast.asked("likely").parts);
const answer = (page) => page.textContent("#answer");

/** What the program says of a case file. */
const native = (...args) => execFileSync(program, ["probability", "--format", "json", "--no-figures", ...args], { encoding: "utf8" });

/** That two documents are the same, to what functions of different libraries of mathematics agree to. */
function same(one, two, where) {
  if (typeof one === "number" && typeof two === "number") {
    return assert.ok(Math.abs(one - two) <= 1e-6 * Math.max(1e-9, Math.abs(one), Math.abs(two)), `${where}: ${one} and ${two}`);
  }
  if (one === null || two === null || typeof one !== "object") return assert.deepEqual(one, two, where);
  assert.deepEqual(Object.keys(one), Object.keys(two), where);
  for (const key of Object.keys(one)) same(one[key], two[key], `${where}.${key}`);
}

test("the probability is on top, and its JSON is the program's", async () => {
  for (const name of ["goda-2000-random", "statue-random"]) {
    const page = await likely(name);
    await told(page);
    const expected = JSON.parse(native(path.join(examples, `${name}.toml`)));
    const found = JSON.parse((await parts(page)).at(-1).json);
    // The file's name has no folder on the page.
    expected.case = found.case = "";
    same(found, expected, name);
    assert.equal(await answer(page), expected.summary.answer);
    assert.match(await page.textContent("#near"), /^With the numbers as they stand: The body stays at rest \(RE\)\./);
    assert.match(await page.textContent("#symbol"), name === "goda-2000-random" ? /^2\.5 %$/ : /^7\.8 %$/);
    assert.match(await page.textContent("#chances"), /stays at rest/);
    assert.match(await page.textContent("#known"), /friction/);
    assert.match(await page.textContent("#how"), /^Probabilities in one event: friction in closed form/);
    assert.equal(await page.textContent("#likely-state"), "");
    assert.deepEqual(page.heard, []);
    await page.close();
  }
});

test("a first answer comes before the last, and another case throws both away", async () => {
  const page = await likely("goda-2000-storm");
  await page.waitForFunction(() => window.standfast.asked("likely").parts.length > 0, null, { timeout: 60_000 });
  await drawn(page);
  assert.match(await answer(page), /^In 50 years the body slides 0\.06/);
  assert.match(await page.textContent("#likely-state"), /becomes finer/);
  assert.match(await page.textContent("#slides"), /more than/);
  // The page goes on while its second thread counts.
  const started = Date.now();
  await type(page, "random.friction", "20");
  assert.ok(Date.now() - started < 2000);
  assert.match(await text(page), /friction = \{ lognormal = \{ mean = 0\.636, cov = 0\.2 \} \}/);
  assert.equal(await page.evaluate(() => window.standfast.asked("likely").done), false);
  assert.doesNotMatch(await answer(page), /0\.06/);
  await page.close();
});

test("a case without random numbers offers laws, takes them in one step, and gives them back", async () => {
  const page = await likely("");
  const before = await text(page);
  const rests = await answer(page);
  assert.match(await page.textContent("#spread-words"), /proposals.*replace each/);
  assert.match(await page.textContent("#spreads"), /proposed: lognormal ± 20 %/);
  assert.equal(await page.isVisible("#chances-part"), false);
  await page.focus("#propose");
  await page.keyboard.press("Enter");
  await told(page);
  assert.equal(await text(page), `${before}\n[random]\nfriction = { lognormal = { cov = 0.2 } }\nmass = { normal = { cov = 0.03 } }\nbias.force = { lognormal = { mean = 1, cov = 0.2 } }\n`);
  assert.match(await answer(page), /^The probability that the body does not stay at rest in one event is 0\.\d+/);
  assert.equal(await page.isVisible("#propose"), false);
  // Its draws lie in the report's plane, and go while something is dragged.
  assert.equal(await page.locator("#draws-over svg").count(), 1);
  assert.match(await page.textContent("#draws-words"), /ellipses in the plane are one and two standard deviations of 1000 draws/);
  const point = await page.locator("#point").boundingBox();
  await page.mouse.move(point.x + point.width / 2, point.y + point.height / 2);
  await page.mouse.down();
  await page.mouse.move(point.x + 60, point.y + 30, { steps: 4 });
  await drawn(page);
  assert.equal(await page.locator("#draws-over svg").count(), 0);
  assert.doesNotMatch(await answer(page), /probability/);
  await page.keyboard.press("Escape");
  await page.mouse.up();
  await page.click("#undo");
  await drawn(page);
  if ((await text(page)) !== before) await page.click("#undo");
  await drawn(page);
  assert.equal(await text(page), before);
  assert.equal(await answer(page), rests);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("laws are chosen and deviations typed as people type them", async () => {
  const page = await likely("");
  const law = (words) => page.locator(`#spreads select[aria-label="Law of ${words}"]`);
  const friction = page.locator("#spreads .spread").first().locator("select");
  await friction.selectOption("normal");
  await drawn(page);
  assert.match(await text(page), /\[random\]\nfriction = \{ normal = \{ cov = 0\.2 \} \}\n$/);
  await type(page, "random.friction", "12,5");
  assert.match(await text(page), /cov = 0\.125/);
  await type(page, "random.friction", "15 %", "Tab");
  assert.match(await text(page), /cov = 0\.15 /);
  await numberOf(page, "random.friction").press("ArrowUp");
  await drawn(page);
  assert.match(await text(page), /cov = 0\.1515/);
  const kept = await text(page);
  for (const [typed, message] of [["2,700", /could be 2\.7 or 2700/], ["90", /of the law of `friction` lies where it is/], ["x", /is not a number/]]) {
    await type(page, "random.friction", typed);
    const shown = await field(page, "random.friction");
    assert.ok(shown.invalid, typed);
    assert.match(shown.announced, message);
    assert.equal(await text(page), kept);
  }
  await numberOf(page, "random.friction").press("Escape");
  await drawn(page);
  assert.equal((await field(page, "random.friction")).text, "15.15");
  await friction.selectOption("certain");
  await drawn(page);
  assert.doesNotMatch(await text(page), /random/);
  assert.equal(await law("nothing").count(), 0);
  await page.close();
});

test("what is wrong with random numbers is said in the program's words", async () => {
  const page = await likely("");
  await take(page, "wrong.toml", `${await text(page)}\n[random]\nfrction = { normal = { sd = 0.1 } }\n`);
  await told(page);
  assert.match(await page.textContent("#likely-fault"), /^`frction` is not a number of the case that can be random: did you mean `friction`\?/);
  await page.close();
});

test("the tab is accessible in both themes and looks right at three widths", async () => {
  mkdirSync(artefacts, { recursive: true });
  for (const [width, height] of [[390, 844], [1280, 800], [1920, 1080]]) {
    for (const theme of ["light", "dark"]) {
      for (const name of ["", "random", "goda-2000-random"]) {
        const page = await likely(name === "random" ? "" : name, { viewport: { width, height }, colorScheme: theme });
        if (name === "random") await page.click("#propose");
        if (name) await told(page);
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.ok(wide <= 0, `${name} ${width}: ${wide} too wide`);
        await page.screenshot({ path: path.join(artefacts, `likely-${name || "offer"}-${width}-${theme}.png`), fullPage: true });
        if (width === 1280) assert.deepEqual(await faults(page), [], `${name} ${theme}`);
        assert.deepEqual(page.heard, []);
        await page.close();
      }
    }
  }
});
