// Line plots as SVG: axes with units and round ticks, a marker, a legend, a baseline behind.

import { element, number, svg } from "/numbers.js";

/** Sizes of a plot in the units of its texts, which are 12 of them high: beside others, and alone. */
export const SMALL = { width: 330, height: 216 };
export const LARGE = { width: 640, height: 340 };
const LEFT = 48; // at least
const DIGIT = 7.4; // width of a figure of a tick
const RIGHT = 12;
const TOP = 8;
const BOTTOM = 38;

/** Round ticks that cover a range. */
export function ticks(low, high, most = 6) {
  const span = high - low;
  if (!(span > 0)) return [low];
  const raw = span / most;
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].find((factor) => factor * power >= raw * 0.999) * power;
  const found = [];
  for (let index = Math.ceil(low / step - 1e-9); index * step <= high + 1e-9 * span; index += 1) {
    found.push(index * step);
  }
  return found;
}

/** Powers of ten, with 2 and 5 between them where there are few. */
export function decades(low, high) {
  const found = [];
  const factors = Math.log10(high / low) > 2 ? [1] : [1, 2, 5];
  for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); power += 1) {
    for (const factor of factors) {
      const value = factor * 10 ** power;
      if (value >= low * 0.999 && value <= high * 1.001) found.push(value);
    }
  }
  return found;
}

function range(values, { zero = false } = {}) {
  let low = Math.min(...values);
  let high = Math.max(...values);
  if (zero) {
    low = Math.min(low, 0);
    high = Math.max(high, 0);
  }
  if (!(high > low)) {
    const size = Math.abs(low) || 1;
    low -= 0.05 * size;
    high += 0.05 * size;
  }
  return [low, high];
}

/** Texts of ticks with as many digits as their distance needs. */
function tickTexts(values) {
  const step = values.length > 1 ? Math.abs(values[1] - values[0]) : Math.abs(values[0]) || 1;
  const largest = Math.max(...values.map(Math.abs), step);
  const digits = Math.min(12, Math.max(1, Math.ceil(Math.log10(largest / step) + 1.001)));
  return values.map((value) => (Math.abs(value) < 1e-9 * step ? "0" : number(value, digits)));
}

/**
 * A plot in a figure. `series`: [{ name, x, y, kind, ghost }], where kind is one of the classes "one"
 * to "five", and `mark`: { x, y } a dot on the curve; `point`: { x, y, name } marks the joint itself; `limit`: { x, name } a line across; `shades`: [{ from, to, text }] are parts
 * of the horizontal axis without a result; `dots` marks the points of the curves, which begin at a distance `from` the middle of the horizontal axis;
 * `stems`: upright lines to the points of each series, whose `names` are said to who points at them; `xAt`: ticks of the horizontal axis.
 */
