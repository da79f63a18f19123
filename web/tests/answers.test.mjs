// What the page says is what the library says.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { html, launch, mode, numbers, onDisk, open, program, reading, site, type } from "./browser.mjs";

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
  await page.waitForFunction(() => document.getElementById("direction").value === "right");
  assert.equal(await mode(page), "RO'");
  await page.close();
});
