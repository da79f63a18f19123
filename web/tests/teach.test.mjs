// Stories that take the whole page, and parts of the page in a frame.

import assert from "node:assert/strict";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { artefacts, drawn, faults, html, launch, mode, open, said, site, text, type } from "./browser.mjs";

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const IDS = ["two-factors", "k-mu", "blow", "islands", "ground", "sure"];
const place = (page) => page.textContent("#story-place");
const hash = (page) => page.evaluate(() => location.hash);
const told = (page) => page.evaluate(() => window.standfast.story?.step ?? 0);
const still = { reducedMotion: "reduce" };

async function story(id, step, options = still) {
  const page = await open(browser, { fragment: `teach=${id}&step=${step}`, ...options });
  await drawn(page);
  return page;
}

async function key(page, name) {
  await page.keyboard.press(name);
  await drawn(page);
}

test("a story is chosen, led through by keys, and gives the person's case back as it was", async () => {
  const page = await open(browser, still);
  await type(page, "body.width", "17 m");
  const own = await text(page);
  await page.click("#teach-menu > summary");
  assert.deepEqual(await page.locator("#stories button").evaluateAll((all) => all.map((one) => one.dataset.story)), IDS);
  await page.click('[data-story="two-factors"]');
  await drawn(page);
  assert.equal(await place(page), "Two factors are not enough · 1 of 6");
  assert.equal(await page.isVisible("header"), false);
  assert.equal(await page.isVisible("#tab-why"), false);
  assert.equal(await page.evaluate(() => document.activeElement.id), "story-head");
  await key(page, "ArrowRight");
  await key(page, "ArrowRight");
  assert.equal(await page.textContent("#story-head"), "The overturning factor is 0.90. Yet it does not simply rock.");
  assert.equal(await mode(page), "SRO-");
  assert.match(await page.textContent("#live"), /3 of 6\. The overturning factor/);
  await key(page, "ArrowLeft");
  assert.equal(await told(page), 2);
  await page.waitForTimeout(500);
  assert.equal(await hash(page), "#teach=two-factors&step=2");
  // A step may be changed, and its changes undone, but not what was before it.
  await key(page, "ArrowRight");
  await page.focus("#point");
  for (let i = 0; i < 6; i += 1) await key(page, "ArrowUp");
  assert.equal(await mode(page), "RO", "the task of the step");
  assert.equal(await told(page), 3, "arrows on the diamond are its own");
  for (let i = 0; i < 9; i += 1) await key(page, "Control+z");
  assert.equal(await mode(page), "SRO-");
  await key(page, "Escape");
  assert.equal(await told(page), 0);
  assert.equal(await text(page), own);
  assert.equal(await page.isVisible("header"), true);
  assert.equal(await page.evaluate(() => document.activeElement.textContent), "Teach");
  await page.click("#undo");
  await drawn(page);
  assert.match(await text(page), /width = "15 m"/);
  assert.equal((await said(page)).can_undo, false, "a story leaves no texts behind");
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("the case of a step is kept as one step of undo", async () => {
  const page = await story("two-factors", 1);
  await page.click("#story-next");
  await drawn(page);
  assert.equal(await told(page), 2);
  await page.click("#story-keep");
  await drawn(page);
  assert.equal(await told(page), 0);
  assert.match(await text(page), /2400 kN\/m/);
  await page.click("#undo");
  await drawn(page);
  assert.match(await text(page), /2700 kN\/m/);
  assert.equal((await said(page)).can_undo, false);
  await page.close();
});

test("every step opens by its address, with its drawings, and nothing runs off the page", async () => {
  const page = await story("two-factors", 1);
  const sizes = [[1280, 800], [390, 844]];
  let steps = 0;
  for (const id of IDS) {
    for (let step = 1; ; step += 1) {
      await page.evaluate(([name, number]) => (location.hash = `teach=${name}&step=${number}`), [id, step]);
      await page.waitForFunction(([name, number]) => window.standfast.story?.id === name && window.standfast.story.step === Math.min(number, window.standfast.story.step), [id, step]);
      await drawn(page);
      if ((await told(page)) !== step) break;
      steps += 1;
      for (const [width, height] of sizes) {
        await page.setViewportSize({ width, height });
        await drawn(page);
        await drawn(page);
        const where = `${id} ${step} at ${width}`;
        const seen = await page.evaluate(() => ({
          wide: document.documentElement.scrollWidth - innerWidth,
          body: [...document.querySelectorAll("#section, #body, #stage")].some((one) => one.checkVisibility() && one.querySelector("svg")),
          plate: [...document.querySelectorAll("#map .picture, #story-figure")].some((one) => one.checkVisibility() && one.querySelector("svg")) || document.querySelector("#story-tab [role=tabpanel]")?.checkVisibility(),
          time: window.standfast.motion !== null,
          high: document.documentElement.scrollHeight - innerHeight,
        }));
        assert.ok(seen.wide <= 0, `${where}: ${seen.wide} px too wide`);
        assert.ok(seen.body && seen.plate, `${where}: ${JSON.stringify(seen)}`);
        // Histories with their legend and a strip below are higher than a screen of words leaves; all else is on it.
        if (width === 1280 && !seen.time) assert.ok(seen.high <= 0, `${where}: ${seen.high} px below the screen`);
      }
    }
  }
  assert.ok(steps >= 36, String(steps));
  assert.deepEqual(page.heard, []);
  await page.close();
});

test("an address that names no story says so, and one that names no step has the nearest", async () => {
  const page = await open(browser, { fragment: "teach=%3Cimg%20src=x%3E&step=2" });
  assert.match(await page.textContent("#note"), /does not have/);
  assert.equal(await told(page), 0);
  await page.close();
  for (const [step, expected] of [["99", 6], ["-3", 1], ["x", 1], ["2.5", 1]]) {
    const other = await story("ground", step);
    assert.equal(await told(other), expected, step);
    await other.close();
  }
});

test("the browser's way back leads out of a story, and a dropped case too", async () => {
  const page = await open(browser, still);
  await page.waitForTimeout(500);
  const own = await text(page);
  await page.click("#teach-menu > summary");
  await page.click('[data-story="ground"]');
  await drawn(page);
  await page.goBack();
  await drawn(page);
  assert.equal(await told(page), 0);
  assert.equal(await text(page), own);
  assert.equal((await said(page)).can_undo, false);
  await page.close();
});

test("a motion begins anew with each step, and its keys stay apart from those of the story", async () => {
  const page = await story("islands", 1, { reducedMotion: "no-preference" });
  await page.waitForFunction(() => window.standfast.time.t > 2);
  await key(page, "ArrowRight");
  assert.equal(await told(page), 2);
  assert.ok((await page.evaluate(() => window.standfast.time.t)) < 1.5);
  await page.focus("#time-bar");
  await key(page, "ArrowRight");
  assert.equal(await told(page), 2);
  await page.close();
  const quiet = await story("islands", 1);
  assert.equal(await quiet.evaluate(() => window.standfast.time.running), false);
  await quiet.close();
});

test("only the numbers of a step may be changed in it", async () => {
  const page = await story("two-factors", 1);
  const keys = await page.locator("#section input:visible, #loose input:visible").evaluateAll((all) => all.map((one) => one.dataset.key).sort());
  assert.deepEqual(keys, ["body.friction", "load[1].force"]);
  await type(page, "load[1].force", "2600");
  assert.equal(await told(page), 1);
  assert.equal(await mode(page), "SL");
  await page.close();
});

test("on paper a story is a handout, one step a page", async () => {
  const page = await story("two-factors", 3);
  const pdf = (await page.pdf({ format: "A4" })).toString("latin1");
  assert.equal(Number(/\/Type \/Pages[^>]*\/Count (\d+)/s.exec(pdf)?.[1] ?? /\/Count (\d+)/.exec(pdf)[1]), 6);
  mkdirSync(artefacts, { recursive: true });
  writeFileSync(path.join(artefacts, "teach-handout.pdf"), Buffer.from(pdf, "latin1"));
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  const articles = await page.locator("#handout article").evaluateAll((all) => all.map((one) => [one.querySelector("h2").textContent, one.querySelectorAll("svg").length]));
  assert.equal(articles.length, 6);
  assert.ok(articles.every(([head, drawings]) => head && drawings === 2), JSON.stringify(articles));
  await page.close();
});

test("a part of the page stands in a frame, from a file and from a site", async () => {
  mkdirSync(artefacts, { recursive: true });
  const page = await open(browser, { ...still, url: site });
  await page.context().grantPermissions(["clipboard-read", "clipboard-write"]);
  for (const [part, seen, unseen] of [["plane", "#map svg", "#verdict"], ["body", "#section svg", "#map"], ["verdict", "#answer", "#map"]]) {
    await page.click("#teach-menu > summary");
    await page.click(`#embed-${part}`);
    await page.waitForFunction(() => document.querySelector("#note").textContent.startsWith("Frame copied"));
    const frame = await page.evaluate(() => navigator.clipboard.readText());
    await page.evaluate(() => (document.querySelector("#note").textContent = ""));
    assert.match(frame, new RegExp(`^<iframe title="Caisson in air.*src="http.*&amp;only=${part}"`));
    const fromDisk = frame.replace(/src="[^#]*/, `src="${pathToFileURL(path.resolve(html)).href}`);
    const file = path.join(path.dirname(path.resolve(html)), `handout-${part}.html`);
    writeFileSync(file, `<!doctype html><title>handout</title><p>A handout.</p>${fromDisk}`);
    for (const handout of [pathToFileURL(file).href, "data:"]) {
      const other = await browser.newPage();
      const heard = [];
      // That the site has no other page is not of the frame.
      other.on("console", (message) => !message.text().includes("404") && heard.push(message.text()));
      if (handout === "data:") {
        // Of the same site, and another page: a page does not stand in itself.
        await other.goto(new URL("other", site).href);
        await other.setContent(`<!doctype html><title>handout</title><p>A handout.</p>${frame.replace("loading=\"lazy\"", "")}`);
      } else {
        await other.goto(handout);
      }
      const inner = other.frameLocator("iframe");
      await inner.locator(seen).first().waitFor({ state: "visible" });
      for (const hidden of ["header", "#tab-why", unseen]) assert.equal(await inner.locator(hidden).first().isVisible(), false, `${part}: ${hidden}`);
      const child = other.frames().find((one) => one !== other.mainFrame());
      const over = await child.evaluate(() => [document.documentElement.scrollWidth - innerWidth, document.documentElement.scrollHeight - innerHeight]);
      assert.ok(over[0] <= 0 && over[1] <= 0, `${part}: ${over}`);
      // As the address is, it is written when the hand rests.
      await child.waitForFunction(() => /#c=/.test(document.querySelector("#whole-page").href));
      assert.doesNotMatch(await child.evaluate(() => document.querySelector("#whole-page").href), /only=/);
      assert.deepEqual(heard, []);
      if (handout !== "data:") await other.screenshot({ path: path.join(artefacts, `embed-${part}.png`) });
      await other.close();
    }
  }
  await page.close();
});

test("the step of a story stands in a frame, whole or its plane alone, and the diamond moves", async () => {
  const page = await story("two-factors", "3&only=plane", { ...still, viewport: { width: 640, height: 460 } });
  assert.equal(await page.isVisible("#map svg"), true);
  for (const hidden of ["#story-head", "#section", "#verdict", "#story-nav"]) assert.equal(await page.isVisible(hidden), false, hidden);
  await page.focus("#point");
  for (let i = 0; i < 6; i += 1) await key(page, "ArrowUp");
  assert.equal(await mode(page), "RO");
  await page.close();
});

test("stories at three widths, light and dark", async () => {
  mkdirSync(artefacts, { recursive: true });
  for (const [id, step] of [["two-factors", 3], ["k-mu", 4], ["islands", 5], ["ground", 2], ["sure", 2]]) {
    for (const [width, height, scheme] of [[390, 844, "light"], [1280, 800, "light"], [1280, 800, "dark"], [1920, 1080, "light"]]) {
      const page = await story(id, step, { ...still, viewport: { width, height }, colorScheme: scheme });
      if (id === "islands") await page.waitForSelector("#strengths:not([hidden]) svg", { timeout: 30_000 });
      await drawn(page);
      await page.screenshot({ path: path.join(artefacts, `teach-${id}-${width}${scheme === "dark" ? "-dark" : ""}.png`) });
      await page.close();
    }
  }
});

test("axe finds nothing in a story, in both themes", async () => {
  for (const colorScheme of ["light", "dark"]) {
    for (const [id, step] of [["two-factors", 3], ["blow", 2], ["k-mu", 2]]) {
      const page = await story(id, step, { ...still, colorScheme, bypassCSP: true });
      assert.deepEqual(await faults(page), [], `${id} ${step} ${colorScheme}`);
      await page.close();
    }
  }
});

test("how likely it is stands in place of the plane, as the program says it, and is put back", async () => {
  const page = await story("sure", 2);
  await page.waitForFunction(() => document.querySelector("#story-tab #chances td.number-cell"), null, { timeout: 60_000 });
  assert.equal(await page.isVisible("#map"), false);
  assert.equal(await page.isVisible("#figures-part"), false);
  assert.match(await page.textContent("#chances"), /0\.9218/);
  await page.screenshot({ path: path.join(artefacts, "teach-likely-1280.png") });
  await page.setViewportSize({ width: 390, height: 844 });
  await drawn(page);
  await page.screenshot({ path: path.join(artefacts, "teach-likely-390.png"), fullPage: true });
  await key(page, "Escape");
  assert.equal(await page.locator("#story-tab > *").count(), 0);
  assert.equal(await page.getAttribute("#tab-why", "aria-selected"), "true");
  assert.equal(await page.isVisible("#panel-likely"), false);
  await page.close();
});

test("every number that a step leaves to the hand has a field on it", async () => {
  const stories = path.join(import.meta.dirname, "../stories");
  let count = 0;
  const page = await story(IDS[0], 1);
  for (const id of IDS) {
    const { steps } = JSON.parse(readFileSync(path.join(stories, `${id}.json`), "utf8"));
    for (const [i, { hold, body }] of steps.entries()) {
      if (!hold?.length || !body) continue;
      await page.evaluate(([name, step]) => (window.standfast.tell(name, step), window.standfast.changed()), [id, i + 1]);
      await drawn(page);
      for (const key of hold) {
        assert.ok(await page.locator(`input[data-key="${key}"]`).first().isVisible(), `${id}, ${i + 1}: ${key}`);
        count += 1;
      }
    }
  }
  await page.close();
  assert.ok(count > 10, `${count}`);
});
