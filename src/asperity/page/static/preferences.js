// What the user chose for this browser: theme, and forces in the drawing. Private windows may have no storage.

const get = (id) => document.getElementById(id);

function keep(name, value) {
  try {
    localStorage.setItem(name, value);
  } catch {
    // the choice holds until the page is closed
  }
}

function kept(name) {
  try {
    return localStorage.getItem(name);
  } catch {
    return null;
  }
}

/** Choose as the last time, and follow what is chosen. */
export function connectPreferences() {
  const theme = get("theme");
  const forces = get("show-forces");
  const show = () => {
    document.documentElement.dataset.theme = theme.value;
    get("drive").classList.toggle("plain", !forces.checked);
  };
  theme.value = kept("theme") || theme.value;
  forces.checked = kept("forces") !== "off";
  theme.addEventListener("change", () => keep("theme", theme.value));
  forces.addEventListener("change", () => keep("forces", forces.checked ? "on" : "off"));
  for (const each of [theme, forces]) each.addEventListener("change", show);
  show();
}
