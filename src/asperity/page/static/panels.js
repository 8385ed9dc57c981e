// Panels that fold: what is in a closed one is made when it is opened; tables that are too wide for their place are stacked.

const narrow = matchMedia("(max-width: 760px)");
const waiting = new Map(); // panel → what its content is made by

/** Whether the screen has room for one column alone. */
export const isNarrow = () => narrow.matches;

/** Fill a place of the page; in a closed panel once it is opened. */
export function fill(place, make) {
  const panel = place.closest("details");
  if (panel && !panel.open) {
    if (!waiting.has(panel)) waiting.set(panel, new Map());
    waiting.get(panel).set(place, make);
    return;
  }
  waiting.get(panel)?.delete(place);
  place.replaceChildren(...make());
}

/** Tables that do not fit are stacked, a row below the other; all others stand as tables. */
export function fitTables(root = document.getElementById("results")) {
  const places = [...root.querySelectorAll(".scroll")];
  for (const place of places) place.classList.remove("stacked");
  const wide = places.filter((place) => place.scrollWidth > place.clientWidth + 1);
  for (const place of wide) place.classList.add("stacked");
}

/** Fold what is secondary on a narrow screen, and follow what the user opens. */
export function connectPanels() {
  if (isNarrow()) for (const panel of document.querySelectorAll("details[data-narrow]")) panel.open = false;
  const tools = document.getElementById("tools");
  const fold = () => {
    tools.open = !narrow.matches;
  };
  narrow.addEventListener("change", fold);
  fold();
  document.getElementById("answer").addEventListener("toggle", (event) => {
    const panel = event.target;
    if (!panel.open) return;
    const made = waiting.get(panel);
    waiting.delete(panel);
    for (const [place, make] of made ?? []) place.replaceChildren(...make());
    fitTables(panel);
  }, true);
  let width = 0;
  new ResizeObserver(([{ contentRect }]) => {
    if (contentRect.width === width) return;
    width = contentRect.width;
    fitTables();
  }).observe(document.getElementById("results"));
}
