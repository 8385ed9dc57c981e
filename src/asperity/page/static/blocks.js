// Blocks of a view as elements: the same words, tables and numbers that terminal and report show.

import { SAME, change } from "/headline.js";
import { element, table } from "/numbers.js";

const VERDICTS = { pass: ["pass", "✓ pass"], FAIL: ["fail", "✗ fail"], unknown: ["state", "? unknown"], "out of range": ["outside", "out of range"] };
const FILLS = { FAIL: "bad", "out of range": "outside" };

/** Text for screen readers alone. */
const hidden = (text) => element("span", { class: "visually-hidden" }, text);

/** A text whose lines stand below each other. */
const lines = (text) => element("span", { "data-label": text.replace(/\n-$/, "").replaceAll("\n", ", ") }, ...text.split("\n").flatMap((line, at) => (at ? [element("br"), line] : [line])));

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
  const was = compared ? lines(`baseline\n${head[1].split("\n")[1] ?? ""}`.trim()) : null;
  was?.classList.add("baseline");
  const beside = (cells, cell) => (compared ? [...cells.slice(0, 2), cell, ...cells.slice(2)] : cells); // the number that it compares
  const headings = [...beside(head.map(lines), was), ...(bars ? [hidden("bar")] : [])];
  const cells = rows.map((row, at) => {
    const last = row.length - 1;
    const shown = row.map((cell, place) => (verdicts && place === last ? verdict(cell) : cell));
    return [...beside(shown, compared?.rows[at][1]), ...(bars ? [bar(shares[at], FILLS[row[last]] ?? (verdicts ? "good" : ""), signed)] : [])];
  });
  const made = table(title, headings, cells, new Set(words));
  return [...(title === panel ? [] : [element("h3", {}, title)]), scrolled(title || "Table", made)];
}

/** The place of a table: where it is too narrow for it, the cells of a row stand below each other, each with its heading. */
function scrolled(title, made) {
  return element("div", { class: "scroll", "data-table": title }, made);
}

/** The figures as rows: each with its unit, its baseline and change where there is one, and what it is. */
export function keyFigures({ items }, before) {
  const beside = before?.items.length === items.length;
  const rows = items.map((item, at) => {
    const value = [item.shown, item.si === null || !item.unit ? "" : ` ${item.unit}`];
    const changed = beside ? change(item, before.items[at]) : null;
    if (changed && changed.text !== SAME) value.push(element("span", { class: "was" }, `baseline ${before.items[at].shown} `, element("span", { class: `change ${changed.kind}` }, changed.text)));
    return [item.name, element("span", {}, ...value), item.detail];
  });
  return [scrolled("Key figures", table("Key figures", ["quantity", "value", "details"], rows, new Set([0, 2])))];
}

/** A table of names and values as a list of pairs, in as many columns as there is room for. */
export function pairs({ rows }) {
  return [element("dl", { class: "pairs" }, ...rows.map(([name, value]) => element("div", {}, element("dt", {}, name), element("dd", {}, value))))];
}

/** The margins, and below them how to read them. */
export function marginsTable(blocks) {
  const [margins] = blocks.filter((block) => block.kind === "table");
  const made = tableBlock(margins, undefined, margins.title);
  made[0].classList.add("margins");
  return [...made, folded("How to read this table", elements(blocks.filter((block) => block !== margins)))];
}

/** Explanations that fold. */
function folded(title, parts) {
  return parts.length ? element("details", { class: "more" }, element("summary", {}, title), ...parts) : "";
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
  figures: (block) => keyFigures(block),
  table: tableBlock,
  warnings: ({ items }) => [element("ul", { class: "warnings" }, ...items.map(warned))],
  picture: ({ title, svg }) => [element("img", { alt: title, width: "100%", src: `data:image/svg+xml,${encodeURIComponent(svg)}` })],
  listing: ({ text }) => [element("pre", {}, text)],
};

/**
 * Elements of blocks below the heading of a panel; `before` are the blocks of the baseline, whose numbers stand beside
 * those of the first table; `fold`: whether the sentences fold, below everything else.
 */
export function elements(blocks, { before = [], panel = "", fold = false } = {}) {
  const first = (list) => list.find((block) => block.kind === "table");
  const made = (block) => KINDS[block.kind](block, block === first(blocks) ? first(before) : undefined, panel);
  const sentences = fold ? blocks.filter((block) => block.kind === "paragraph") : [];
  const results = blocks.filter((block) => !sentences.includes(block)).flatMap(made);
  if (!results.length) return sentences.flatMap(made);
  return fold ? [...results, folded("What these numbers mean", sentences.flatMap(made))] : results;
}
