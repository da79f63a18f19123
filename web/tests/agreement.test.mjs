// The page, the program and the calculation sheet say the same of a case that is typed into the page key by key.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { pathToFileURL } from "node:url";
import { drawn, launch, mode, numbers, open, program, reading, says, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const GRAVITY = 9.81;
const MOTION = ["x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y", "xi", "slip", "lift_o", "lift_o_prime"];

/** A number of the answer, which may be the word infinite. */
const number = (said) => (said === "infinite" ? Infinity : said);
const near = (one, two, what, tolerance = 1e-9) =>
  assert.ok(one === two || Math.abs(one - two) <= tolerance * Math.max(1, Math.abs(one), Math.abs(two)), `${what}: ${one} and ${two}`);

/** A case as a person would type it: numbers of four digits, with points or commas, with or without units. */
function random(next, i) {
  const between = (least, greatest) => Number((least + next() * (greatest - least)).toPrecision(4));
  const [width, height] = [between(2, 20), between(2, 20)];
  const isWet = i % 2 === 1;
  return {
    width,
    height,
    mass: Number((width * height * between(1.8, 2.6)).toPrecision(4)),
    friction: i % 10 === 0 ? 0 : between(0.05, 1.1),
    thrust: Number((10 ** between(-1.5, 0.5) * 20 * width * height).toPrecision(4)),
    level: between(0, height),
    toRight: next() < 0.4,
    sea: isWet ? between(0, 0.9 * height) : 0,
    lee: isWet ? between(0, 0.9 * height) : 0,
    uplift: isWet ? between(0, 50) : 0,
  };
}

/** The same as a case file. The sea is where the force comes from. */
function caseFile({ width, height, mass, friction, thrust, level, toRight, sea, lee, uplift }) {
  const [left, right] = toRight ? ["right", "left"] : ["left", "right"];
  const parts = [`[body]\nwidth = ${width}\nheight = ${height}\nmass = "${mass} t/m"\nfriction = ${friction}`];
  if (sea || lee) parts.push(`[water]\n${left} = ${lee}\n${right} = ${sea}\ndensity = 1030`);
  if (uplift) parts.push(`[uplift]\n${left} = 0\n${right} = "${uplift} kPa"\ngrows = true`);
  parts.push(`[[load]]\nforce = "${thrust} kN/m"\nelevation = ${level}\ndirection = "${left}"`);
  return parts.join("\n\n") + "\n";
}

/** Types the case into the page. */
async function enter(page, given, i) {
  const text = (value, unit) => {
    // Three digits behind a comma could be thousands, and are refused.
    const hasComma = i % 3 === 0 && !/\.\d{3}$/.test(String(value));
    const plain = hasComma ? String(value).replace(".", ",") : String(value);
    return i % 4 === 2 && unit ? `${plain} ${unit}` : plain;
  };
  const units = { width: "m", height: "m", mass: "t/m", friction: "", thrust: "kN/m", level: "m", sea: "m", lee: "m", uplift: "kPa" };
  await page.evaluate(() => document.getElementById("path").setAttribute("open", ""));
  for (const [id, unit] of Object.entries(units)) await type(page, id, text(given[id], unit), i % 2 ? "Enter" : "Tab");
  await page.selectOption("#direction", given.toRight ? "right" : "left");
  await drawn(page);
}

test("30 cases typed key by key are the cases of program and sheet", async () => {
  const next = numbers(11);
  const folder = mkdtempSync(path.join(tmpdir(), "standfast-"));
  const seen = new Set();
  const [page, sheet] = [await open(browser), await browser.newPage()];
  for (let i = 0; i < 30; i++) {
    const given = random(next, i);
    const [file, sheetFile] = ["case.toml", "sheet.html"].map((name) => path.join(folder, name));
    writeFileSync(file, caseFile(given));
    const json = execFileSync(program, ["assess", "--format", "json", "-o", folder, file], { maxBuffer: 1e8 });
    const [said] = JSON.parse(json).situations;
    const what = (key) => `case ${i}, ${key}, ${JSON.stringify(given)}`;
    seen.add(said.mode);

    await enter(page, given, i);
    assert.equal(await mode(page), said.mode, what("mode"));
    const [sliding, overturning] = [said.SF_sliding, said.SF_overturning_net].map(number);
    const sentence = await page.textContent("#sentence");
    assert.ok(says(sentence, said.mode_words, { mode: said.mode, sliding, overturning }), what(`words: ${sentence}`));
    const { numbers: shown } = await reading(page);
    if (said.k_eff !== null) {
      near(shown.all_loads[2], said.k_eff, what("k_eff"));
      near(shown.all_loads[1], said.k_prime_eff, what("k'_eff"));
    }
    const [weight, half] = [given.mass * 1e3 * GRAVITY, given.width / 2];
    for (const [n, key] of MOTION.entries()) {
      const scale = key.startsWith("f_") ? weight : key === "xi" ? half : key === "theta_ddot" ? GRAVITY / half : GRAVITY;
      near(shown.motion[n] * scale, said.motion[key], what(key));
    }
    assert.equal(shown.factors === null, said.SF_sliding === null, what("factors"));
    for (const [n, key] of ["SF_sliding", "SF_overturning_net"].entries()) {
      if (said[key] !== null) near(shown.factors[n] ?? Infinity, number(said[key]), what(key));
    }

    execFileSync(program, ["sheet", file, "-o", sheetFile]);
    await sheet.goto(pathToFileURL(sheetFile).href);
    const verdict = sheet.locator(".summary .verdict").first();
    assert.equal(await verdict.getAttribute("data-mode"), said.mode, what("mode of the sheet"));
    assert.ok((await verdict.textContent()).includes(`he body ${said.mode_words} (`), what("words of the sheet"));
    const printed = await sheet.$$eval("data[data-quantity]", (all) =>
      all.map((data) => [data.dataset.quantity, data.getAttribute("value"), data.textContent]),
    );
    const found = (key) => printed.filter(([quantity]) => quantity === key).map(([, value]) => (value === "inf" ? Infinity : Number(value)));
    for (const key of ["SF_sliding", "SF_overturning_net", "SF_overturning_heel", "SF_overturning_toe", "k_eff", "k_prime_eff"]) {
      const values = found(key);
      assert.equal(values.length > 0, said[key] !== null, what(`${key} of the sheet`));
      for (const value of values) near(value, number(said[key]), what(`${key} of the sheet`));
    }
    for (const key of MOTION) {
      for (const value of found(`motion.${key}`)) near(value * (key.startsWith("f_") ? 1e3 : 1), said.motion[key], what(`${key} of the sheet`));
    }
  }
  assert.ok(seen.size >= 5, [...seen].join(" "));
});
