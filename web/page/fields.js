// Number fields, sliders and units.

export function connectFields(app) {
  const fields = [...document.querySelectorAll("[data-field]")];
  const sliders = [...document.querySelectorAll("[data-slider]")];
  const units = [...document.querySelectorAll("[data-unit]")];
  const direction = document.getElementById("direction");
  const message = (field) => {
    let next = field.nextElementSibling;
    while (!next.classList.contains("error")) next = next.nextElementSibling;
    return next;
  };
  const fault = (field, text) => {
    message(field).textContent = text ?? "";
    if (text) field.setAttribute("aria-invalid", "true");
    else field.removeAttribute("aria-invalid");
  };
  for (const field of fields) {
    message(field).id = `${field.id}-error`;
    field.setAttribute("aria-describedby", `${field.id}-error`);
    field.addEventListener("input", () => {
      fault(field, app.explorer.set(field.id, field.value));
      app.changed();
    });
    // A field left alone shows what holds.
    field.addEventListener("blur", () => {
      fault(field, null);
      app.changed();
    });
  }
  for (const slider of sliders) {
    slider.addEventListener("input", () => {
      app.explorer.slide(slider.dataset.slider, slider.valueAsNumber);
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

  return (reading) => {
    const texts = new Map(reading.fields);
    for (const field of fields) {
      // What is being typed is not to be rewritten.
      if (field !== document.activeElement && field.value !== texts.get(field.id)) field.value = texts.get(field.id);
    }
    const places = new Map(reading.sliders);
    for (const slider of sliders) {
      const share = places.get(slider.dataset.slider);
      if (slider !== document.activeElement || Math.abs(slider.valueAsNumber - share) > 0.01) slider.value = share;
      slider.setAttribute("aria-valuetext", texts.get(slider.dataset.slider));
    }
    for (const [kind, names, chosen] of reading.units) {
      for (const select of units.filter((unit) => unit.dataset.unit === kind)) {
        if (select.options.length === 0) select.replaceChildren(...names.map((name) => new Option(name)));
        select.value = chosen;
      }
      for (const label of document.querySelectorAll(`[data-of="${kind}"]`)) label.textContent = chosen;
    }
    direction.value = reading.mirrored ? "right" : "left";
  };
}
