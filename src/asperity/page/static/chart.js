// The free chart: any number of the joint file against any result, the baseline behind it, gaps with their reason.

import { label } from "/controls.js";
import { element, number, unitText } from "/numbers.js";
import { LARGE, linePlot, SMALL } from "/plots.js";

const WIDE = ["result", "over", "family"]; // whose words are long
const KINDS = ["one", "two", "three", "four", "five"];
const PAUSE = 150; // ms without a change of the joint before a chart is asked for
const START = { over: ["load.preload", "load.interference", "load.output_torque"], result: "assembly_stiffness_output" };

const SECTIONS = { load: "Load", drive: "Drive", surface: "Surfaces", materials: "Materials", compliance: "Structure" };
const words = (name) => (name ? name[0].toUpperCase() + name.slice(1).replaceAll("_", " ") : "Other");

/** Options by their group. */
function grouped(entries) {
  const groups = new Map();
  for (const [group, value, text] of entries) {
    if (!groups.has(group)) groups.set(group, element("optgroup", { label: group }));
    groups.get(group).append(element("option", { value }, text));
  }
  return [...groups.values()];
}

const ofUnit = (unit) => (unit === "1" ? "" : `, ${unitText(unit)}`);

/** Results of the server as options of a list. */
export const resultGroups = (results, unit = ofUnit) => grouped(results.map((each) => [words(each.group), each.name, `${each.label}${unit(each.unit)}`]));

/** Numbers of the joint file as options of a list. */
export const numberGroups = (paths) => grouped(paths.map((path) => [path.split(".")[0], path]).map(([section, path]) => [SECTIONS[section] || words(section), path, label(path)]));

/** Stretches of a horizontal axis without a result, from half-way points to half-way points, with their reason. */
export function stretches(x, curves, reasons) {
  const found = [];
  x.forEach((each, i) => {
    if (curves.some((curve) => curve.status[i] === 0)) return;
    const low = i === 0 ? each : (each + x[i - 1]) / 2;
    const high = i === x.length - 1 ? each : (each + x[i + 1]) / 2;
    const text = reasons[curves[0].status[i]];
    const last = found[found.length - 1];
    if (last && last.text === text && last.index === i - 1) Object.assign(last, { to: high, index: i });
    else found.push({ from: low, to: high, text, index: i });
  });
  return found;
}

export class Chart {
  /** `post(path, body)` asks the server; `controls` knows the ends of the sliders. */
  constructor(panel, controls, post) {
    this.panel = panel;
    this.controls = controls;
    this.post = post;
    this.wanted = null;
    this.ghosts = new Map(); // of the baseline, by request
    panel.addEventListener("toggle", () => panel.open && this.opened());
  }

  async opened() {
    if (!this.over) this.build();
    await this.offerResults();
    this.list();
    this.now();
  }

  /** The results of the drive on the page; those of another file may be others. */
  async offerResults() {
    const state = this.wanted && this.wanted.state;
    if (!state || this.offered === state.toml) return;
    const [ok, results] = await this.post("/api/results", JSON.stringify(state));
    if (!ok) return;
    this.offered = state.toml;
    const kept = this.result.value;
    this.result.replaceChildren(...resultGroups(results));
    this.result.value = results.some((each) => each.name === kept) ? kept : START.result;
  }

  build() {
    const field = (name, ...parts) => element("div", { class: WIDE.includes(name) ? "field wide" : "field" }, element("label", { for: `chart-${name}` }, words(name)), ...parts);
    const input = (name, attributes) => element("input", { type: "text", id: `chart-${name}`, spellcheck: "false", ...attributes });
    this.over = element("select", { id: "chart-over" });
    this.family = element("select", { id: "chart-family" });
    this.result = element("select", { id: "chart-result" });
    this.from = input("from");
    this.to = input("to");
    this.points = input("points", { type: "number", min: 2, max: 201, value: 41 });
    this.spacing = element("select", { id: "chart-spacing" }, element("option", { value: "linear" }, "even"), element("option", { value: "log" }, "logarithmic"));
    this.values = input("values", { placeholder: "up to five, separated by commas" });
    this.valuesField = field("values", this.values);
    this.figure = element("div", { id: "chart-figure", "aria-live": "off" });
    this.message = element("p", { class: "note", id: "chart-message", role: "status" });
    this.panel.append(
      element(
        "div",
        { class: "chart-fields", role: "group", "aria-label": "What the chart shows" },
        field("result", this.result),
        field("over", this.over),
        field("from", this.from),
        field("to", this.to),
        field("points", this.points),
        field("spacing", this.spacing),
        field("family", this.family),
        this.valuesField,
      ),
      this.message,
      this.figure,
    );
    this.over.addEventListener("change", () => this.proposeRange());
    this.family.addEventListener("change", () => this.proposeValues());
    for (const each of [this.over, this.family, this.result, this.from, this.to, this.points, this.spacing, this.values]) {
      each.addEventListener("change", () => this.now());
    }
  }

