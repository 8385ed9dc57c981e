// Blocks of a view as elements: the same words, tables and numbers that terminal and report show.

import { element, number, table } from "/numbers.js";

const VERDICTS = { pass: ["pass", "✓ pass"], FAIL: ["fail", "✗ fail"], unknown: ["state", "? unknown"] };

/** Text for screen readers alone. */
const hidden = (text) => element("span", { class: "visually-hidden" }, text);

/** A text whose lines stand below each other. */
const lines = (text) => element("span", {}, ...text.split("\n").flatMap((line, at) => (at ? [element("br"), line] : [line])));

/** A share of a whole or of a limit as a bar; where some are negative, to the left for less. */
function bar(share, kind, signed) {
  if (share === null) return "";
  const size = Math.min(Math.abs(share), 1) * 100;
  const fill = element("span", { class: `fill ${signed ? (share < 0 ? "less" : "more") : kind}` });
  fill.style.width = `${signed ? size / 2 : size}%`;
  if (signed) fill.style.marginLeft = share < 0 ? `${50 - size / 2}%` : "50%";
  return element("span", { class: "bar-track", "aria-hidden": "true" }, fill);
}

/** What a crossed or kept limit is said to be. */
function verdict(cell) {
  const [kind, text] = VERDICTS[cell] ?? ["state", cell];
  return element("span", { class: kind }, text);
}

function tableBlock({ title, head, rows, words, verdicts, shares }, before, panel) {
  const bars = shares.length > 0;
  const signed = shares.some((share) => share < 0);
  const compared = before?.rows.length === rows.length ? before : null; // the same table of the baseline
  const was = compared ? lines(`baseline\n${head[1].split("\n")[1] ?? ""}`) : null;
  was?.classList.add("baseline");
  const beside = (cells, cell) => (compared ? [...cells.slice(0, 2), cell, ...cells.slice(2)] : cells); // the number that it compares
  const headings = [...beside(head.map(lines), was), ...(bars ? [hidden("bar")] : [])];
  const cells = rows.map((row, at) => {
    const last = row.length - 1;
    const shown = row.map((cell, place) => (verdicts && place === last ? verdict(cell) : cell));
    return [...beside(shown, compared?.rows[at][1]), ...(bars ? [bar(shares[at], row[last] === "FAIL" ? "bad" : verdicts ? "good" : "", signed)] : [])];
  });
  const made = table(title, headings, cells, new Set(words));
  return [...(title === panel ? [] : [element("h3", {}, title)]), element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": `${title || "Table"}, scrollable` }, made)];
}

function change(now, before) {
  if (!before || before.si === null || now.si === null || before.si === 0) return "";
  const share = 100 * (now.si / before.si - 1);
  const text = Math.abs(share) < 0.005 ? "as the baseline" : `${share > 0 ? "+" : "−"}${number(Math.abs(share), 3)} % against the baseline`;
  return element("p", { class: "change" }, text);
}

function card(figure, before) {
  return element(
    "div",
    { class: "card" },
    element("h2", {}, figure.name),
    element("p", { class: "value" }, element("span", { "data-value": figure.name }, figure.shown), " ", element("span", { class: "unit" }, figure.si === null ? "" : figure.unit)),
    element("p", { class: "detail" }, figure.detail),
    change(figure, before),
  );
}

function warned({ severity, about, text, meanings, remedy }) {
  return element(
    "li",
    { class: severity },
    element("strong", {}, `${about}: `),
    `${meanings.join("; ")} `,
    element("span", { class: "how-much" }, `(${text})`),
    remedy ? element("p", { class: "remedy" }, `What to do: ${remedy}.`) : "",
  );
}

const KINDS = {
  heading: ({ text }) => [element("h3", {}, text)],
  paragraph: ({ text, strong, passed }) => [element("p", { class: `note${strong ? " strong" : ""}${passed === false ? " fail" : passed ? " pass" : ""}` }, text)],
  bullets: ({ items }) => [element("ul", {}, ...items.map((item) => element("li", {}, item)))],
  figures: ({ items }, before) => items.map((item, at) => card(item, before?.items[at])),
  table: tableBlock,
  warnings: ({ items }) => [element("ul", { class: "warnings" }, ...items.map(warned))],
  listing: ({ text }) => [element("pre", {}, text)],
};

/** Elements of blocks below the heading of a panel; `before` are the blocks of the baseline, whose numbers stand beside those of figures and of the first table. */
export function elements(blocks, before = [], panel = "") {
  const first = (kind, list) => list.find((block) => block.kind === kind);
  return blocks.flatMap((block) => {
    const beside = block === first(block.kind, blocks) ? first(block.kind, before) : undefined;
    return KINDS[block.kind](block, beside, panel);
  });
}
