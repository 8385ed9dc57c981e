// The parameters: one row a number with slider and field; choices as lists. Errors stand at their field.

import { choiceRows, finishRow, showChoice } from "/choices.js";
import { Height, isDepth, otherHeight } from "/heights.js";
import { Lists, sectionOf } from "/lists.js";
import { element, jsonLink, number, unitText } from "/numbers.js";
import { isNarrow } from "/panels.js";
import { UnitPicker, withUnit } from "/units.js";

const OPEN = ["drive", "load", "surface", "bodies"];
const STEP = { ArrowUp: 1, ArrowDown: -1 }; // of a slider, by the keys of its field
const STEPS = 400;
const BESIDE = 10; // letters of a field beside its slider; a longer text has a line of its own
const BELOW = 16; // letters of a field below its slider; a longer text has the whole line
const DIGITS = 4; // of a slider in another unit than that of its scale

let contacts = []; // names of the contacts of the drive on the page

/** The measurement in place of the surfaces of the file, as text; empty where there is none. */
const measurement = (stated) => (stated.document?.measured_surface ? JSON.stringify(stated.document.measured_surface, null, 2) : "");

/** What a number is called on the page. */
export function label(path) {
  const parts = path.split(".").slice(1);
  if (path.startsWith("materials.")) return `${parts[1].replaceAll("_", " ")}, ${parts[0]}`;
  if (path.startsWith("fluids.")) return `${parts.slice(1).join(" ").replaceAll("_", " ")}, ${parts[0]}`;
  if (/^(roller|contact)\./.test(path)) return `${parts[1].replaceAll("_", " ")}, ${path.split(".")[0]} ${parts[0]}`;
  const section = sectionOf(path);
  if (section) return `${section.key.replace(/^harmonics\.(\d+)$/, "$1 waves").split(".").join(" ").replaceAll("_", " ")}, ${section.title}`;
  const contact = parts.find((part) => contacts.includes(part));
  const words = parts.filter((part) => part !== contact).join(" ").replaceAll("_", " ");
  return contact ? `${words}, ${contact}` : words;
}

/** Ends of a slider around a value, and how its places become values. */
export function sliderScale(parameter, value) {
  const { lowest, highest, whole, example_value: example } = parameter;
  if (whole) return scale("linear", Math.max(lowest, Math.min(2, value)), Math.min(highest, Math.max(8, value)), 1);
  if (highest - lowest <= 5 && parameter.unit === "1") {
    const inset = 0.02 * (highest - lowest);
    const low = lowest + (parameter.lowest_included ? 0 : inset);
    return scale("linear", Math.min(low, value), Math.max(highest - (parameter.highest_included ? 0 : inset), value));
  }
  if (value > 0 && lowest >= 0 && !parameter.key.endsWith("sun_speed")) {
    const factor = parameter.key.endsWith("fractal_roughness") ? 100 : 4;
    return scale("log", Math.max(value / factor, lowest), Math.min(value * factor, highest));
  }
  const reach = Math.min(Math.max(2 * Math.abs(value), 2 * Math.abs(example)), highest);
  return scale("linear", value < 0 || lowest < 0 ? Math.max(-reach, lowest) : 0, reach);
}

function scale(kind, low, high, step = 0) {
  const round = (value) => Number(value.toPrecision(kind === "log" ? 3 : 4));
  return {
    kind,
    low,
    high,
    steps: step ? (high - low) / step : STEPS,
    value(place) {
      const share = place / (step ? (high - low) / step : STEPS);
      if (step) return low + place * step;
      return round(kind === "log" ? low * (high / low) ** share : low + share * (high - low));
    },
    place(value) {
      const share = kind === "log" ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low);
      return Math.round(Math.min(Math.max(share, 0), 1) * (step ? (high - low) / step : STEPS));
    },
  };
}

export class Controls {
  /**
   * `changed(path, text, moving, also)` is called for each new value; null puts back that of the file; `also` are values
   * that follow from it. `together(values, sections)` sets several keys in one step; `unmeasured()` takes measured
   * surfaces out of the joint.
   */
  constructor(form, description, changed, together, unmeasured) {
    this.form = form;
    this.unmeasured = unmeasured;
    this.together = together;
    this.description = description;
    this.changed = changed;
    this.rows = new Map();
    this.values = {}; // of the newest answer: numbers, and what is only entered
    this.heights = [];
    this.lists = new Lists(this);
    this.own = description;
    this.take(null);
    form.addEventListener("submit", (event) => event.preventDefault());
  }

  /** What can be set in a file of this type of drive; null before there is one. */
  take(form) {
    this.description = { ...this.own, ...form };
    contacts = this.description.contacts;
    this.parameters = new Map(this.description.groups.flatMap((group) => group.parameters.map((each) => [each.key, each])));
  }

