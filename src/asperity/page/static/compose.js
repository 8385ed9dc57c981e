// A design without a file: free numbers with bounds, goal and limits, written as the design file that the server reads.

import { numberGroups, resultGroups } from "/chart.js";
import { element, saveText, unitText } from "/numbers.js";
import { withUnit } from "/units.js";

const START = { numbers: ["load.preload", "load.interference", "drive.contact_length"], goal: "assembly_stiffness_output", limit: "hertz_pressure" };
const SIDES = [["at_most", "at most"], ["at_least", "at least"]];

/** A text as TOML. */
const quoted = (text) => JSON.stringify(text);

const list = (options) => element("select", {}, ...options.map(([value, text]) => element("option", { value }, text)));

export class Composer {
  /** `post(path, body)` asks the server; `begin(job, refused)` begins a study, or says what it was refused for. */
  constructor(controls, post, begin) {
    this.controls = controls;
    this.post = post;
    this.begin = begin;
    this.variables = [];
    this.limits = [];
    this.made = 0; // fields, for their names in the document
    this.node = element("details", { id: "compose" }, element("summary", {}, "Compose a design without a file"));
    this.node.addEventListener("toggle", () => this.node.open && this.opened());
  }

  build() {
    this.numberList = element("div", {});
    this.limitList = element("div", {});
    this.aim = list([["maximise", "maximise"], ["minimise", "minimise"]]);
    this.result = element("select", {});
    this.goalError = element("p", { class: "field-error", role: "alert" });
    this.message = element("p", { class: "note fail", role: "alert", id: "compose-message" });
    const button = (text, act, id) => {
      const made = element("button", { type: "button", id }, text);
      made.addEventListener("click", act);
      return made;
    };
    const group = (title, ...parts) => element("fieldset", {}, element("legend", {}, title), ...parts);
    this.node.append(
      element("p", { class: "note" }, "The design chooses the free numbers between their bounds so that the goal is as large or as small as the limits allow. Of a result with several contacts the worst one counts. A number alone takes the unit of its field."),
      group("Free numbers", this.numberList, button("Add a free number", () => this.addVariable(), "add-variable")),
      group("Goal", element("div", { class: "compose-row goal" }, this.field("Aim", this.aim), this.field("Result", this.result)), this.goalError),
      group("Limits", this.limitList, button("Add a limit", () => this.addLimit(), "add-limit")),
      this.message,
      element("div", { class: "list-buttons" }, button("Design", () => this.run(), "run-design"), button("Save design file", () => this.save(), "save-design")),
      element("p", { class: "note" }, "The saved file names the joint file: save both into one folder and run asperity design. No contact slips or lifts off, and the rollers fit, in every design."),
    );
  }

  field(text, input) {
    this.made += 1;
    input.id = `compose-${this.made}`;
    return element("div", { class: "field" }, element("label", { for: input.id }, text), input);
  }

  /** A joint is on the page: its numbers and its results are those to choose from. */
  follow(state, answer) {
    this.wanted = { state, answer };
    if (this.node.open) this.opened();
  }

  async opened() {
    if (!this.wanted) return;
    const { state, answer } = this.wanted;
    if (this.offered !== state.toml) {
      const [ok, results] = await this.post("/api/results", JSON.stringify(state)).catch(() => [false]);
      if (!ok) return; // the page says why; the next answer asks again
      const known = new Map(results.filter((each) => each.design).map((each) => [each.design.name, { ...each, ...each.design }]));
      this.offered = state.toml;
      this.results = [...known.values()];
      if (!this.result) this.build(); // its buttons need the results
      for (const select of [this.result, ...this.limits.map((row) => row.select)]) this.offer(select, this.groups(), START.goal);
    }
    const paths = Object.keys(answer.numbers).filter((path) => this.controls.sliderOf(path) && !this.controls.isWhole(path));
    if (this.listed === paths.join()) return;
    this.listed = paths.join();
    this.paths = paths;
    for (const row of this.variables.filter((each) => !paths.includes(each.select.value))) this.remove(this.variables, row);
    for (const row of this.variables) this.offer(row.select, numberGroups(paths));
    if (!this.variables.length) this.addVariable();
  }

  /** Other entries of a list, which keeps its own where it is one of them. */
  offer(select, groups, otherwise = "") {
    const kept = select.value || otherwise;
    select.replaceChildren(...groups);
    if ([...select.options].some((option) => option.value === kept)) select.value = kept;
  }

  /** The results without their units, which the values of limits have. */
  groups() {
    return resultGroups(this.results, () => "");
  }

