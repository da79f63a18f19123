// The same text in, the same JSON out as the program.

import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { launch, numbers, open, program, take, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const folder = mkdtempSync(path.join(tmpdir(), "standfast-"));

/** What the program says of a case file: its JSON, or the first line of its refusal. */
function native(file, command) {
  const options = command === "assess" ? ["--no-figures"] : ["--no-figures", "--no-strength"];
  const { status, stdout, stderr } = spawnSync(program, [command, "--format", "json", ...options, file], { encoding: "utf8", maxBuffer: 1e9 });
  return status === 0 ? JSON.parse(stdout) : { refused: stderr.split("\n")[0].replace(/^error: /, "") };
}

/** What the page says of a text. */
const paged = (page, name, content) =>
  page.evaluate(([file, toml]) => {
    const { explorer } = window.standfast;
    if (explorer.open(file, toml)) return JSON.parse(explorer.json());
    return { refused: JSON.parse(explorer.said()).fault.message };
  }, [name, content]);

/** That two documents are the same; numbers to what functions of different libraries of mathematics agree to. */
function same(one, two, where, tolerance) {
  if (typeof one === "number" && typeof two === "number") {
    const near = Math.abs(one - two) <= tolerance * Math.max(1e-9, Math.abs(one), Math.abs(two));
    return assert.ok(near || Math.abs(one - two) < 1e-9, `${where}: ${one} and ${two}`);
  }
  if (one === null || two === null || typeof one !== "object" || typeof two !== "object") return assert.deepEqual(one, two, where);
  assert.deepEqual(Object.keys(one), Object.keys(two), where);
  for (const key of Object.keys(one)) same(one[key], two[key], `${where}.${key}`, tolerance);
}

const examples = ["examples", "examples/motion", "examples/probability", "crates/cases/beginnings"].flatMap((place) =>
  readdirSync(path.join(root, place)).filter((name) => name.endsWith(".toml")).map((name) => path.join(root, place, name)));

test("every example has the program's JSON", async () => {
  const page = await open(browser);
  // The one record that is not in the page, as if it were dropped.
  const record = "np01002p_4225a_a.smc";
  const shaking = readFileSync(path.join(root, "examples/records", record), "latin1");
  await page.evaluate(([name, content]) => window.standfast.explorer.add_file(name, content), [record, shaking]);
  let answered = 0;
  for (const file of examples) {
    const content = readFileSync(file, "utf8");
    const found = await paged(page, file, content);
    const inTime = found.schema !== undefined && found.situations === undefined;
    const expected = native(file, inTime ? "simulate" : "assess");
    // A motion is followed through thousands of steps.
    same(found, expected, path.basename(file), inTime ? 1e-6 : 1e-11);
    answered += found.schema === undefined ? 0 : 1;
  }
  assert.ok(answered >= 28, `${answered} of ${examples.length}`);
  assert.deepEqual(page.heard, []);
  await page.close();
});

/** A case as people write them: numbers of four digits, with or without units; air, water, uplift, waves, ground, combinations. */
function random(next, i) {
  const between = (least, greatest) => Number((least + next() * (greatest - least)).toPrecision(4));
  const pick = (...all) => all[Math.floor(next() * all.length)];
  const [width, height] = [between(2, 20), between(2, 20)];
  const mass = i % 2 ? `mass = "${between(1.8 * width * height, 2.6 * width * height)} t/m"` : `density = "${between(1.8, 2.6)} t/m3"`;
  const parts = [`[body]\nwidth = "${width} m"\nheight = ${height}   # of the whole\n${mass}\nfriction = ${i % 10 === 0 ? 0 : between(0.05, 1.1)}`];
  if (i % 3 === 1) parts.push(`[water]\nleft = ${between(0, 0.9 * height)}\nright = ${between(0, 0.9 * height)}\ndensity = 1030`);
  if (i % 4 === 2) parts.push(`[uplift]\nleft = 0\nright = "${between(0, 50)} kPa"\ngrows = ${pick("true", "false")}`);
  if (i % 5 === 3) parts.push(pick(`[ground]\nstrength = "${between(300, 3000)} kPa"`, `[ground]\nfriction_angle_deg = ${between(25, 45)}\nunit_weight = "${between(8, 20)} kN/m3"`, `[ground]\nstiffness = "${between(20, 80)} MN/m3"`));
  if (i % 6 === 4) parts.push(`[earthquake]\nhorizontal = "${between(0.05, 0.6)} g"`);
  const count = 1 + Math.floor(next() * 2);
  for (let load = 0; load < count; load++) {
    const force = Number((10 ** (next() * 2 - 1.5) * 20 * width * height).toPrecision(4));
    parts.push(`[[load]]\nname = "push ${load + 1}"\nforce = "${force} kN/m"\nelevation = "${between(0, height)} m"\ndirection = "${pick("left", "right")}"`);
  }
  if (i % 7 === 5 && i % 6 !== 4) parts.push(`[[combination]]\nname = "raised"\nfactors = { weight = ${between(0.9, 1)}, "push 1" = ${between(1, 1.5)} }`);
  if (i % 2) parts.push(`[criteria]\nSF_sliding = ${between(1, 1.5)}\nSF_overturning_net = 1.2\nload_factor = 1.1`);
  return `title = "case ${i}"\n\n${parts.join("\n\n")}\n`;
}

test("500 random cases have the program's JSON", async () => {
  const page = await open(browser);
  const next = numbers(28);
  const seen = new Map();
  for (let i = 0; i < 500; i++) {
    const content = random(next, i);
    const file = path.join(folder, "case.toml");
    writeFileSync(file, content);
    const [found, expected] = [await paged(page, "case.toml", content), native(file, "assess")];
    same(found, expected, content, 1e-9);
    const mode = found.refused ? "refused" : (found.situations[found.governing].mode ?? "none");
    seen.set(mode, (seen.get(mode) ?? 0) + 1);
  }
  assert.ok(seen.size >= 8 && (seen.get("refused") ?? 0) < 50, JSON.stringify([...seen]));
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("30 cases typed key by key, with commas and units, are the cases of the program", async () => {
  const next = numbers(11);
  const between = (least, greatest) => Number((least + next() * (greatest - least)).toPrecision(4));
  const page = await open(browser);
  const written = ({ width, height, mass, friction, left, right, uplift, force, level }) =>
    `[body]\nwidth = "${width} m"\nheight = "${height} m"\nmass = "${mass} t/m"\nfriction = ${friction}\n\n[water]\nleft = "${left} m"\nright = "${right} m"\ndensity = 1030\n\n` +
    `[uplift]\nleft = 0\nright = "${uplift} kPa"\ngrows = true\n\n[[load]]\nforce = "${force} kN/m"\nelevation = "${level} m"\n`;
  const first = { width: 30, height: 30, mass: 1500, friction: 0.5, left: 1, right: 1, uplift: 10, force: 100, level: 1 };
  const keys = { width: "body.width", height: "body.height", mass: "body.mass", friction: "body.friction", left: "water.left", right: "water.right", uplift: "uplift.right", force: "load[1].force", level: "load[1].elevation" };
  const units = { friction: "", mass: "t/m", force: "kN/m", uplift: "kPa" };
  await page.click("#tab-inputs");
  const modes = new Set();
  for (let i = 0; i < 30; i++) {
    const [width, height] = [between(2, 20), between(2, 20)];
    const given = {
      width, height, mass: Number((width * height * between(1.8, 2.6)).toPrecision(4)), friction: between(0.05, 1.1), left: between(0, 0.9 * height), right: between(0, 0.9 * height),
      uplift: between(0, 50), force: Number((10 ** (next() * 2 - 1.5) * 20 * width * height).toPrecision(4)), level: between(0, height),
    };
    await take(page, "case.toml", written(first));
    // From a large body to a smaller one: what stands on it first.
    for (const key of ["level", "left", "right", "width", "height", "mass", "friction", "uplift", "force"]) {
      // Three digits behind a comma could be thousands, and are refused.
      const plain = String(given[key]);
      const typed = i % 3 === 0 && !/\.\d{3}$/.test(plain) ? plain.replace(".", ",") : plain;
      await type(page, keys[key], i % 4 === 2 ? `${typed} ${units[key] ?? "m"}` : typed, i % 2 ? "Enter" : "Tab");
    }
    const content = written(given);
    assert.equal(await page.evaluate(() => window.standfast.explorer.text()), content);
    const file = path.join(folder, "typed.toml");
    writeFileSync(file, content);
    const expected = native(file, "assess");
    same(JSON.parse(await page.evaluate(() => window.standfast.explorer.json())), expected, content, 1e-9);
    assert.equal(await page.textContent("#answer"), expected.summary.answer);
    modes.add(await page.getAttribute("#symbol", "data-mode"));
  }
  assert.ok(modes.size >= 4, [...modes].join(" "));
  await page.close();
});

test("500 points of the report's plane, by their old links, have the program's answer", async () => {
  const next = numbers(5);
  const between = (least, greatest) => least + next() * (greatest - least);
  const points = Array.from({ length: 500 }, (_, i) => {
    if (i % 5 === 0) {
      // Strong friction and a force below the centre, where answers need not be unique.
      return [10 ** between(-0.3, 0.6), between(-1, 0), 10 ** between(0, 1.5), 10 ** between(0.1, 1.2)];
    }
    const kPrime = i % 3 === 0 ? between(-1, 0) : i % 3 === 1 ? between(0, 1.2) : between(-4, -1);
    return [10 ** between(-1, 1), kPrime, 10 ** between(-1.5, 1.2), 10 ** between(-1.5, 1)];
  });
  const [given, answers] = ["points.csv", "answers.csv"].map((name) => path.join(folder, name));
  writeFileSync(given, ["gamma,k_prime,k,mu", ...points].map(String).join("\n") + "\n");
  execFileSync(program, ["batch", given, "-o", answers]);
  const [header, ...rows] = readFileSync(answers, "utf8").trim().split("\n").map((row) => row.split(","));
  const page = await open(browser);
  const found = await page.evaluate((all) => all.map(([g, kp, k, mu]) => {
    const { explorer } = window.standfast;
    if (!explorer.open_old_link(`g=${g}&kp=${kp}&k=${k}&mu=${mu}`)) return { refused: JSON.parse(explorer.said()).fault.message };
    const { mode, unique, point } = JSON.parse(explorer.said());
    return { mode, unique, point };
  }), points);
  const modes = new Set();
  let notUnique = 0;
  for (const [i, point] of points.entries()) {
    const where = `γ, k', k, μ = ${point}`;
    const native = Object.fromEntries(header.map((name, column) => [name, rows[i][column]]));
    const shown = found[i];
    assert.equal(shown.refused, undefined, where);
    assert.equal(shown.mode, native.mode, where);
    assert.equal(shown.unique, native.unique === "true", where);
    point.forEach((number, n) => assert.ok(Math.abs(shown.point[n] - number) <= 1e-12 * Math.max(1, Math.abs(number)), where));
    modes.add(shown.mode);
    notUnique += shown.unique ? 0 : 1;
  }
  assert.deepEqual([...modes].sort(), ["RE", "RO", "RO'", "SL", "SRO'-", "SRO+", "SRO-"]);
  assert.ok(notUnique > 5, `${notUnique} answers were not unique`);
  await page.close();
});