  /** The key of a description for a path of a file: any material, any load, branch, roller or contact. */
  generic(path) {
    const parts = path.split(".");
    const wild = parts.map((_, at) => [...parts.slice(0, at), "*", ...parts.slice(at + 1)].join(".")).slice(1);
    if (parts.length === 4) wild.push([parts[0], "*", parts[2], "*"].join(".")); // waves of a part
    if (parts.length === 5) wild.push([parts[0], "*", parts[2], "*", parts[4]].join(".")); // a row of a table of an oil
    return [path, ...wild].find((key) => this.parameters.has(key)) || path;
  }

  /** Build the rows for the numbers and choices that a joint file has. */
  build(stated) {
    this.take(stated.form);
    const open = new Set([...this.form.querySelectorAll("details[open]")].map((each) => each.dataset.group));
    const first = this.rows.size === 0;
    this.form.replaceChildren();
    this.rows.clear();
    this.heights = [];
    this.values = { ...stated.numbers, ...stated.entered };
    this.lists.take(stated);
    const groups = this.description.groups.map((group) => [group.name, group.heading]);
    groups.splice(3, 0, ["bodies", "Bodies"]);
    groups.push(["model", "Model"]);
    this.finish = null;
    this.measured = measurement(stated);
    for (const [name, heading] of groups) {
      const fields = () => [...choiceRows(this, name, stated), ...this.numberRows(name, stated)];
      const measured = name === "surface" && this.measured;
      const rows = measured ? [this.measuredRow()] : name in stated.lists ? [this.lists.group(name)] : fields();
      if (name === "surface" && !measured) rows.unshift(finishRow(this, stated));
      if (!rows.length) continue;
      const details = element("details", { "data-group": name }, element("summary", {}, heading), ...rows);
      details.open = first ? OPEN.includes(name) && !isNarrow() : open.has(name);
      this.form.append(details);
    }
  }

  /** What stands in place of the surfaces of the file where measured ones do. */
  measuredRow() {
    const back = element("button", { type: "button", id: "remove-surface" }, "Back to the surfaces of the file");
    back.addEventListener("click", this.unmeasured);
    const { source, measurement_of: of } = JSON.parse(this.measured);
    const said = `${of === "pair" ? "The pair as measured" : "Each body as measured"}: ${source}. It takes the place of the surfaces of the file at every contact. Model, contact law, chooses the law. The joint file that is saved names the saved measurement, measured_surface.json: keep both in one folder.`;
    return element("div", { class: "measured" }, element("p", { class: "note" }, said), back, " ", jsonLink("Save measurement", "measured_surface", this.measured));
  }

  numberRows(group, stated) {
    const used = new Set(Object.entries(stated.choices).filter(([path]) => path.startsWith("bodies.")).map((each) => each[1]));
    const paths = Object.keys(this.values).filter(
      (path) => path.startsWith(`${group}.`) && (group !== "materials" || used.has(path.split(".")[1])),
    );
    const present = new Set(paths.map((path) => this.generic(path)));
    for (const [key] of this.parameters) {
      const parts = key.split(".");
      const single = parts.length === 2 && !key.includes("*");
      const split = [...present].some((path) => path.startsWith(`${key}.`));
      const partOfSplit = group === "surface" && paths.some((path) => path.split(".").length > 2);
      if (parts[0] === group && single && !present.has(key) && !split && !partOfSplit) paths.push(key);
    }
    const row = (path) => this.numberRow(path, this.values[path]);
    return paths.filter((path) => !isDepth(path)).flatMap((path) => (otherHeight(path) ? this.heightRows(path, row) : [row(path)]));
  }

  /** Ra and Rz of a surface below the list that says which of them is given. */
  heightRows(path, row) {
    const height = new Height(this, path, label(path).replace("roughness average", "roughness given as"));
    this.heights.push(height);
    return [height.node, row(path), row(height.depth)];
  }