  row(rows, place, what, title, select, ...fields) {
    const remove = element("button", { type: "button", class: "remove", "aria-label": `Remove this ${what}` }, "Remove");
    const error = element("p", { class: "field-error", role: "alert" });
    const node = element("div", { class: "compose-entry" }, element("div", { class: "compose-row" }, this.field(title, select), ...fields, remove), error);
    const row = { node, select, error };
    remove.addEventListener("click", () => {
      this.remove(rows, row);
      place.nextElementSibling.focus();
    });
    rows.push(row);
    place.append(node);
    return row;
  }

  remove(rows, row) {
    row.node.remove();
    rows.splice(rows.indexOf(row), 1);
  }

  /** A field whose number alone takes the unit that it had, or that `unit()` says. */
  quantity(unit = () => "") {
    const input = element("input", { type: "text", spellcheck: "false", autocapitalize: "off" });
    let before = "";
    input.addEventListener("focus", () => {
      before = input.value || before;
    });
    input.addEventListener("change", () => {
      input.value = withUnit(input.value.trim(), before || unit());
      before = input.value || before;
    });
    input.addEventListener("forget", () => {
      before = "";
    });
    return input;
  }

  addVariable() {
    const used = this.variables.map((row) => row.select.value);
    const free = this.paths.filter((path) => !used.includes(path));
    if (!free.length) return;
    const [lower, upper] = [this.quantity(), this.quantity()];
    const row = this.row(this.variables, this.numberList, "free number", "Free number", element("select", {}), this.field("from", lower), this.field("to", upper));
    this.offer(row.select, numberGroups(this.paths), START.numbers.find((path) => free.includes(path)) || free.find((path) => path.startsWith("drive.")) || free[0]);
    const propose = () => {
      for (const each of [lower, upper]) each.dispatchEvent(new Event("forget"));
      [lower.value, upper.value] = this.controls.proposedBounds(row.select.value);
    };
    row.select.addEventListener("change", propose);
    row.line = () => `${quoted(row.select.value)} = { lower = ${quoted(lower.value.trim())}, upper = ${quoted(upper.value.trim())} }`;
    row.key = () => `variables.${row.select.value}`;
    propose();
  }

  addLimit() {
    const select = element("select", {});
    const side = list(SIDES);
    const unit = () => this.results.find((each) => each.name === select.value).unit.replace(/^1$/, "");
    const value = this.quantity(unit);
    const row = this.row(this.limits, this.limitList, "limit", "Result", select, this.field("must be", side), this.field("value", value));
    this.offer(select, this.groups(), START.limit);
    const show = () => {
      value.value = "";
      value.dispatchEvent(new Event("forget"));
      value.placeholder = unit() ? `in ${unitText(unit())}` : "a number";
    };
    select.addEventListener("change", show);
    row.line = () => `${select.value}.${side.value} = ${quoted(value.value.trim())}`;
    row.key = () => `constraints.${select.value}`;
    show();
  }

  /** Name of the design file, and its text; each row knows its line. */
  file() {
    const stem = this.wanted.state.name.replace(/\.toml$/, "").replace(/[^A-Za-z0-9._-]/g, "_") || "joint";
    const lines = [`joint = ${quoted(`${stem}.toml`)}`, "", "[variables]"];
    const add = (row) => {
      lines.push(row.line());
      row.place = lines.length;
    };
    this.variables.forEach(add);
    lines.push("", "[objective]", `${this.aim.value} = ${quoted(this.result.value)}`);
    if (this.limits.length) lines.push("", "[constraints]");
    this.limits.forEach(add);
    return { name: `${stem}_design.toml`, text: `${lines.join("\n")}\n` };
  }

  async run() {
    const { name, text } = this.file();
    this.showErrors("");
    await this.begin({ kind: "design", design: text, file: name }, (message) => this.showErrors(message));
  }

  save() {
    const { name, text } = this.file();
    saveText(name, text, "application/toml");
  }

  /** Each line of a message at the row that it names, by its key or by the line of the file; the rest below. */
  showErrors(message) {
    const goal = { key: () => "objective", error: this.goalError };
    const rows = [...this.variables, ...this.limits, goal];
    for (const { error } of rows) error.textContent = "";
    const lines = message.split("\n");
    const left = lines.filter((line, i) => {
      const [, key] = line.match(/(?:^|\s)((?:variables|constraints|objective)[^\s:]*): /) || [];
      const row = rows.find((each) => (key ? `${key}.`.startsWith(`${each.key()}.`) : line.includes(`(at line ${each.place},`)));
      if (row) row.error.textContent = key ? line.slice(line.indexOf(`${key}: `) + key.length + 2) : line.trim();
      return !row && !(i === 0 && lines.length > 1); // their number
    });
    this.message.textContent = left.join("\n");
  }
}