  /** A new joint is on the screen; the chart follows when the sliders rest. */
  follow(state, answer, baseline) {
    this.wanted = { state, baseline, answer };
    if (!this.panel.open || !this.over) return;
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.opened(), PAUSE);
  }

  now() {
    if (!this.wanted || !this.panel.open || !this.over) return;
    clearTimeout(this.timer);
    this.ask();
  }

  /** The numbers of the joint in the lists. */
  list() {
    if (!this.wanted) return;
    const paths = Object.keys(this.wanted.answer.numbers).filter((path) => this.controls.sliderOf(path));
    if (this.listed === paths.join()) return;
    this.listed = paths.join();
    const kept = [this.over.value, this.family.value];
    this.over.replaceChildren(...numberGroups(paths));
    this.family.replaceChildren(element("option", { value: "" }, "none: a single curve"), ...numberGroups(paths));
    const known = (path, otherwise) => (paths.includes(path) ? path : otherwise);
    this.over.value = known(kept[0], START.over.find((path) => paths.includes(path)) || paths[0]);
    this.family.value = known(kept[1], "");
    if (this.over.value !== kept[0]) this.proposeRange();
    if (this.family.value !== kept[1] || !kept[1]) this.proposeValues();
  }

  proposeRange() {
    const slider = this.controls.sliderOf(this.over.value);
    this.from.value = slider.text(slider.low);
    this.to.value = slider.text(slider.high);
    this.spacing.value = slider.kind;
  }

  proposeValues() {
    this.valuesField.hidden = !this.family.value;
    if (!this.family.value) return;
    const slider = this.controls.sliderOf(this.family.value);
    const places = slider.steps <= 4 ? [...Array(slider.steps + 1).keys()] : [0.1, 0.5, 0.9].map((share) => Math.round(share * slider.steps));
    this.values.value = places.map((place) => slider.text(slider.value(place))).join(", ");
  }

  asked() {
    const chart = {
      over: this.over.value,
      from: this.from.value,
      to: this.to.value,
      points: Number(this.points.value),
      scale: this.spacing.value,
      result: this.result.value,
    };
    if (this.family.value) chart.family = { over: this.family.value, values: this.values.value.split(",").map((text) => text.trim()).filter(Boolean) };
    return chart;
  }

  /** Ask for the newest; what comes late is not drawn. */
  async ask() {
    if (this.asking) {
      this.again = true;
      return;
    }
    this.asking = true;
    do {
      this.again = false;
      const { state, baseline } = this.wanted;
      const chart = this.asked();
      const slow = setTimeout(() => this.say("Computing the chart. A result that is shown for the first time is compiled first: some seconds."), 700);
      try {
        const [ok, found] = await this.post("/api/chart", JSON.stringify({ ...state, chart }));
        const ghost = ok && baseline ? await this.ghost(baseline, chart) : null;
        if (found.kind === "busy") setTimeout(() => this.now(), 500);
        else if (!this.again) this.draw(ok, found, ghost, chart);
      } catch {
        this.say("The server does not answer.");
      } finally {
        clearTimeout(slow);
      }
    } while (this.again);
    this.asking = false;
  }

  async ghost(baseline, chart) {
    const { family, ...single } = chart;
    const key = JSON.stringify([baseline.answer.id, single]);
    if (!this.ghosts.has(key)) {
      const [ok, found] = await this.post("/api/chart", JSON.stringify({ ...baseline.state, chart: single }));
      if (this.ghosts.size > 20) this.ghosts.clear();
      this.ghosts.set(key, ok ? found : null);
    }
    return this.ghosts.get(key);
  }

  say(text) {
    if (this.message.textContent !== text) this.message.textContent = text;
  }

  draw(ok, found, ghost, chart) {
    this.figure.classList.toggle("stale", !ok);
    this.panel.dataset.drawn = String(Number(this.panel.dataset.drawn || 0) + 1);
    if (!ok) {
      this.say(found.error);
      return;
    }
    this.say("");
    const x = found.x_shown;
    const shades = stretches(x, found.curves, found.reasons);
    const curves = found.curves.map((curve, i) => ({
      name: found.family ? `${label(found.family)} ${curve.value_shown}` : "all other values as in this joint",
      kind: KINDS[i],
      x,
      y: curve.y_shown,
    }));
    if (ghost) curves.unshift({ name: "baseline", kind: "one", ghost: true, x: ghost.x_shown, y: ghost.curves[0].y_shown });
    const point = found.joint && found.joint.y_shown !== null && found.joint.x_shown >= Math.min(...x) && found.joint.x_shown <= Math.max(...x);
    this.figure.replaceChildren(
      linePlot({
        title: `${words(found.result_label)} over ${label(found.over)}`,
        x: `${label(found.over)}${ofUnit(found.unit)}`,
        y: found.result_unit === "1" ? "ratio or number" : found.result_unit.replaceAll("*", "·"),
        logX: chart.scale === "log" && x[0] > 0 && x.length > 2,
        series: curves,
        shades,
        dots: x.length <= 10,
        size: this.panel.clientWidth > LARGE.width ? LARGE : SMALL,
        point: point ? { x: found.joint.x_shown, y: found.joint.y_shown, name: "this joint" } : null,
        empty: shades.length ? `No result anywhere: ${shades[0].text}.` : "This result has no value here: see the page 'Results' of the documentation.",
      }),
      this.reasons(found, shades),
    );
  }

  /** Where there is no result, in words: the shaded parts, or of each curve. */
  reasons(found, shades) {
    const unit = found.unit === "1" ? "" : ` ${found.unit.replaceAll("*", "·")}`;
    const place = (shade) => `${number(shade.from)} to ${number(shade.to)}${unit}: ${shade.text}`;
    const lines = found.curves.length === 1
      ? shades.map(place)
      : found.curves.flatMap((curve) => stretches(found.x_shown, [curve], found.reasons).map((shade) => `${label(found.family)} ${curve.value_shown}, ${place(shade)}`));
    if (!lines.length) return "";
    return element("div", { class: "note" }, "No result (shaded where no curve has one):", element("ul", { class: "reasons" }, ...lines.map((text) => element("li", {}, text))));
  }
}