  /** The row of a number; that of a section in a list knows its place. */
  numberRow(path, entry, list = null) {
    const parameter = this.parameters.get(this.generic(path));
    const id = `value-${path.replaceAll(".", "-")}`;
    const name = label(path);
    const unit = parameter.unit === "1" ? "" : ` ${parameter.unit}`;
    const text = (value) => `${number(value, 12)}${unit}`;
    const input = element("input", {
      type: "text",
      id,
      "aria-describedby": `${id}-help ${id}-error`,
      spellcheck: "false",
      placeholder: this.placeholder(parameter, entry, list),
      title: (!list && parameter.default) || null, // a narrow field cuts its placeholder off
      autocapitalize: "off",
    });
    const units = this.own.units[parameter.dimension] || [];
    const picker = units.length > 1 ? new UnitPicker(id, name, units, parameter.unit) : null;
    const slider = element("input", { type: "range", "aria-label": `${name}, slider`, min: 0, step: 1, tabindex: "0" });
    const back = element("button", { type: "button", class: "back", "aria-label": `${name}: back to the file's value`, title: "Back to the file's value" }, "↺");
    const help = element(
      "p",
      { class: "help", id: `${id}-help` },
      `${parameter.meaning} Allowed: ${parameter.allowed}.` + (parameter.unit === "1" ? "" : " Any unit of this kind."),
    );
    const error = element("p", { class: "field-error", id: `${id}-error` });
    const node = element(
      "div",
      { class: picker ? "row" : "row bare", "data-path": path },
      element("label", { for: id, title: parameter.meaning }, ...(list ? [name.replace(/, [^,]*$/, ""), element("span", { class: "visually-hidden" }, name.match(/, [^,]*$/)[0])] : [name])),
      slider,
      input,
      picker && picker.node,
      back,
      help,
      error,
    );
    const row = { path, node, input, slider, picker, error, text, parameter, list, base: entry ? entry.value : null, shown: "", answered: {} };
    this.rescale(row, row.base);
    if (list) this.write(row, this.lists.text(row));
    slider.addEventListener("input", () => {
      const value = row.scale.value(Number(slider.value));
      this.write(row, this.inUnit(row, value));
      slider.setAttribute("aria-valuetext", input.value);
      this.changed(path, parameter.unit === "1" ? value : input.value, true, this.lists.balanced(row, value));
    });
    slider.addEventListener("change", () => this.changed(null));
    const commit = () => {
      const written = withUnit(input.value.trim(), row.shown || (picker ? picker.select.value : unit));
      if (written === row.shown.trim()) return;
      this.write(row, written);
      this.changed(path, written === "" && row.base === null && !list ? null : written);
    };
    input.addEventListener("change", commit);
    input.addEventListener("keydown", (event) => {
      if (event.key === "Enter") commit();
      if (event.key === "Escape") input.value = row.shown;
      if (!(event.key in STEP) || slider.disabled) return;
      event.preventDefault();
      if (input.value.trim() !== row.shown.trim()) commit();
      else this.step(slider, STEP[event.key]);
    });
    input.addEventListener("keyup", (event) => event.key in STEP && this.changed(null));
    if (picker) picker.select.addEventListener("change", () => this.convert(row));
    back.addEventListener("click", () => {
      this.changed(path, null);
      const height = this.heights.find((each) => [each.average, each.depth].includes(path));
      (height ? height.select : input).focus();
    });
    this.rows.set(path, row);
    return node;
  }

  /** Move a slider by a step, from its field. */
  step(slider, count) {
    slider.stepUp(count);
    slider.dispatchEvent(new Event("input"));
  }

  /** A value of a slider as text, in the unit that its field has. */
  inUnit({ picker, parameter, text }, value) {
    const same = !picker || ["", parameter.unit].includes(picker.select.value);
    return same ? text(value) : picker.converted(text(value), null, DIGITS);
  }

  /** Put a text into a field; a long one gets a line of its own, except while its slider moves. */
  write(row, text) {
    row.shown = text;
    if (document.activeElement !== row.input || row.input.value.trim() !== text) row.input.value = text;
    this.fit(row);
  }

  fit(row) {
    if (row.picker) row.picker.follow(row.shown);
    if (document.activeElement === row.slider) return;
    row.node.classList.toggle("long", row.shown.length > BESIDE);
    row.node.classList.toggle("longer", row.shown.length > BELOW);
  }

  /** The number of a field in the unit that was chosen; an empty field takes it for the next number. */
  convert(row) {
    const { picker, shown, answered } = row;
    const text = picker.converted(shown, answered.text === shown ? answered.si : null) ?? (row.error.textContent ? picker.renamed(shown) : null);
    if (text === null) {
      this.fit(row);
      return;
    }
    if (text === shown) return;
    this.write(row, text);
    this.changed(row.path, text);
  }

  placeholder(parameter, entry, list) {
    if (isDepth(parameter.key) && !entry) return `e.g. ${parameter.example}`;
    if (list) return { branch: "0", form: list.key === "phase" ? "not known" : "none" }[list.name] ?? "";
    return (parameter.default || (entry ? parameter.example : "not in the file")).replace(/if absent[,:] | if absent/, "");
  }

  rescale(row, value) {
    row.slider.disabled = value === null;
    row.node.classList.toggle("absent", value === null && !row.list);
    if (value === null) return;
    const share = row.list?.key === "share"; // others have a part, too
    row.scale = sliderScale(share ? { ...row.parameter, highest_included: false } : row.parameter, value);
    row.slider.max = row.scale.steps;
    row.slider.value = row.scale.place(value);
  }

