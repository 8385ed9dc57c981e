// What is always in view: the verdict in its colour, and the key figures with what changed against the baseline.

import { element, number } from "/numbers.js";

/** Figures of one cell; each other figure has a cell of its own. */
const TOGETHER = ["Mass", "Diameter"];
/** Names of figures of which less is better. */
const LESS_IS_BETTER = /drift|mass|diameter/i;
const UNSEEN = 5e-5; // relative change that four digits do not show
/** What is said of a figure that is that of its baseline. */
export const SAME = "±0";

const get = (id) => document.getElementById(id);

/** What a figure has become beside its baseline: in words, and whether that is better, worse or the same. */
export function change(now, before) {
  if (!before) return null;
  const was = `${before.shown}${before.si === null ? "" : ` ${before.unit}`}`;
  if (before.si === null || now.si === null || before.si === 0 || before.unit !== now.unit) {
    return before.shown === now.shown && before.unit === now.unit ? { text: SAME, kind: "same" } : { text: `was ${was}`, kind: "same" };
  }
  const share = now.si / before.si - 1;
  if (Math.abs(share) < UNSEEN) return { text: SAME, kind: "same" };
  const grown = Math.abs(now.si) > Math.abs(before.si);
  const text = `${share > 0 ? "+" : "−"}${number(100 * Math.abs(share), 3)} %`;
  return { text, kind: grown === LESS_IS_BETTER.test(now.name) ? "worse" : "better" };
}

function changeOf(item, before) {
  const changed = change(item, before);
  return changed ? element("span", { class: `change ${changed.kind}`, "data-change": item.name, title: "against the baseline" }, changed.text, element("span", { class: "visually-hidden" }, " against the baseline")) : "";
}

function figure(item, ...more) {
  return element(
    "dd",
    { class: "figure" },
    element("span", { class: "value", "data-value": item.name }, item.shown),
    " ",
    element("span", { class: "unit" }, item.si === null ? "" : item.unit),
    ...more,
  );
}

/** The cells of figures, each with what changed against the baseline and a few words; `before` are its figures. */
function cells(items, before) {
  const beside = (item) => changeOf(item, before?.find((each) => each.name === item.name));
  const single = items.filter((item) => !TOGETHER.includes(item.name));
  const pair = items.filter((item) => TOGETHER.includes(item.name));
  const cell = (name, kind, ...parts) => element("div", { class: kind, "data-cell": name }, element("dt", {}, name), ...parts);
  return [
    ...single.map((item) => cell(item.name, "cell", figure(item), element("dd", { class: "detail" }, beside(item), element("span", { class: "words" }, item.detail)))),
    cell(TOGETHER.join(", ").replace("D", "d"), "cell several", ...pair.map((item) => figure(item, beside(item)))),
  ];
}

/** Verdict and figures of an answer beside those of a baseline. */
export function showHeadline(answer, baseline) {
  const items = (from) => from?.views.headline[0].items;
  get("cards").replaceChildren(...cells(items(answer), items(baseline)));
  const { title, words, works, holds, nearest } = answer.document.verdict;
  const kind = [works, holds].includes(false) ? "fail" : [works, holds].includes(null) ? "unknown" : "pass";
  const mark = { fail: "✗", pass: "✓", unknown: "?" }[kind];
  const tightest = nearest ? ` Tightest margin: ${nearest.words}.` : "";
  get("headline").dataset.verdict = kind;
  get("verdict").classList.remove("waits");
  get("verdict").replaceChildren(element("strong", {}, `${mark} ${title}`), element("span", { class: "words" }, ` ${words[0].toUpperCase()}${words.slice(1)}${tightest}`));
}

/** Figures that are known before all else is: they take the places of those of the same name, whose cells wait for the rest. */
export function showFirst(items, baseline) {
  const made = new Map(cells(items, baseline?.views.headline[0].items).map((cell) => [cell.dataset.cell, cell]));
  for (const cell of [...get("cards").children]) {
    const newer = made.get(cell.dataset.cell);
    if (newer) cell.replaceWith(newer);
    else cell.classList.add("waits");
  }
  get("verdict").classList.add("waits");
}

/** The verdict no longer belongs to what was entered: why there is no result. */
export function noVerdict(title, words) {
  get("headline").dataset.verdict = "stale";
  get("verdict").classList.remove("waits");
  get("verdict").replaceChildren(element("strong", {}, title), element("span", { class: "words" }, ` ${words}`));
}

/** The place below the headline, for what sticks there and for what is scrolled to. */
export function followHeight() {
  const bar = get("headline");
  const measure = () => document.documentElement.style.setProperty("--headline", `${Math.ceil(bar.getBoundingClientRect().height)}px`);
  new ResizeObserver(measure).observe(bar);
  measure();
}
