// One file, links, files, what is hostile, motion, looks.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { artefacts, drawn, drop, faults, html, launch, mode, onDisk, open, program, said, saved, site, take, text, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const root = path.resolve(path.dirname(fileURLToPath(import.meta.url)), "../..");
const example = (name) => readFileSync(path.join(root, "examples", name), "utf8");

const choose = async (page, name) => {
  await page.evaluate((one) => {
    const app = window.standfast;
    app.explorer.open_example(one);
    app.plate = "";
    app.showTab("why");
    app.changed();
  }, name);
  await drawn(page);
  await drawn(page);
};

const MODES = {
  RE: "g=0.8&kp=0.9&k=0.3&mu=0.6",
  SL: "g=1&kp=0.4&k=0.8&mu=0.4",
  RO: "g=3&kp=0.8&k=0.6&mu=0.4",
  "SRO-": "g=0.8&kp=0.9&k=0.8&mu=0.6",
  "SRO+": "g=3&kp=0.8&k=1.7&mu=0.05",
  "SRO'-": "g=1&kp=-0.6&k=5&mu=0.5",
  "RO'": "g=3&kp=0.8&k=0.6&mu=0.4&to=right",
  "SL+": "g=1&kp=0.4&k=0.8&mu=0.4&to=right",
  "SRO'+": "g=0.8&kp=0.9&k=0.8&mu=0.6&to=right",
};

test("the whole explorer is one file of 1.7 MB at most", (context) => {
  context.diagnostic(`${statSync(html).size} bytes`);
  assert.ok(statSync(html).size <= 1_700_000);
});