  /** Show the values of an answer to some changes; what the user has typed since stays as typed. */
  show(stated, changes, asked) {
    this.values = { ...stated.numbers, ...stated.entered };
    const measured = measurement(stated);
    const missing = Object.keys(this.values).some((path) => !this.rows.has(path) && !(measured && path.startsWith("surface.")) && !sectionOf(path) && this.isShown(path, stated));
    if (missing || this.materials !== this.used(stated) || this.measured !== measured) this.build(stated);
    this.materials = this.used(stated);
    if (this.finish) this.finish.show(stated);
    this.lists.show(changes, stated.numbers);
    for (const height of this.heights) height.show(this.values, changes);
    for (const row of this.rows.values()) {
      const changed = row.path in changes;
      if (row.choice) showChoice(row, stated, changes);
      if (row.word) row.input.value = this.lists.text(row);
      if (row.choice || row.word) continue;
      row.node.classList.toggle("changed", changed && row.list?.source !== 0);
      const entry = this.values[row.path] || (row.list?.name === "branch" ? { value: 0 } : null);
      const typed = changes[row.path];
      row.shown = row.list ? this.lists.text(row) : changed && typeof typed === "string" ? typed : entry ? entry.text || row.text(entry.value) : "";
      row.answered = { text: asked[row.path] ?? row.shown, si: entry ? entry.si : null };
      this.fit(row);
      if (document.activeElement !== row.input || row.input.value.trim() === "") row.input.value = row.shown;
      if (!entry) {
        this.rescale(row, null);
      } else if (row.slider.disabled || entry.value < row.scale.low * (1 - 1e-9) || entry.value > row.scale.high * (1 + 1e-9)) {
        this.rescale(row, entry.value);
      } else if (document.activeElement !== row.slider && asked[row.path] === changes[row.path]) {
        row.slider.value = row.scale.place(entry.value);
      }
      row.slider.setAttribute("aria-valuetext", row.shown);
      if (row.list?.key === "share" && entry && entry.value === 1) row.slider.disabled = true; // the only load
    }
  }

  /** The slider of a number: its ends, steps and values, and how its values are written; null where there is none. */
  sliderOf(path) {
    const row = this.rows.get(path);
    return row && row.scale && !row.slider.disabled ? { ...row.scale, text: row.text } : null;
  }

  isWhole(path) {
    return this.rows.get(path).parameter.whole;
  }

  /** Half and twice a value as texts, within the ends of its slider; these ends where it is not positive. */
  proposedBounds(path) {
    const row = this.rows.get(path);
    const { value } = this.values[path];
    const { low, high } = row.scale;
    const ends = value > 0 ? [Math.max(low, value / 2), Math.min(high, 2 * value)] : [low, high];
    return ends.map((end) => this.inUnit(row, Number(end.toPrecision(DIGITS))));
  }

  /** The keys whose place a key takes, as the server says. */
  replaced(path) {
    const parameter = this.parameters.get(this.generic(path));
    const above = path.split(".").slice(0, -1).join(".");
    return parameter ? parameter.replaces.map((name) => `${above}.${name}`) : [];
  }

  isShown(path, stated) {
    if (!path.startsWith("materials.")) return true;
    return Object.entries(stated.choices).some(([key, word]) => key.startsWith("bodies.") && word === path.split(".")[1]);
  }

  used(stated) {
    return Object.entries(stated.choices).filter(([key]) => key.startsWith("bodies.")).map((each) => each[1]).join();
  }

  /** The fields that a message about several keys names, and the list. */
  named(message, lastPath) {
    const paths = [...this.rows.keys()].filter((path) => message.includes(path));
    const longest = paths.filter((path) => !paths.some((other) => other !== path && other.startsWith(`${path}_`) && !message.replaceAll(other, "").includes(path)));
    return { ...Object.fromEntries(longest.map((path) => [path, message])), ...this.lists.named(message, lastPath) };
  }

  /** Mark the fields that a message is about; the last changed one where it names none. */
  showErrors(keys) {
    for (const row of this.rows.values()) {
      const message = keys[row.path] || "";
      row.error.textContent = message;
      row.input.toggleAttribute("aria-invalid", Boolean(message));
      if (message) {
        row.input.setAttribute("aria-invalid", "true");
        const group = row.input.closest("details");
        if (group) group.open = true;
        const height = this.heights.find((each) => [each.average, each.depth].includes(row.path));
        if (height) height.view(row.path === height.depth ? "Rz" : "Ra");
      }
    }
    this.lists.showErrors(keys);
  }
}

export { unitText };
