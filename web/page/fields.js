// Number fields, sliders and units. A field is taken when it is left or at Enter, not at each key; Escape gives back what
// holds. A text that is not taken stays, with its message, until another is typed or the number changes elsewhere.

export function connectFields(app) {
  const fields = [...document.querySelectorAll("[data-field]")].map((input) => ({ input, ...message(input), state: SHOWN }));
  const named = new Map(fields.map((field) => [field.input.id, field]));
  const sliders = [...document.querySelectorAll("[data-slider]")];
  const units = [...document.querySelectorAll("[data-unit]")];
  const direction = document.getElementById("direction");

  const accept = (field) => {
    field.state = SHOWN;
    field.fault.replaceChildren();
    field.holds.textContent = "";
    field.input.removeAttribute("aria-invalid");
  };
  const take = (field) => {
    const fault = app.explorer.set(field.input.id, field.input.value);
    if (fault) {
      field.state = REFUSED;
      // A new node, so that the same words are announced again.
      field.fault.replaceChildren(fault);
      field.input.setAttribute("aria-invalid", "true");
    } else {
      accept(field);
    }
    app.changed();
  };
  for (const field of fields) {
    field.input.addEventListener("input", () => (field.state = TYPING));
    field.input.addEventListener("blur", () => field.state === TYPING && take(field));
    field.input.addEventListener("keydown", (event) => {
      if (event.isComposing) return;
      if (event.key === "Enter" && field.state !== SHOWN) take(field);
      if (event.key === "Escape") {
        accept(field);
        app.changed();
      }
    });
  }
  for (const slider of sliders) {
    slider.addEventListener("input", () => {
      app.explorer.slide(slider.dataset.slider, slider.valueAsNumber);
      accept(named.get(slider.dataset.slider));
      app.changed();
    });
  }
  for (const unit of units) {
    unit.addEventListener("change", () => {
      app.explorer.set_unit(unit.dataset.unit, unit.value);
      app.changed();
    });
  }
  direction.addEventListener("change", () => {
    app.explorer.set_mirrored(direction.value === "right");
    app.changed();
  });

  let explorer = app.explorer;
  return (reading) => {
    // Another link is another page.
    if (explorer !== app.explorer) fields.forEach(accept);
    explorer = app.explorer;
    const texts = new Map(reading.fields);
    const unit = new Map(reading.units.map(([kind, , chosen]) => [kind, chosen]));
    for (const field of fields) {
      const { id } = field.input;
      const text = texts.get(id);
      // What is being typed is not to be rewritten.
      if (field.state === SHOWN && field.input.value !== text) field.input.value = text;
      const holds = field.state === REFUSED ? ` Until then ${text} ${unit.get(field.kind) ?? ""}`.trimEnd() + " holds." : "";
      if (field.holds.textContent !== holds) field.holds.textContent = holds;
    }
    const places = new Map(reading.sliders);
    for (const slider of sliders) {
      const share = places.get(slider.dataset.slider);
      if (slider !== document.activeElement || Math.abs(slider.valueAsNumber - share) > 0.01) slider.value = share;
      slider.setAttribute("aria-valuetext", texts.get(slider.dataset.slider));
    }
    for (const [kind, names, chosen] of reading.units) {
      for (const select of units.filter((one) => one.dataset.unit === kind)) {
        if (select.options.length === 0) select.replaceChildren(...names.map((name) => new Option(name)));
        select.value = chosen;
      }
      for (const label of document.querySelectorAll(`[data-of="${kind}"]`)) label.textContent = chosen;
    }
    direction.value = reading.mirrored ? "right" : "left";
  };
}

/** What stands in a field: what holds, what is being typed, or what was not taken. */
const [SHOWN, TYPING, REFUSED] = ["shown", "typing", "refused"];

/** The places of a field's message, announced, and of the number that holds beside it; and its kind of unit. */
function message(input) {
  let place = input.nextElementSibling;
  let kind;
  while (!place.classList.contains("error")) {
    kind ??= place.dataset.unit ?? place.dataset.of;
    place = place.nextElementSibling;
  }
  const [fault, holds] = [document.createElement("span"), document.createElement("span")];
  fault.setAttribute("role", "alert");
  place.replaceChildren(fault, holds);
  place.id = `${input.id}-error`;
  input.setAttribute("aria-describedby", place.id);
  return { fault, holds, kind };
}