export function linePlot({ title, note, x, y, series, point, limit = null, shades = [], log = false, logX = false, zero = false, dots = false, stems = false, xAt = null, from = 0, size = SMALL, empty }) {
  const { width: WIDTH, height: HEIGHT } = size;
  const figure = element("figure", { class: "panel plot" }, element("figcaption", {}, title));
  const good = (value) => value !== null && Number.isFinite(value) && (!log || value > 0);
  const pairs = series.map((line) => line.x.map((each, i) => [each, line.y[i]]).filter(([a, b]) => good(b) && a !== null && Math.abs(a) >= from));
  const all = pairs.flat();
  if (point && good(point.y)) all.push([point.x, point.y]);
  if (all.length < 2) {
    figure.classList.add("without");
    figure.append(element("p", { class: "empty" }, empty || "No curve: there is no value at any torque."));
    return figure;
  }
  const shaded = shades.flatMap((shade) => [shade.from, shade.to]);
  const [xLow, xHigh] = range([...all.map((pair) => pair[0]), ...shaded, ...(from || stems ? [0] : []), ...(stems ? all.map((pair) => 1.03 * pair[0]) : [])]);
  let [yLow, yHigh] = range(all.map((pair) => pair[1]), { zero });
  const margin = log ? (yHigh / yLow) ** 0.06 : 0.06 * (yHigh - yLow);
  if (log) [yLow, yHigh] = [yLow / margin, yHigh * margin];
  else [yLow, yHigh] = [zero && yLow === 0 ? 0 : yLow - margin, yHigh + margin];
  const scale = log ? Math.log10 : (value) => value;
  const across = logX ? Math.log10 : (value) => value;
  const yTicks = log ? decades(yLow, yHigh) : ticks(yLow, yHigh, 5);
  const yTexts = log ? yTicks.map((value) => number(value, 2)) : tickTexts(yTicks);
  const left = Math.max(LEFT, 24 + DIGIT * Math.max(...yTexts.map((text) => text.length))); // ticks beside the label of the axis
  const px = (value) => left + ((across(value) - across(xLow)) / (across(xHigh) - across(xLow))) * (WIDTH - left - RIGHT);
  const py = (value) => TOP + ((scale(yHigh) - scale(value)) / (scale(yHigh) - scale(yLow))) * (HEIGHT - TOP - BOTTOM);
  const drawn = svg("svg", { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": summary(title, x, y, series) });
  for (const shade of shades) {
    const width = Math.max(px(shade.to) - px(shade.from), 2);
    drawn.append(
      svg("rect", { class: "shade", x: px(shade.from), y: TOP, width, height: HEIGHT - TOP - BOTTOM }, svg("title", {}, `no result: ${shade.text}`)),
    );
  }
  const xTicks = xAt ?? (logX ? decades(xLow, xHigh) : ticks(xLow, xHigh, WIDTH > 500 ? 6 : 5));
  const xTexts = logX ? xTicks.map((value) => number(value, 2)) : tickTexts(xTicks);
  xTicks.forEach((value, i) => {
    drawn.append(
      svg("line", { class: "grid", x1: px(value), x2: px(value), y1: TOP, y2: HEIGHT - BOTTOM }),
      svg("text", { class: "tick", x: px(value), y: HEIGHT - BOTTOM + 14, "text-anchor": "middle" }, xTexts[i]),
    );
  });
  yTicks.forEach((value, i) => {
    drawn.append(
      svg("line", { class: "grid", x1: left, x2: WIDTH - RIGHT, y1: py(value), y2: py(value) }),
      svg("text", { class: "tick", x: left - 6, y: py(value) + 4, "text-anchor": "end" }, yTexts[i]),
    );
  });
  drawn.append(
    svg("path", { class: "axis", d: `M${left},${TOP}V${HEIGHT - BOTTOM}H${WIDTH - RIGHT}` }),
    svg("text", { class: "label", x: (left + WIDTH - RIGHT) / 2, y: HEIGHT - 5, "text-anchor": "middle" }, x),
    svg("text", { class: "label", transform: `translate(11 ${(TOP + HEIGHT - BOTTOM) / 2}) rotate(-90)`, "text-anchor": "middle" }, y),
  );
  const marked = limit && limit.x > xLow && limit.x <= xHigh ? limit : null;
  if (marked) drawn.append(svg("line", { class: "capacity", x1: px(marked.x), x2: px(marked.x), y1: TOP, y2: HEIGHT - BOTTOM }));
  if (stems) drawn.append(...upright(series, px, py));
  else series.forEach((line) => {
    // a gap where there is no value
    let path = "";
    let pen = "M";
    line.x.forEach((each, i) => {
      if (good(line.y[i]) && Math.abs(each) >= from) {
        path += `${pen}${px(each).toFixed(2)},${py(line.y[i]).toFixed(2)}`;
        pen = "L";
      } else pen = "M";
    });
    drawn.append(svg("path", { class: `curve ${line.kind}${line.ghost ? " ghost" : ""}`, d: path }));
    if (dots) line.x.forEach((each, i) => good(line.y[i]) && drawn.append(svg("circle", { class: `dot ${line.kind}`, cx: px(each), cy: py(line.y[i]), r: 3 })));
  });
  for (const line of series.filter((each) => each.mark)) {
    drawn.append(svg("circle", { class: `dot ${line.kind}`, cx: px(line.mark.x), cy: py(line.mark.y), r: 5 }));
  }
  if (point && good(point.y)) drawn.append(svg("circle", { class: "point", cx: px(point.x), cy: py(point.y), r: 5 }));
  figure.append(drawn, legend(series, point, marked, stems));
  if (note) figure.append(element("p", { class: "note" }, note));
  return figure;
}

/** Lines from zero to the points of all series, the first ones wider: where several stand at one place, all are seen. */
function upright(series, px, py) {
  const wider = (i) => 0.9 * (series.length - i);
  return series.flatMap(({ x, y, kind, names }, i) => x.flatMap((at, place) => {
    const stem = svg("path", { class: `curve stem ${kind}`, d: `M${px(at).toFixed(2)},${py(0).toFixed(2)}V${py(y[place]).toFixed(2)}` });
    stem.style.strokeWidth = 1.6 + wider(i);
    return [stem, svg("circle", { class: `dot ${kind}`, cx: px(at), cy: py(y[place]), r: 2.4 + 0.6 * wider(i) }, svg("title", {}, names[place]))];
  }));
}

function legend(series, point, marked, stems) {
  const list = element("ul", { class: "legend" });
  for (const line of series) {
    const sample = svg(
      "svg",
      { class: "sample", viewBox: "0 0 28 10", "aria-hidden": "true" },
      svg("path", { class: `curve ${stems ? "stem " : ""}${line.kind}${line.ghost ? " ghost" : ""}`, d: "M0,5H28" }),
    );
    list.append(element("li", {}, sample, line.name));
  }
  if (point) {
    const dot = svg("svg", { class: "sample dot", viewBox: "0 0 10 10", "aria-hidden": "true" }, svg("circle", { class: "point", cx: 5, cy: 5, r: 4 }));
    list.append(element("li", {}, dot, point.name || "this joint"));
  }
  if (marked) {
    const line = svg("svg", { class: "sample", viewBox: "0 0 28 10", "aria-hidden": "true" }, svg("path", { class: "capacity", d: "M0,5H28" }));
    list.append(element("li", {}, line, marked.name));
  }
  return list;
}

/** What a screen reader says instead of the picture. */
function summary(title, x, y, series) {
  const parts = series
    .filter((line) => !line.ghost)
    .map((line) => {
      const good = line.x.map((each, i) => [each, line.y[i]]).filter((pair) => pair[1] !== null);
      if (!good.length) return `${line.name}: no value`;
      const [first, last] = [good[0], good[good.length - 1]];
      return `${line.name}: ${number(first[1])} at ${number(first[0])}, ${number(last[1])} at ${number(last[0])}`;
    });
  return `${title}. ${y} over ${x}. ${parts.join("; ")}.`;
}
