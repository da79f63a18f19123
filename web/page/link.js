// The address: `#c=` the text of the case, deflated, in letters of base64 for addresses; `&n=` its name; `&a=` and `&an=` those of A, if a case is
// pinned; `&v=` plate, tab and moment. Or `#teach=` a
// story, `&step=` its step. `&only=` shows one part alone.

import { byId, copy, say } from "dom";
import { PARTS } from "embed";

/** As many letters as a text from an address may have. */
const MOST = 400_000;

async function piped(bytes, stream, most = Infinity) {
  const reader = new Blob([bytes]).stream().pipeThrough(stream).getReader();
  const parts = [];
  let size = 0;
  for (;;) {
    const { done, value } = await reader.read();
    if (done) break;
    size += value.length;
    if (size > most) throw new Error("too long");
    parts.push(value);
  }
  return new Uint8Array(await new Blob(parts).arrayBuffer());
}

async function packed(text) {
  const bytes = await piped(new TextEncoder().encode(text), new CompressionStream("deflate-raw"));
  let letters = "";
  for (const byte of bytes) letters += String.fromCharCode(byte);
  return btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

async function unpacked(letters) {
  const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
  return new TextDecoder("utf-8", { fatal: true }).decode(await piped(bytes, new DecompressionStream("deflate-raw"), MOST));
}

/** The name of a file from an address. */
const fileName = (name) => (name ?? "").replace(/[^\p{L}\p{N}._ -]+/gu, "").slice(0, 80) || "link.toml";

export async function connectLink(app) {
  let written = "";
  /** Pins the case that the address names as A; where it names none, one that is pinned stays. */
  const readPinned = async (parts) => {
    if (!parts.has("a")) return;
    const text = await unpacked(parts.get("a")).catch(() => "");
    if (!app.explorer.pin_text(fileName(parts.get("an")), text)) say("The address names a second case that has no answer here.");
  };
  const read = async () => {
    // Who puts the copied text behind the # of an address has two of them.
    const fragment = location.hash.replace(/^#+/, "");
    if (fragment && fragment === written && fragment.startsWith("teach=") === Boolean(app.story)) return;
    const parts = new URLSearchParams(fragment);
    app.only = PARTS.includes(parts.get("only")) ? parts.get("only") : "";
    if (app.only) document.documentElement.dataset.only = app.only;
    else delete document.documentElement.dataset.only;
    if (parts.has("teach")) {
      if (!app.tell(parts.get("teach"), Number(parts.get("step") ?? 1))) say("The address names a story that this page does not have.");
      return;
    }
    app.leaveStory();
    if (!fragment) return;
    if (parts.has("c")) {
      try {
        const text = await unpacked(parts.get("c"));
        const [plate, tab, t] = (parts.get("v") ?? "").split(",");
        app.startAt = /^\d+(\.\d+)?$/.test(t) ? Number(t) : undefined;
        app.plate = ["load", "k-mu", "directions", "time"].includes(plate) ? plate : "";
        app.explorer.open(fileName(parts.get("n")), text);
        await readPinned(parts);
        app.showTab(tab);
      } catch {
        say("The address does not hold a case: it may have been cut.");
      }
    } else if (app.explorer.open_old_link(fragment)) {
      app.plate = "k-mu";
    } else if (!app.only) {
      say("The address holds nothing that this page knows.");
    }
  };
  await read();
  addEventListener("hashchange", async () => {
    await read();
    app.changed();
  });
  app.fragment = async (only = app.only) => {
    const part = only ? `&only=${only}` : "";
    if (app.story) return `teach=${app.story.id}&step=${app.story.step}${part}`;
    const name = app.explorer.name();
    const t = app.motion && app.time.t > 0 ? [app.time.t.toFixed(3)] : [];
    const view = [app.shownPlate, app.tab, ...t].join(",");
    const [pinnedName, pinnedText] = app.explorer.pinned();
    const pinned = pinnedText === undefined ? "" : `&a=${await packed(pinnedText)}&an=${encodeURIComponent(pinnedName)}`;
    return `c=${await packed(app.explorer.text())}&n=${encodeURIComponent(name)}${pinned}&v=${view}${part}`;
  };
  byId("link").addEventListener("click", async () => {
    app.settleText();
    written = await app.fragment();
    history.replaceState(null, "", `#${written}`);
    const isOnDisk = location.protocol === "file:";
    const link = isOnDisk ? `#${written}` : location.href.split("#")[0] + `#${written}`;
    const words = isOnDisk
      ? "Copied the end of the address, from its # on: put it behind the address of any copy of this page."
      : "Link copied; it holds the text of the case and the view.";
    const files = app.said.tables.length > 0 && /\bfile\s*=/.test(app.explorer.text()) ? " A record that the case names is not in it." : "";
    await copy(link, words + files);
  });
  let timer = 0;
  return () => {
    if (app.held) return;
    // Browsers limit how often an address may change.
    clearTimeout(timer);
    timer = setTimeout(async () => {
      written = await app.fragment();
      if (app.only) byId("whole-page").href = `#${await app.fragment("")}`;
      if (!app.held) history.replaceState(null, "", `#${written}`);
    }, 350);
  };
}
