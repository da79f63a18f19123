// Files: opened, dropped, saved.

import { byId, say, stem, today } from "dom";

/** As many letters as a case file or a record may have. */
const MOST = { case: 1_000_000, record: 40_000_000 };

export function connectFiles(app) {
  // A record that the case does not name may shake its body.
  let offered = "";
  const offer = (name, words = "") => {
    offered = name;
    byId("offer").hidden = !name;
    byId("offer-words").textContent = `${name} is a record, or may be one.`;
    byId("offer-fault").replaceChildren(words);
  };
  byId("shake").addEventListener("click", () => {
    const words = app.explorer.shake_with(offered);
    offer(words ? offered : "", words ?? "");
    if (!words) app.plate = "";
    app.changed();
  });
  byId("no-shake").addEventListener("click", () => offer(""));
  const take = async (files) => {
    const all = [...files];
    const isCase = (file) => /\.toml$/i.test(file.name);
    app.leaveStory();
    // Records first, so that a case finds them.
    for (const file of [...all.filter((one) => !isCase(one)), ...all.filter(isCase)]) {
      if (file.size > (isCase(file) ? MOST.case : MOST.record)) {
        say(`${file.name} is too large.`);
        continue;
      }
      const text = await file.text();
      if (isCase(file)) {
        app.plate = "";
        offer("");
        app.explorer.open(file.name, text);
      } else {
        app.explorer.add_file(file.name, text);
        say(`${file.name} is here for the cases that name it.`);
        offer(app.explorer.can_shake_with(file.name) ? file.name : "");
      }
    }
    app.changed();
  };
  byId("file").addEventListener("change", async () => {
    await take(byId("file").files);
    byId("file").value = "";
  });
  let over = 0;
  const hasFiles = (event) => [...(event.dataTransfer?.types ?? [])].includes("Files");
  addEventListener("dragenter", (event) => {
    if (!hasFiles(event)) return;
    over += 1;
    byId("drop").hidden = false;
  });
  addEventListener("dragleave", (event) => {
    if (!hasFiles(event)) return;
    over -= 1;
    byId("drop").hidden = over <= 0;
  });
  addEventListener("dragover", (event) => hasFiles(event) && event.preventDefault());
  addEventListener("drop", (event) => {
    if (!hasFiles(event)) return;
    event.preventDefault();
    over = 0;
    byId("drop").hidden = true;
    take(event.dataTransfer.files);
  });

  const save = (content, name, kind) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type: kind }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    say(`${name} saved.`);
  };
  const named = (what) => `${stem(app.explorer.name())}${what}`;
  const paper = () => {
    const { width, height } = app.plateSize();
    return app.explorer.plane_on_paper(app.shownPlate, Math.round(width), Math.round(height));
  };
  const on = (id, action) => byId(id).addEventListener("click", action);
  on("save-toml", () => {
    app.settleText();
    save(app.explorer.text(), named(".toml"), "application/toml");
  });
  for (const [id, what] of [["save-sheet", "sheet"], ["save-short", "short-sheet"]]) {
    on(id, async () => {
      const name = named(`-${what}.html`);
      say(`${name} is being made.`);
      try {
        const { html, fault } = await app.askOnce(`${what} ${today()}`);
        if (html) save(html, name, "text/html;charset=utf-8");
        else say(`There is no sheet: ${fault}`);
      } catch (error) {
        say(`There is no sheet: ${error.message}`);
      }
    });
  }
  on("save-text", () => save(app.explorer.report(), named(".txt"), "text/plain;charset=utf-8"));
  on("save-json", () => save(app.explorer.json(), named(".json"), "application/json"));
  on("save-body", () => save(app.explorer.section_on_paper(), named("-section.svg"), "image/svg+xml"));
  on("save-plate", () => save(paper(), named(`-${app.shownPlate}.svg`), "image/svg+xml"));
  // With the mark by which spreadsheets know the letters.
  on("save-csv", () => save(`\uFEFF${app.explorer.curves_csv()}`, named("-k-mu.csv"), "text/csv;charset=utf-8"));
  on("save-png", async () => {
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(paper())}`;
    await image.decode();
    // Wide enough for a column of print.
    const scale = Math.max(3, 1800 / image.naturalWidth);
    const canvas = Object.assign(document.createElement("canvas"), { width: image.naturalWidth * scale, height: image.naturalHeight * scale });
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob((blob) => save(blob, named(`-${app.shownPlate}.png`)), "image/png");
  });
  return (said) => {
    for (const id of ["save-plate", "save-png"]) byId(id).disabled = said.plates.length === 0;
    // A sheet is of the text that stands.
    for (const id of ["save-sheet", "save-short"]) byId(id).disabled = said.fault !== null;
    byId("save-csv").disabled = said.point === null;
    byId("save-body").disabled = said.plates.length === 1 && said.plates[0] === "time";
  };
}
