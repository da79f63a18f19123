// Light, dark, or as the system; kept in the browser if it allows that.

const dark = matchMedia("(prefers-color-scheme: dark)");

function kept() {
  try {
    return localStorage.getItem("standfast-theme") ?? "auto";
  } catch {
    return "auto";
  }
}

export function connectTheme() {
  const select = document.getElementById("theme");
  select.value = kept();
  const apply = () => {
    const theme = select.value === "auto" ? (dark.matches ? "dark" : "light") : select.value;
    document.documentElement.dataset.theme = theme;
  };
  select.addEventListener("change", () => {
    try {
      localStorage.setItem("standfast-theme", select.value);
    } catch {
      // Then it lasts as long as the page.
    }
    apply();
  });
  dark.addEventListener("change", apply);
  // Paper is light.
  addEventListener("beforeprint", () => (document.documentElement.dataset.theme = "light"));
  addEventListener("afterprint", apply);
  apply();
}
