// Links and files.

export function connectShare(app) {
  const note = document.getElementById("note");
  let timer = 0;
  const say = (text) => {
    note.textContent = text;
    clearTimeout(timer);
    timer = setTimeout(() => (note.textContent = ""), 8000);
  };
  const save = (content, name, kind) => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type: kind }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
    say(`${name} saved.`);
  };
  const name = (extension) => {
    const { figure, numbers } = app.reading;
    const [gamma, kPrime] = numbers.diagram;
    return figure ? `standfast-fig-${figure}.${extension}` : `standfast-gamma-${gamma}-k-prime-${kPrime}.${extension}`;
  };
  const paper = () => {
    const { width, height } = app.mapSize();
    return app.explorer.map_on_paper(Math.round(width), Math.round(height));
  };
  const on = (id, action) => document.getElementById(id).addEventListener("click", action);

  on("copy", async () => {
    const link = location.href.split("#")[0] + "#" + app.explorer.fragment();
    history.replaceState(null, "", `#${app.explorer.fragment()}`);
    try {
      await navigator.clipboard.writeText(link);
      say("Link copied; it holds everything shown.");
    } catch {
      say(link);
    }
  });
  on("save-svg", () => save(paper(), name("svg"), "image/svg+xml"));
  on("save-csv", () => save(app.explorer.curves_csv(), name("csv"), "text/csv"));
  on("save-png", async () => {
    const scale = 3;
    const image = new Image();
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(paper())}`;
    await image.decode();
    const canvas = Object.assign(document.createElement("canvas"), {
      width: image.naturalWidth * scale,
      height: image.naturalHeight * scale,
    });
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob((blob) => save(blob, name("png")), "image/png");
  });

  let write = 0;
  return (reading) => {
    for (const id of ["save-svg", "save-png", "save-csv"]) document.getElementById(id).disabled = !reading.is_drawn;
    // Browsers limit how often an address may change.
    clearTimeout(write);
    write = setTimeout(() => history.replaceState(null, "", `#${app.explorer.fragment()}`), 350);
  };
}