test("the policy allows the page's own scripts and style, by their hashes, and nothing from elsewhere", async () => {
  const policy = readFileSync(html, "utf8").match(/Content-Security-Policy" content="([^"]+)"/)[1];
  const scripts = policy.split(";").find((part) => part.trim().startsWith("script-src"));
  assert.match(scripts, /^ script-src( 'sha256-[A-Za-z0-9+/]{43}='){4} 'wasm-unsafe-eval'$/);
  assert.ok(!policy.includes("unsafe-inline") && policy.includes("worker-src blob:;"));
  assert.match(policy, /^default-src 'none';/);
  const page = await open(browser);
  const ran = await page.evaluate(async () => {
    const script = document.createElement("script");
    script.textContent = "window.hostile = 1";
    document.body.append(script);
    const image = document.createElement("div");
    image.innerHTML = '<img src="x" onerror="window.hostile = 2"><svg onload="window.hostile = 3"></svg>';
    document.body.append(image);
    await new Promise((done) => setTimeout(done, 200));
    return window.hostile;
  });
  assert.equal(ran, undefined);
  await page.close();
});

for (const [where, url] of [["from disk", onDisk], ["over http", site]]) {
  test(`opens ${where}, asks for nothing more, and says nothing in the console`, async (context) => {
    const page = await open(browser, { url });
    context.diagnostic(`ready after ${(await page.evaluate(() => window.standfast.ready)).toFixed(0)} ms`);
    assert.equal(await mode(page), "SRO-");
    assert.equal(await page.textContent("#answer"), "The body slides and rocks about O, the bottom left corner, which moves to the left (SRO-).");
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

test("works with the network off", async () => {
  const context = await browser.newContext({ offline: true });
  const page = await context.newPage();
  await page.goto(onDisk);
  await page.waitForFunction(() => window.standfast?.frames > 0);
  assert.equal(await mode(page), "SRO-");
  await context.close();
});

test("an address holds the text, its name and the view", async () => {
  for (const [name, content, plate] of [["goda-on-sand.toml", example("goda-on-sand.toml"), "load"], ["é 1.toml", example("caisson-in-air.toml"), "load"], ["quay.toml", example("quay.toml"), "k-mu"]]) {
    const page = await open(browser);
    await take(page, name, content);
    await page.click(`[data-plate="${plate}"]`).catch(() => {});
    await page.click("#tab-inputs");
    await drawn(page);
    await page.waitForFunction(() => /^#c=.*inputs$/.test(location.hash));
    const link = await page.evaluate(() => location.href);
    assert.match(link, /#c=[A-Za-z0-9_-]+&n=/);
    assert.ok(link.length < 4000, `${link.length} letters`);
    const again = await open(browser, { url: link });
    assert.equal(await text(again), content);
    assert.deepEqual(await said(again), { ...(await said(page)), can_undo: true });
    assert.equal(await again.innerHTML("#map .picture"), await page.innerHTML("#map .picture"));
    assert.ok(await again.isVisible("#panel-inputs"));
    assert.deepEqual(again.heard, []);
    await again.close();
    await page.close();
  }
});

test("Link copies what it says: the whole address on a site, its end from the # on from a disk", async () => {
  for (const [url, expected, words] of [[site, /^http:.*#c=/, /^Link copied/], [onDisk, /^#c=/, /behind the address of any copy/]]) {
    const context = await browser.newContext({ permissions: ["clipboard-read", "clipboard-write"] });
    const page = await context.newPage();
    await page.goto(url);
    await page.waitForFunction(() => window.standfast?.frames > 0);
    await page.evaluate(() => {
      window.copied = [];
      navigator.clipboard.writeText = async (one) => void window.copied.push(one);
    });
    await page.click("#link");
    await page.waitForFunction(() => window.copied.length > 0);
    await page.waitForFunction(() => document.getElementById("note").textContent !== "");
    assert.match(await page.evaluate(() => window.copied[0]), expected);
    assert.match(await page.textContent("#note"), words);
    await context.close();
  }
});

test("links of the first page open as cases, and become new ones", async () => {
  for (const [symbol, fragment] of Object.entries(MODES)) {
    const page = await open(browser, { fragment });
    assert.equal(await mode(page), symbol);
    const values = Object.fromEntries(fragment.split("&").map((part) => part.split("=")));
    const { point } = await said(page);
    ["g", "kp", "k", "mu"].forEach((key, i) => assert.ok(Math.abs(point[i] - Number(values[key])) < 1e-12, `${fragment}: ${key}`));
    await page.waitForFunction(() => location.hash.startsWith("#c="));
    await page.close();
  }
  const page = await open(browser, { fragment: "g=0.8&kp=0.9&k=0.5&mu=0.6&sea=8&lee=8&up=60000&fig=3.11&length=cm" });
  assert.ok((await text(page)).includes('[uplift]\nright = "60 kPa"\nleft = 0\ngrows = true'));
  await page.evaluate(() => (location.hash = "g=1&kp=1&k=2&mu=5"));
  await page.waitForFunction(() => document.getElementById("symbol").dataset.mode === "RO");
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("water above the crest is no answer, and says so", async () => {
  const page = await open(browser, { fragment: "g=0.8&kp=0.9&k=0.5&mu=0.6&sea=40" });
  assert.match(await page.textContent("#fault-message"), /40/);
  assert.match(await page.textContent("#still"), /still the answer/);
  await page.close();
});

/** What should run nothing, in any place. */
const HOSTILE = [
  "<script>window.hostile=1</script>", "<img src=x onerror=window.hostile=1>", "\"><svg onload=window.hostile=1>", "javascript:window.hostile=1",
  "'-window.hostile=1-'", "${window.hostile=1}", "{{window.hostile=1}}", "</textarea><img src=x onerror=window.hostile=1>", "</style><script>window.hostile=1</script>",
  "</svg><script>window.hostile=1</script>", "&lt;script&gt;window.hostile=1&lt;/script&gt;", "\u202E<b>", "%3Cscript%3Ewindow.hostile=1%3C/script%3E", "<iframe srcdoc='<script>parent.hostile=1</script>'>",
  "<a href=javascript:window.hostile=1>x</a>", "<math><mi xlink:href=\"javascript:window.hostile=1\">", "<details open ontoggle=window.hostile=1>", "__proto__", "constructor", "\\u003cscript\\u003ewindow.hostile=1",
];

test("hostile addresses run nothing", async () => {
  const page = await open(browser);
  const deflated = (content) => page.evaluate(async (one) => {
    const stream = new Blob([one]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
    return btoa(String.fromCharCode(...bytes)).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  }, content);
  const bomb = await page.evaluate(async () => {
    const stream = new Blob(["a".repeat(20_000_000)]).stream().pipeThrough(new CompressionStream("deflate-raw"));
    return btoa(String.fromCharCode(...new Uint8Array(await new Response(stream).arrayBuffer()))).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  });
  const fragments = [
    ...HOSTILE.map((one) => `g=${one}&kp=${one}`), ...HOSTILE.slice(0, 10).map((one) => `c=${encodeURIComponent(one)}`),
    "c=", "c=AAAA", "c=%00%00", `c=${bomb}`, "c=____&v=%3Cscript%3E,x&n=../../x", "g=1e50&k=1e999", "%E0%A4%A", "g=-1&kp=NaN&view=3,2,1&fig=<script>&%%%",
    `c=${await deflated(example("caisson-in-air.toml"))}&n=${encodeURIComponent("<img src=x onerror=window.hostile=1>")}&v=__proto__,constructor`,
  ];
  for (const one of HOSTILE.slice(0, 6)) fragments.push(`c=${await deflated(`title = ${JSON.stringify(one)}\n${one}`)}`);
  assert.ok(fragments.length >= 40, `${fragments.length}`);
  for (const fragment of fragments) {
    await page.evaluate((one) => (location.hash = one), fragment);
    await page.waitForTimeout(25);
    await drawn(page);
    assert.equal(await page.evaluate(() => window.hostile), undefined, fragment.slice(0, 90));
  }
  assert.deepEqual(page.heard.filter((heard) => heard.startsWith("error")), []);
  assert.ok((await page.textContent("#answer")).length > 10);
  await page.close();
});

test("hostile case files and records run nothing", async () => {
  const page = await open(browser);
  const body = "[body]\nwidth = 1\nheight = 2\nmass = 5e3\nfriction = 0.6\n";
  const load = "[[load]]\nforce = 7\nelevation = 1\n";
  const quoted = (one) => JSON.stringify(one);
  const files = HOSTILE.flatMap((one) => [
    `title = ${quoted(one)}\nnote = ${quoted(one)}\n${body}${load}name = ${quoted(one)}\n\n[[load]]\nname = ${quoted(`${one} 2`)}\nforce = 9\nelevation = 1\n`,
    `${body}${load}${quoted(one)} = 1\n`,
    `title = ${one}\n${body}`,
  ]);
  files.push(`${body}width = "${"9".repeat(5000)} m"\n`, "a = [".repeat(3000), `${body.replace("= 1\n", "= 1e308\n")}${load}`, "\u0000\uFFFE", `${body}[motion.base]\nhorizontal = { shape = "file", file = "${"../".repeat(40)}etc/passwd" }\n`);
  assert.ok(files.length >= 40);
  for (const [i, content] of files.entries()) {
    await drop(page, [[`${HOSTILE[i % HOSTILE.length].replaceAll("/", "")}.toml`, content]]);
    for (const tab of ["inputs", "why", "whole"]) {
      await page.evaluate((name) => window.standfast.showTab(name), tab);
      await drawn(page);
    }
    assert.equal(await page.evaluate(() => window.hostile), undefined, content.slice(0, 90));
  }
  await drop(page, [["x.csv", "<script>window.hostile=1</script>"], ["y.AT2", "\u0000".repeat(1000)]]);
  assert.equal(await page.evaluate(() => window.hostile), undefined);
  assert.deepEqual(page.heard.filter((heard) => heard.startsWith("error")), []);
  await page.close();
});

test("case, answers and drawings are saved", async () => {
  const page = await open(browser, { acceptDownloads: true, fragment: "g=3&kp=0.8&k=1.7&mu=0.05" });
  await drawn(page);
  const svg = await saved(page, "#save-plate");
  assert.equal(svg.name, "link-k-mu.svg");
  const drawing = svg.content.toString();
  assert.ok(!drawing.includes("var("), "colours are fixed");
  assert.match(drawing, /<title>Modes of a block/);
  // Case, values and verdict.
  assert.match(drawing, /\(1\.7, 0\.05\): SRO₊/);
  const sound = await page.evaluate((source) => new DOMParser().parseFromString(source, "image/svg+xml").querySelector("parsererror") === null, drawing);
  assert.ok(sound);
  const body = await saved(page, "#save-body");
  assert.ok(body.name === "link-section.svg" && /<title>Section: From a link/.test(body.content.toString()) && !body.content.toString().includes("var("));

  const png = await saved(page, "#save-png");
  assert.equal(png.content.subarray(1, 4).toString(), "PNG");
  assert.ok(png.content.readUInt32BE(16) > 1500, "wide enough to print");

  const csv = await saved(page, "#save-csv");
  const content = csv.content.toString();
  assert.ok(content.startsWith("\uFEFF"), "a mark for spreadsheets");
  const [header, ...rows] = content.slice(1).trim().split("\n");
  assert.equal(header, "what,k,mu");
  assert.match(rows[0], /^"design point of From a link: SRO\+",1\.[67]\d*,0\.05$/);
  const parsed = rows.map((row) => row.match(/^"([^"]+)",([^,]+),([^,]+)$/) ?? assert.fail(row));
  // μ* = (|a|k − b)/(ck + d) with a = 13 − 27 k', b = 9, c = 9 (1 + k'), d = 37.
  const rising = parsed.filter(([, name]) => name.includes("(|a|k − b)"));
  assert.equal(rising.length, 101);
  for (const [, , k, mu] of rising) assert.ok(Math.abs(Number(mu) - (8.6 * k - 9) / (16.2 * k + 37)) < 1e-12);
  assert.ok(parsed.some(([, name, k]) => name === "point E" && Math.abs(k - 9 / 8.6) < 1e-12));

  const json = JSON.parse((await saved(page, "#save-json")).content.toString());
  assert.equal(json.summary.answer, await page.textContent("#answer"));
  const report = await saved(page, "#save-text");
  assert.ok(report.name === "link.txt" && report.content.toString().includes("(SRO+)"));
  await page.click("#tab-whole");
  await drawn(page);
  assert.equal(await page.textContent("#whole"), report.content.toString());
  await page.close();
});

/** A sheet without the last digits of its numbers, in which tan and exp of two machines differ. */
const inTwelveDigits = (html) => html.replace(/value="(-?[\d.]+(e-?\d+)?)"/g, (_, number) => `value="${Number(number).toPrecision(12)}"`);

test("a sheet is the program's, with today's date", async () => {
  const page = await open(browser);
  const folder = mkdtempSync(path.join(tmpdir(), "sheet-"));
  for (const name of ["caisson-in-air.toml", "goda-on-sand.toml", "goda-2000-random.toml"]) {
    const file = path.join(folder, name);
    writeFileSync(file, example(name));
    await take(page, name, example(name));
    const today = await page.evaluate(() => new Date().toLocaleDateString("sv"));
    for (const [id, option, what] of [["#save-sheet", [], "sheet"], ["#save-short", ["--short"], "short-sheet"]]) {
      const found = await saved(page, id);
      const out = path.join(folder, "out.html");
      execFileSync(program, ["sheet", file, "--output", out, "--date", today, ...option]);
      assert.equal(found.name, name.replace(".toml", `-${what}.html`));
      // Without the sheets in the message.
      assert.ok(inTwelveDigits(found.content.toString()) === inTwelveDigits(readFileSync(out, "utf8")), `${name}: ${what}`);
    }
  }
  // A text with a fault has none.
  await take(page, "x.toml", "[body]");
  await page.click("#save-menu > summary");
  assert.ok(await page.isDisabled("#save-sheet"));
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("a published point: γ = 1, k' = 1, k = 2, μ = 5 rocks with θ̈ = 1.125 g/B", async () => {
  const page = await open(browser, { fragment: "g=1&kp=1&k=2&mu=5" });
  assert.equal(await page.textContent("#symbol"), "RO");
  const { situations: [answer] } = JSON.parse(await page.evaluate(() => window.standfast.explorer.json()));
  assert.ok(Math.abs(answer.motion.theta_ddot / ((1.125 * 9.81) / 7.5) - 1) < 1e-12);
  assert.match(await page.textContent("#rulers"), /overturning.*0\.2500 below 1/);
  await page.close();
});

test("what is not unique is said, and the chip shows it", async () => {
  const page = await open(browser, { fragment: "g=1&kp=-0.6&k=9&mu=5" });
  assert.equal((await said(page)).unique, false);
  assert.ok(await page.$eval("#symbol", (symbol) => symbol.classList.contains("several")));
  assert.match(await page.textContent("#sentences"), /not unique/i);
  await page.close();
});

test("the motion of every mode is shown, and none where a reader wants none", async () => {
  const moves = (page) => page.evaluate(() => document.querySelector("#body .body").getAnimations().length);
  for (const [symbol, fragment] of Object.entries(MODES)) {
    const page = await open(browser, { fragment });
    assert.equal(await mode(page), symbol);
    await page.click("#begins");
    await page.waitForTimeout(450);
    assert.equal(await moves(page), symbol === "RE" ? 0 : 1, symbol);
    const ghost = await page.locator('#body [stroke-dasharray="3 2.4"]').count();
    assert.equal(ghost, symbol === "RE" ? 0 : 1, symbol);
    assert.match(await page.textContent("#body-hint"), symbol === "RE" ? /at rest/ : /exaggerated/);
    await page.close();
  }
  const page = await open(browser, { fragment: MODES.RO, reducedMotion: "reduce" });
  await page.click("#begins");
  await page.waitForTimeout(450);
  assert.equal(await moves(page), 0);
  await page.click("#play");
  assert.equal(await moves(page), 1);
  await page.click("#play");
  assert.equal(await moves(page), 0);
  await page.click("#to-scale");
  await drawn(page);
  assert.ok(await page.isVisible("#section"));
  await page.close();
});

test("all 26 figures of the report, and the case of the body, stand in the report's terms", async () => {
  const page = await open(browser);
  await page.click("#tab-terms");
  await drawn(page);
  const numbers = await page.$$eval("#figure option", (options) => options.map((option) => option.value));
  assert.equal(numbers.length, 26);
  for (const number of numbers) {
    await page.selectOption("#figure", number);
    await drawn(page);
    assert.ok((await page.textContent("#figure-picture svg title")).startsWith(`Fig. ${number} `), number);
  }
  await page.selectOption("#figure", "3.10");
  await page.click("#next");
  await drawn(page);
  assert.equal(await page.inputValue("#figure"), "3.11");
  await page.click("#previous");
  await page.click("#previous");
  await drawn(page);
  assert.equal(await page.inputValue("#figure"), "3.9b");
  assert.deepEqual(await page.$$eval("#numbers td:last-child", (cells) => cells.map((cell) => cell.textContent)), ["0.8", "0.9166667", "0.72812", "0.6"]);
  const [spot, map] = [await page.locator("#cases .spot").boundingBox(), await page.locator("#cases svg").boundingBox()];
  assert.ok(spot.x > map.x && spot.x < map.x + map.width && spot.y > map.y && spot.y < map.y + map.height);
  await page.close();
});

test("paper is light, A4, and holds the answer, both plates, why and all inputs", async () => {
  mkdirSync(artefacts, { recursive: true });
  const page = await open(browser, { colorScheme: "dark", viewport: { width: 688, height: 972 } });
  await take(page, "goda-on-sand.toml", example("goda-on-sand.toml"));
  await page.emulateMedia({ media: "print" });
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  assert.equal(await page.evaluate(() => getComputedStyle(document.body).backgroundColor), "rgb(253, 253, 251)");
  assert.match(await page.textContent("#print-head"), /^Goda's caisson on sand · goda-on-sand\.toml · \d{4}-\d\d-\d\d · /);
  for (const shown of ["#print-head", "#answer", "#section svg", "#map .picture svg", "#checks", "#form"]) assert.ok(await page.locator(shown).isVisible(), shown);
  for (const hidden of ["header", ".tabs", "#pane", ".zoom"]) assert.ok(!(await page.locator(hidden).isVisible()), hidden);
  assert.ok((await page.locator("#form input:visible").count()) > 10);
  const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.equal(over, 0);
  await page.screenshot({ path: path.join(artefacts, "print.png"), fullPage: true });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  assert.equal(await page.getAttribute("html", "data-theme"), "dark");
  await page.close();
});

test("on a phone the answer, the body and the plane are on the first screen, and labels can be read", async () => {
  const page = await open(browser, { viewport: { width: 390, height: 844 } });
  for (const name of ["Caisson in air", "Goda’s caisson", "Server rack", "Statue on its pedestal", "A block"]) {
    await page.click("#case-menu > summary");
    await page.click(`[data-case="${name}"]`);
    await drawn(page);
    await page.evaluate(() => scrollTo(0, 0));
    const places = await page.evaluate(() => ["#answer", "#section svg", "#map .picture"].map((one) => document.querySelector(one).getBoundingClientRect().bottom));
    assert.ok(places.every((bottom, i) => bottom <= 844 && bottom > (places[i - 1] ?? 0)), `${name}: ${places}`);
  }
  await page.close();
});

/** Drawings that are seen, each with how much smaller or larger than the library drew it; it draws no letters under 12 units for a screen. */
const scales = (page) => page.evaluate(() => {
  const all = ["#section .picture svg", "#body svg", "#stage svg", "#map .picture svg", "#strengths svg"].flatMap((one) => [...document.querySelectorAll(one)]);
  return all.filter((one) => one.checkVisibility()).map((svg) => [svg.querySelector("title").textContent, svg.getBoundingClientRect().width / svg.viewBox.baseVal.width]);
});

test("at the width of a phone no drawing of any example is made smaller: the library lays it out anew", async () => {
  const page = await open(browser, { viewport: { width: 390, height: 844 }, reducedMotion: "reduce" });
  const names = await page.$$eval("[data-case]", (all) => all.map((one) => one.dataset.case));
  for (const name of names) {
    await choose(page, name);
    for (const view of ["moves", "to-scale"]) {
      await page.evaluate((id) => document.getElementById(id).click(), view);
      await drawn(page);
      // A body in pure numbers has no section: there its positions stand, a figure for paper.
      for (const [title, scale] of (await scales(page)).filter(([title]) => !title.endsWith(": positions"))) assert.ok(scale > 0.999, `${name}: ${title} is made ${scale} as large`);
    }
  }
  await page.close();
});

test("at 1280 by 800 the tabs and the first row of one are on the first screen, for every example", async () => {
  const page = await open(browser, { viewport: { width: 1280, height: 800 }, reducedMotion: "reduce" });
  const names = await page.$$eval("[data-case]", (all) => all.map((one) => one.dataset.case));
  assert.ok(names.length >= 22);
  for (const name of names) {
    await choose(page, name);
    if (await page.evaluate(() => window.standfast.motion !== null)) {
      await page.waitForSelector("#strengths:not([hidden]) svg", { timeout: 30_000 });
      await drawn(page);
      await drawn(page);
    }
    const seen = await page.evaluate(() => {
      // The line of a criterion with its value, without the words below it, or the first line of a sentence.
      const row = [...document.querySelectorAll("#panel-why :is(tbody tr, p)")].find((one) => one.checkVisibility() && one.textContent);
      const range = document.createRange();
      range.selectNodeContents(row.querySelector("td") ?? row);
      return {
        tabs: document.querySelector(".tabs").getBoundingClientRect().bottom,
        row: range.getClientRects()[0].bottom,
        plates: [...document.querySelectorAll("#section svg, #stage svg, #map .picture svg")].filter((one) => one.checkVisibility()).length,
      };
    });
    assert.ok(seen.tabs <= 800 && seen.row <= 800 && seen.row > seen.tabs, `${name}: ${JSON.stringify(seen)}`);
    assert.ok(seen.plates >= 1, name);
  }
  await page.close();
});

test("friction and the ground’s angle are fields where they act, and what comes and what is borne is the program’s", async () => {
  for (const width of [390, 1280]) {
    const page = await open(browser, { viewport: { width, height: 844 } });
    await choose(page, "Goda’s caisson on sand");
    const boxes = await page.evaluate(() => ["svg", '.over input[data-key="body.friction"]', '.over input[data-key="ground.friction_angle_deg"]'].map((one) => document.querySelector(`#section ${one}`)?.getBoundingClientRect().toJSON()));
    const [drawing, ...fields] = boxes;
    for (const place of fields) assert.ok(place.left >= 0 && place.right <= width && place.top > drawing.top && place.bottom < drawing.bottom, `${width}: ${JSON.stringify(place)}`);
    assert.equal(await page.locator('#loose input[data-key="ground.friction_angle_deg"], #loose input[data-key="body.friction"]').count(), 0);
    await type(page, "ground.friction_angle_deg", "38");
    assert.match(await text(page), /friction_angle_deg = 38 /);
    await page.keyboard.press("Control+z");
    await drawn(page);
    const words = await page.$$eval("#legend li", (all) => all.map((one) => one.textContent).join(" "));
    assert.match(words, /sketch of how the ground fails/);
    await page.close();
  }
});

test("pressures stand along their faces, or each as one arrow", async () => {
  for (const [width, height] of [[390, 844], [1280, 800], [1920, 1080]]) {
    const page = await open(browser, { viewport: { width, height } });
    assert.equal(await page.isVisible("#sums"), false, "a single force has nothing to sum");
    await take(page, "goda-2000.toml", example("goda-2000.toml"));
    const seen = () => page.evaluate(() => {
      const drawing = JSON.parse(window.standfast.explorer.section(document.getElementById("section").clientWidth, 340, document.getElementById("pressures-summed").getAttribute("aria-pressed") === "true"));
      return { room: drawing.body[2] - drawing.body[0], legend: document.getElementById("legend").textContent };
    });
    const along = await seen();
    await page.click("#pressures-summed");
    await drawn(page);
    const summed = await seen();
    // On a phone the words of an arrow take what its pressure took.
    if (width > 390) assert.ok(summed.room >= along.room, `${width}: ${along.room} ${summed.room}`);
    assert.doesNotMatch(along.legend, /wave[^,]*, [\d.]+ kN.m to the left, [\d.]+ m above the base/);
    assert.match(summed.legend, /wave[^,]*, [\d.]+ kN.m to the left, [\d.]+ m above the base/);
    await page.locator("#section").screenshot({ path: path.join(artefacts, `sums-${width}.png`) });
    await page.click("#pressures-along");
    await drawn(page);
    assert.deepEqual(await seen(), along);
    assert.deepEqual(page.heard, []);
    await page.close();
  }
});

test("on a phone a body that pressures leave little room has their sums, until a person chooses", async () => {
  const page = await open(browser, { viewport: { width: 390, height: 844 } });
  await take(page, "quay.toml", example("quay.toml"));
  const wide = () => page.evaluate(() => document.querySelector("#section svg").getBoundingClientRect().width);
  assert.equal(await page.getAttribute("#pressures-summed", "aria-pressed"), "true");
  assert.ok((await wide()) <= 390);
  await page.click("#pressures-along");
  await drawn(page);
  assert.equal(await page.getAttribute("#pressures-summed", "aria-pressed"), "false");
  // A choice stays, and is not offered where there is nothing to sum.
  await page.click("#pressures-summed");
  await take(page, "air.toml", example("caisson-in-air.toml"));
  assert.equal(await page.isVisible("#sums"), false);
  await page.close();
});

test("numbers beside the drawing have their names in words, not those of keys", async () => {
  const page = await open(browser, { viewport: { width: 1280, height: 800 }, reducedMotion: "reduce" });
  for (const name of await page.$$eval("[data-case]", (all) => all.map((one) => one.dataset.case))) {
    await choose(page, name);
    const labels = await page.$$eval("#loose .number > label", (all) => all.map((one) => [one.firstChild.textContent.trim(), one.htmlFor]));
    const said = await page.evaluate(() => window.standfast.said.tables.flatMap(({ numbers }) => numbers.map(({ key, label, words }) => [key, label, words])));
    for (const [label, id] of labels) {
      const key = await page.getAttribute(`#${id}`, "data-key");
      const [, expected, words] = said.find(([one]) => one === key);
      assert.equal(label, expected, `${name}: ${key}`);
      assert.ok(words.startsWith(expected.split(",")[0]), `${key}: ${expected}`);
      assert.ok(await page.isVisible(`#${id}`), `${name}: ${key} has its field`);
    }
  }
  await page.close();
});

for (const colorScheme of ["light", "dark"]) {
  test(`axe finds no fault, ${colorScheme}`, async () => {
    for (const [width, name] of [[1280, "Caisson in air"], [390, "Goda’s caisson on sand"], [1920, "Server rack"], [1280, "Server rack in an earthquake"]]) {
      const page = await open(browser, { colorScheme, viewport: { width, height: 900 } });
      await page.click("#case-menu > summary");
      const clean = async (where) => assert.deepEqual(await faults(page), [], where);
      await clean("menu");
      await page.click(`[data-case="${name}"]`);
      await drawn(page);
      for (const tab of ["why", "help", "likely", "inputs", "whole", "terms"]) {
        await page.click(`#tab-${tab}`);
        await drawn(page);
        await clean(`${name}, ${tab}`);
      }
      await type(page, "body.friction", "x");
      await take(page, "fault.toml", "[body]\nheigth = 1\n");
      await clean("a fault");
      await page.close();
    }
  });
}

test("a window of a pixel is drawn in, and left again", async () => {
  const page = await open(browser);
  for (const name of ["Caisson in air", "Quay wall with backfill", "Server rack in an earthquake"]) {
    await page.setViewportSize({ width: 1280, height: 900 });
    await choose(page, name);
    for (const tab of ["why", "likely", "inputs", "whole", "terms"]) {
      await page.setViewportSize({ width: 1280, height: 900 });
      await page.click(`#tab-${tab}`);
      await page.setViewportSize({ width: 1, height: 1 });
      await drawn(page);
    }
  }
  await page.setViewportSize({ width: 1280, height: 900 });
  await drawn(page);
  assert.deepEqual(page.heard, []);
  assert.ok(await page.isVisible("#cases svg") || await page.evaluate(() => window.standfast.said.point === null));
  await page.close();
});

test("pictures of every state at three widths, in two themes, without sideways scrolling", async () => {
  mkdirSync(artefacts, { recursive: true });
  const looks = [
    ["slides-rocks", "Caisson in air"], ["at-rest", "Goda’s caisson"], ["not-met", "Server rack"], ["ground", "Goda’s caisson on sand"],
    ["time", "Server rack in an earthquake"], ["combinations", "Quay wall with backfill"], ["block", "Block in pure numbers"], ["parts", "Crown wall"], ["not-unique", null], ["bad-input", null], ["dropped-error", null], ["menu", null],
    ["inputs", "Caisson in air"], ["terms", "Caisson in air"], ["whole", "Goda’s caisson on sand"], ["begins", "Caisson in air"],
  ];
  for (const [width, height] of [[320, 640], [390, 844], [1280, 800], [1920, 1080]]) {
    for (const colorScheme of ["light", "dark"]) {
      const page = await open(browser, { colorScheme, viewport: { width, height } });
      for (const [look, name] of looks) {
        await page.evaluate((one) => {
          const app = window.standfast;
          app.explorer.open_example(one ?? "Caisson in air");
          app.plate = "";
          app.showTab("why");
          app.changed();
        }, name);
        await drawn(page);
        if (look === "not-unique") await page.evaluate(() => (window.standfast.explorer.open_old_link("g=1&kp=-0.6&k=9&mu=5"), window.standfast.changed()));
        if (look === "bad-input") await type(page, "load[1].force", "2,700");
        if (look === "dropped-error") await drop(page, [["breakwater-north.toml", example("caisson-in-air.toml").replace("height", "heigth")]]);
        if (look === "menu") await page.click("#case-menu > summary");
        if (["inputs", "terms", "whole"].includes(look)) await page.click(`#tab-${look}`);
        await page.evaluate((begins) => document.getElementById(begins ? "begins" : "to-scale").click(), look === "begins");
        await drawn(page);
        const over = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
        assert.equal(over, 0, `${look} at ${width}`);
        if (width > 320) await page.screenshot({ path: path.join(artefacts, `${look}-${width}-${colorScheme}.png`), fullPage: width === 390 && look !== "menu" });
        if (look === "menu") await page.keyboard.press("Escape");
        if (look === "bad-input") await page.keyboard.press("Escape");
      }
      assert.deepEqual(page.heard, []);
      await page.close();
    }
  }
});
