// Numbers for people: significant digits, units, and small helpers for elements.

const ARCMIN = 10800 / Math.PI;

/** A number with a few significant digits, as the commands write it: none before the decimal point is rounded; a dash where there is none. */
export function number(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 999999.5 || size < 1e-3) {
    const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
    return `${Number(mantissa)}e${Number(exponent)}`;
  }
  return String(Number(value.toFixed(Math.max(digits - 1 - Math.floor(Math.log10(size)), 0))));
}

export const arcmin = (radians) => (radians === null ? null : radians * ARCMIN);
export const scaled = (value, factor) => (value === null || value === undefined ? null : value * factor);

/** The unit of a joint file as people write it. */
export function unitText(unit) {
  return unit === "1" ? "" : unit.replaceAll("*", "·").replaceAll("^2", "²").replaceAll("^3", "³");
}

/** An element with attributes and children; text is never read as markup. */
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === false || value === null || value === undefined) continue;
    made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}

/** A link that saves a text as a JSON file. */
export function jsonLink(label, name, text) {
  const href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  return element("a", { class: "button", download: `${name}.json`, href }, label);
}

/** Save a text as a file. */
export function saveText(name, text, type) {
  const link = element("a", { download: name, href: URL.createObjectURL(new Blob([text], { type })) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

/** An element of SVG. */
export function svg(name, attributes = {}, ...children) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

/** A table from headings and rows; the first cell of a row is its heading; `words` are the columns of words beside it. */
export function table(caption, headings, rows, words = new Set()) {
  const labels = headings.map((text) => (typeof text === "string" ? text : text?.dataset.label ?? ""));
  const aligned = (place) => ({ class: words.has(place) ? "w" : null, "data-label": labels[place] });
  return element(
    "table",
    {},
    element("caption", { class: "visually-hidden" }, caption),
    element("thead", {}, element("tr", {}, ...headings.map((text, place) => element("th", { scope: "col", ...aligned(place) }, text)))),
    element(
      "tbody",
      {},
      ...rows.map(([head, ...cells]) =>
        element("tr", {}, element("th", { scope: "row" }, head), ...cells.map((cell, place) => element("td", aligned(place + 1), cell))),
      ),
    ),
  );
}
