// What the page says is what the library says.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { drawn, html, launch, mode, numbers, onDisk, open, program, reading, says, site, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

test("the whole explorer is one file below a megabyte", () => {
  assert.ok(statSync(html).size < 1_000_000);
});

for (const [where, url] of [["from disk", onDisk], ["over http", site]]) {
  test(`opens ${where}, asks for nothing more, and says nothing in the console`, async () => {
    const page = await open(browser, { url });
    assert.equal(await mode(page), "SRO-");
    assert.match(await page.textContent("#sentence"), /slides and rocks about O/);
    const others = page.asked.filter((asked) => asked.split("#")[0] !== url && !asked.startsWith("data:"));
    assert.deepEqual(others, []);
    assert.deepEqual(page.heard, []);
    await page.close();
  });
}

test("the page may not fetch", async () => {
  const page = await open(browser, { url: site });
  const fetched = await page.evaluate((url) => fetch(url).then(() => "fetched", () => "refused"), site);
  assert.equal(fetched, "refused");
  await page.close();
});

test("500 random readings are those of the native program", async () => {
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
  const folder = mkdtempSync(path.join(tmpdir(), "standfast-"));
  const [given, answered] = ["points.csv", "answers.csv"].map((name) => path.join(folder, name));
  writeFileSync(given, ["gamma,k_prime,k,mu", ...points].map(String).join("\n") + "\n");
  execFileSync(program, ["batch", given, "-o", answered]);
  const [header, ...rows] = readFileSync(answered, "utf8").trim().split("\n").map((row) => row.split(","));
  assert.equal(rows.length, 500);
  const column = (row, name) => row[header.indexOf(name)];

  const page = await open(browser);
  const fields = ["slenderness", "elevation", "force", "friction"];
  const modes = new Set();
  let notUnique = 0;
  for (const [i, point] of points.entries()) {
    // Put into the fields, and read from the page.
    const said = await page.evaluate(
      async ([ids, values]) => {
        ids.forEach((id, i) => {
          const field = document.getElementById(id);
          field.value = String(values[i]);
          field.dispatchEvent(new Event("input", { bubbles: true }));
          field.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
        });
        await new Promise(requestAnimationFrame);
        return {
          mode: document.getElementById("symbol").dataset.mode,
          unique: document.getElementById("uniqueness").textContent.startsWith("The answer is unique"),
          numbers: window.standfast.reading.numbers,
        };
      },
      [fields, point],
    );
    const row = rows[i];
    const where = `γ, k', k, μ = ${point}`;
    assert.deepEqual(said.numbers.given, point, where);
    assert.equal(said.mode, column(row, "mode"), where);
    assert.equal(said.unique, column(row, "unique") === "true", where);
    assert.equal(said.numbers.others.join(" "), column(row, "also"), where);
    for (const [at, name] of ["x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y", "xi"].entries()) {
      const native = Number(column(row, name));
      const near = 1e-12 * Math.max(1, Math.abs(native));
      assert.ok(Math.abs(said.numbers.motion[at] - native) <= near, `${name} at ${where}`);
    }
    modes.add(said.mode);
    notUnique += said.unique ? 0 : 1;
  }
  assert.deepEqual([...modes].sort(), ["RE", "RO", "RO'", "SL", "SRO'-", "SRO+", "SRO-"]);
  assert.ok(notUnique > 5, `${notUnique} readings were not unique`);
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("a published point: γ = 1, k' = 1, k = 2, μ = 5 rocks with θ̈ = 1.125 g/B", async () => {
  const page = await open(browser);
  for (const [id, text] of [["slenderness", "1"], ["elevation", "1"], ["force", "2"], ["friction", "5"]]) {
    await type(page, id, text);
  }
  assert.equal(await page.textContent("#symbol"), "RO");
  assert.match(await page.textContent("#motion tbody tr:nth-child(3)"), /1\.125 g\/B/);
  assert.match(await page.textContent("#factors"), /overturning.*0\.25 < 1/);
  await page.close();
});

test("a body in units is the same body in numbers", async () => {
  const page = await open(browser);
  for (const [id, text] of [["width", "10"], ["height", "20"], ["mass", "100"], ["thrust", "490.5"], ["level", "15"]]) {
    await type(page, id, text);
  }
  const [gamma, kPrime, k] = (await reading(page)).numbers.given;
  assert.equal(gamma, 2);
  assert.equal(kPrime, 0.5);
  // 490.5 kN/m on 100 t/m at 9.81 m/s².
  assert.ok(Math.abs(k - 0.5) < 1e-15);
  await page.selectOption('[data-unit="length"]', "cm");
  await page.waitForFunction(() => document.getElementById("height").value === "2000");
  await page.selectOption("#direction", "right");
  await drawn(page);
  assert.equal(await mode(page), "RO'");
  await page.close();
});

/** What the program says of the explorer's body, 15 m by 15 γ m and 378 t/m, under all its loads. */
/** A number of the answer, which may be the word infinite. */
const number = (said) => (said === "infinite" ? Infinity : said);

function assess({ g, kp, k, mu, sea, lee, up }) {
  // The force comes from the right.
  const weight = 378e3 * 9.81;
  const file = path.join(mkdtempSync(path.join(tmpdir(), "standfast-")), "case.toml");
  const parts = [
    `[body]\nwidth = 15.0\nheight = ${15 * g}\nmass = 378000.0\nfriction = ${mu}\n`,
    `[water]\nleft = ${lee}\nright = ${sea}\ndensity = 1030.0\n`,
    `[uplift]\nleft = 0.0\nright = ${up}\ngrows = true\n`,
    `[[load]]\nforce = ${k * weight}\nelevation = ${((1 + kp) * 15 * g) / 2}\ndirection = "left"\n`,
  ];
  writeFileSync(file, parts.join("\n"));
  const [said] = JSON.parse(execFileSync(program, ["assess", "--format", "json", "-o", path.dirname(file), file], { maxBuffer: 1e8 })).situations;
  // The names of the program's results stand here alone.
  return {
    mode: said.mode,
    words: said.mode_words,
    kEff: said.k_eff,
    kPrimeEff: said.k_prime_eff,
    lifted: said.lifted,
    motion: said.motion,
    sliding: number(said.SF_sliding),
    overturning: number(said.SF_overturning_net),
    departure: said.departure,
    departureBy: said.departure_by,
    loadFactor: said.load_factor,
    departsInto: said.departure_mode,
  };
}

const fragmentOf = (loads) => Object.entries(loads).map(([key, value]) => `${key}=${value}`).join("&");
const near = (one, two, what, tolerance = 1e-9) =>
  assert.ok(one === two || Math.abs(one - two) <= tolerance * Math.max(1, Math.abs(one), Math.abs(two)), `${what}: ${one} and ${two}`);
/** A number as the page writes it. */
const written = (text) => (text === "∞" ? Infinity : Number(text.replace("−", "-").replace(/ × 10(.+)/, (_, power) => `e${power.replace("−", "-")}`)));

const WET = { g: 0.8, kp: 0.9, k: 0.5, mu: 0.6, sea: 8, lee: 8, up: 60000 };
const ALL_LOADS = {
  "water and uplift": WET,
  "sea only": { ...WET, lee: 0, up: 0 },
  "water behind, which pushes against the force": { ...WET, sea: 0, lee: 9, k: 0.05, up: 0 },
  "uplift without water": { ...WET, sea: 0, lee: 0, k: 0.3 },
  "low force": { ...WET, kp: -0.6, k: 1.2, up: 20000 },
  "at rest": { ...WET, k: 0.05, up: 1000 },
  "lifted": { ...WET, k: 0.1, up: 400000 },
  "no force on equal levels": { ...WET, k: 0, up: 0 },
  "uplift alone": { ...WET, k: 0, sea: 0, lee: 0, up: 300000 },
  "smooth": { ...WET, mu: 0 },
};

for (const [name, loads] of Object.entries(ALL_LOADS)) {
  test(`under all loads the page says what the program says: ${name}`, async () => {
    const said = assess(loads);
    const page = await open(browser, { fragment: fragmentOf(loads) });
    // The headline, its tint and what is read aloud.
    assert.equal(await mode(page), said.mode);
    assert.ok(says(await page.textContent("#sentence"), said.words, said));
    assert.equal((await page.textContent("#sentence")).startsWith("All loads together no longer press downwards."), said.lifted);
    assert.match(await page.textContent("#scope"), /^Under all loads/);
    await page.waitForFunction(() => document.getElementById("live").textContent !== "");
    const live = await page.textContent("#live");
    assert.ok(live.startsWith("Under all loads, water and uplift included. ") && says(live, said.words, said), live);

    const { numbers: shown, is_drawn: isDrawn } = await reading(page);
    assert.equal(isDrawn, said.kEff !== null);
    assert.equal(await page.locator("#point").isVisible(), said.kEff !== null);
    assert.equal(await page.locator("#map svg").count() > 1, said.kEff !== null);
    if (said.kEff !== null) {
      near(shown.all_loads[2], said.kEff, "k_eff");
      near(shown.all_loads[1], said.kPrimeEff, "k'_eff");
      assert.ok((await page.getAttribute("#point", "aria-label")).includes(`k of all loads ${Number(said.kEff.toPrecision(7))},`));
      // The diagram is that of k'_eff; its title has three digits.
      const [, drawnFor] = (await page.textContent("#map .picture title")).match(/k′ = ([−\d.]+)/);
      near(written(drawnFor), said.kPrimeEff, "k' of the diagram", 5e-3);
    }
    // SI: the true weight, not one that all loads are measured in.
    const si = await page.$$eval("#motion tbody tr", (rows) => rows.map((row) => row.cells[3].textContent));
    const names = ["x_ddot", "y_ddot", "theta_ddot", "f_x", "f_y", "xi", "slip", "lift_o", "lift_o_prime"];
    for (const [i, key] of names.entries()) {
      const [, text, unit] = si[i].match(/^(.+) (\S+)$/);
      near(written(text) * (unit === "kN/m" ? 1e3 : 1), said.motion[key], key, 6e-4);
      const scale = key.startsWith("f_") ? 378e3 * 9.81 : key === "xi" ? 7.5 : key === "theta_ddot" ? 9.81 / 7.5 : 9.81;
      near(shown.motion[i] * scale, said.motion[key], key);
    }
    // Of a lifted body there are none.
    assert.equal(shown.factors === null, said.sliding === null);
    for (const [i, factor] of [said.sliding, said.overturning].entries()) {
      if (factor !== null) near(shown.factors[i] ?? Infinity, factor, "safety factor");
    }
    assert.equal(await page.locator("#factors > *").count() > 0, said.sliding !== null);
    await page.close();
  });
}

test("water and uplift open their panel, and the body in air hides it again", async () => {
  const page = await open(browser, { fragment: fragmentOf(WET) });
  assert.equal(await page.getAttribute("#path", "open"), "");
  assert.match(await page.textContent("#map-note"), /^Drawn for all loads/);
  for (const id of ["sea", "lee", "uplift"]) await type(page, id, "0");
  assert.equal(await mode(page), "RE");
  assert.equal(await page.textContent("#scope"), "");
  assert.equal(await page.textContent("#map-note"), "");
  await page.close();
});

test("the point of all loads is dragged by changing the force, and stays under the hand", async () => {
  const page = await open(browser, { fragment: fragmentOf(WET) });
  const box = async () => {
    const { x, y, width, height } = await page.locator("#point").boundingBox();
    return [x + width / 2, y + height / 2];
  };
  const [x, y] = await box();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 50, y - 30, { steps: 4 });
  await page.mouse.move(x - 90, y - 50, { steps: 4 });
  await drawn(page);
  const [x2, y2] = await box();
  assert.ok(Math.hypot(x2 - (x - 90), y2 - (y - 50)) < 2, `${x2}, ${y2}`);
  await page.mouse.up();
  await drawn(page);
  const { numbers: shown } = await reading(page);
  const [, kp, k, mu] = shown.given;
  assert.ok(k < 0.5 && mu > 0.6);
  assert.equal(kp, 0.9);
  const said = assess({ ...WET, k, mu });
  assert.equal(await mode(page), said.mode);
  near(shown.all_loads[2], said.kEff, "k_eff");
  await page.close();
});

test("water above the crest is no answer, and says so", async () => {
  const page = await open(browser, { fragment: "g=0.8&kp=0.9&k=0.5&mu=0.6&sea=40" });
  assert.equal(await page.textContent("#symbol"), "—");
  assert.match(await page.textContent("#sentence"), /^No answer\. Water level is 40; expected no more than the height/);
  assert.ok(!(await page.isVisible("#point")));
  assert.equal(await page.textContent("#motion tbody"), "");
  await type(page, "sea", "4");
  assert.equal(await mode(page), assess({ g: 0.8, kp: 0.9, k: 0.5, mu: 0.6, sea: 4, lee: 0, up: 0 }).mode);
  assert.deepEqual(page.heard, []);
  await page.close();
});

const AIR = { g: 0.8, kp: 0.9, k: 0.5, mu: 0.6, sea: 0, lee: 0, up: 0 };
for (const [name, loads, words] of [
  ["no friction", { ...AIR, mu: 0 }, /^Any share of the load moves the body, however small, into SL\.$/],
  ["no friction, the least force", { ...AIR, mu: 0, k: 1e-30 }, /^Any share of the load moves the body, however small, into SL\.$/],
  ["no friction and no force", { ...AIR, mu: 0, k: 0 }, /^The body stays at rest whatever the load factor\.$/],
  ["no force", { ...AIR, k: 0 }, /^The body stays at rest whatever the load factor\.$/],
  ["far beyond twice the load", { ...AIR, k: 0.001 }, /^As the load rises, the body leaves rest at λ = 600 of it, into SL\.$/],
  ["water on one side, no friction", { ...AIR, mu: 0, lee: 3 }, /^The permanent loads alone move the body, into SL\+; the force is not needed\.$/],
  ["all loads", WET, /^As the load rises, the body leaves rest at λ = 0\.705 of it, into SL\.$/],
]) {
  test(`where it leaves rest is said as it is: ${name}`, async () => {
    const page = await open(browser, { fragment: fragmentOf(loads) });
    if ((await page.getAttribute("#path", "open")) === null) await page.click("summary");
    await page.waitForSelector("#path-picture svg");
    const said = await page.textContent("#path-words p");
    assert.match(said, words);
    const beside = await page.textContent("#departure");
    if ((await reading(page)).with_water) assert.equal(beside, said);
    else if (loads.mu === 0) assert.equal(beside, "Any force at this elevation moves the body, however small, into SL.");
    // The program says the same.
    const { departure, departureBy, loadFactor, departsInto } = assess(loads);
    const start = { at: "As the load rises, the body leaves rest", never: "The body stays", "permanent-loads": "The permanent", "any-share": "Any share" };
    assert.ok(said.startsWith(start[departureBy ?? departure]), `${said}: ${departure}`);
    if (departure === "at") near(Number(said.match(/λ = ([\d.]+)/)[1]), loadFactor, "λ", 1e-3);
    if (departsInto) assert.ok(said.includes(`into ${departsInto}`));
    await page.close();
  });
}
