// Lists of sections, the loads of a duty, the branches of unlike sizes and the form errors of parts: their fields, added and removed in one step.

import { element } from "/numbers.js";

const ONE_PER_BRANCH = "each"; // the branches are as many as the drive has
const WORDS = {
  duty: { one: "load", add: "Add a load" },
  form: { one: "part", add: "Add form errors of a part" },
  branch: { one: "branch", add: "Give each branch its own sizes", remove: "Equal branches" },
};

/** Section and number of a path in a list, such as a load of the duty; null for all others. */
export function sectionOf(path) {
  const [name, place, ...rest] = path.split(".");
  return name in WORDS && rest.length ? { name, place: Number(place), key: rest.join("."), title: `${WORDS[name].one} ${place}` } : null;
}

/** A share of the time, 0.4 or "40 %". */
const shareOf = (text) => parseFloat(text) / (String(text).trim().endsWith("%") ? 100 : 1) || 0;
const rounded = (share) => Number(share.toFixed(10));

export class Lists {
  /** `controls` makes the rows; their texts are those of the changes, so that they are right before the server answers. */
  constructor(controls) {
    this.controls = controls;
    this.stated = {}; // of the file: keys of a section, and what its sections say
    this.bodies = new Map();
    this.shown = new Map(); // arrangement on the page
    this.changes = {};
    this.counts = {}; // number of branches, as the newest answer has it
  }

  take(stated) {
    this.stated = stated.lists;
    this.counts = {};
    this.bodies.clear();
    this.shown.clear();
  }

  /** The place in the file of each section on the page; 0 for a new one. */
  places(name, changes = this.changes) {
    const { of_file: ofFile, one_for_each: counted, most } = this.stated[name];
    const said = changes[name];
    if (said === undefined) return ofFile.map((_, i) => i + 1);
    if (said !== ONE_PER_BRANCH) return String(said).split(" ", most).filter(Boolean).map((each) => Number(each) || 0); // links may say anything
    const count = Number(changes[counted] ?? this.counts[counted]);
    if (!(Number.isInteger(count) && count > 0 && count <= most)) return this.shown.get(name) || [];
    return Array.from({ length: count }, (_, i) => (i < ofFile.length ? i + 1 : 0));
  }

  /** The group of a list, with what belongs to the whole of it. */
  group(name) {
    const body = element("div", { class: "list", "data-list": name });
    this.bodies.set(name, body);
    return body;
  }

  /** Show the sections that a state has. */
  show(changes, numbers = null) {
    this.changes = changes;
    for (const [name, { one_for_each: counted }] of Object.entries(this.stated)) {
      if (numbers && counted) this.counts[counted] = numbers[counted].value;
      const body = this.bodies.get(name);
      const places = this.places(name);
      if (!body || String(this.shown.get(name)) === String(places)) continue;
      this.shown.set(name, places);
      this.build(name, body, places);
    }
    for (const [name, body] of this.bodies) body.querySelector(".back-list").hidden = !this.differs(name);
  }

  differs(name) {
    return Object.keys(this.changes).some((path) => path === name || path.startsWith(`${name}.`)) && this.stated[name].of_file.length > 0;
  }

  build(name, body, places) {
    for (const path of [...this.controls.rows.keys()]) if (path.startsWith(`${name}.`)) this.controls.rows.delete(path);
    const words = WORDS[name];
    const { keys, words: texts, meaning, most, one_for_each: counted } = this.stated[name];
    const button = (text, act, more = {}) => {
      const made = element("button", { type: "button", "aria-describedby": `list-${name}-error`, ...more }, text);
      made.addEventListener("click", act);
      return made;
    };
    const sections = places.map((source, i) => {
      const title = `${words.one} ${i + 1}`;
      const head = element("legend", {}, title);
      const choices = Object.entries(texts).map(([key, options]) => this.wordRow(`${name}.${i + 1}.${key}`, options, { source, key, name }));
      const rows = keys.map((key) => this.controls.numberRow(`${name}.${i + 1}.${key}`, null, { source, key, name }));
      const remove = counted ? null : button("Remove", () => this.remove(name, i + 1), { class: "remove", "aria-label": `Remove ${title}` });
      return element("fieldset", {}, head, remove, ...choices, ...rows);
    });
    const add = button(words.add, () => this.add(name), { class: "add" });
    add.disabled = places.length >= most;
    const whole = counted && places.length ? button(words.remove, () => this.none(name), { class: "add" }) : add;
    const back = button("Back to the file", () => this.set(name, {}, null), { class: "back-list", "aria-label": `${name}: back to the file` });
    const error = element("p", { class: "field-error", id: `list-${name}-error` });
    body.replaceChildren(element("p", { class: "note" }, meaning.replaceAll("`", "")), ...sections, error, element("div", { class: "list-buttons" }, whole, back));
  }

  /** The row of a word of a section, such as the part that has the form errors. */
  wordRow(path, options, list) {
    const id = `value-${path.replaceAll(".", "-")}`;
    const { title } = sectionOf(path);
    const plain = (word) => word.replaceAll("_", " ");
    const select = element("select", { id, "aria-describedby": `${id}-error` }, ...options.map((word) => element("option", { value: word }, plain(word))));
    const error = element("p", { class: "field-error", id: `${id}-error` });
    const row = { path, input: select, error, list, word: true };
    select.addEventListener("change", () => this.controls.changed(path, select.value));
    this.controls.rows.set(path, row);
    select.value = this.text(row);
    return element("div", { class: "row choice", "data-path": path }, element("label", { for: id }, plain(list.key), element("span", { class: "visually-hidden" }, `, ${title}`)), select, error);
  }

  /** What stands in the field of a row: what was typed, or what the file says. */
  text(row) {
    const changed = this.changes[row.path];
    if (changed !== undefined) return typeof changed === "number" ? row.text(changed) : changed;
    return row.list.source ? this.stated[row.list.name].of_file[row.list.source - 1]?.[row.list.key] ?? "" : "";
  }

  textAt(path) {
    return this.text(this.controls.rows.get(path));
  }

  /** Another arrangement in one step: the changes of a list in place of those that it had; null for that of the file. */
  set(name, values, places) {
    const same = places && String(places) === String(this.stated[name].of_file.map((_, i) => i + 1));
    this.controls.together({ ...(places && !same ? { [name]: places.join(" ") } : {}), ...values }, [name]);
  }

  own(name) {
    return Object.entries(this.changes).filter(([path]) => path.startsWith(`${name}.`));
  }

  add(name) {
    if (this.stated[name].one_for_each) {
      this.controls.together({ ...Object.fromEntries(this.own(name)), [name]: ONE_PER_BRANCH }, [name]);
      this.bodies.get(name).querySelector("input[type=text]")?.focus();
      return;
    }
    const places = this.places(name);
    const last = places.length;
    const values = Object.fromEntries(this.own(name));
    const { keys, words } = this.stated[name];
    for (const key of [...Object.keys(words), ...keys]) {
      const value = this.proposed(name, last, key, values);
      if (value !== null) values[`${name}.${last + 1}.${key}`] = value;
    }
    this.set(name, values, [...places, 0]);
    this.bodies.get(name).querySelector("fieldset:last-of-type input[type=text]")?.focus();
  }

  /**
   * A new load is as the one before it and takes half of its time; the first one is the load of the joint, all the time.
   * New form errors are two and three waves of a part that has none yet.
   */
  proposed(name, last, key, values) {
    if (name === "form") {
      const taken = Array.from({ length: last }, (_, i) => this.textAt(`form.${i + 1}.part`));
      const { part } = this.stated.form.words;
      return { part: part.find((each) => !taken.includes(each)) ?? part[0], "harmonics.2": "1 um", "harmonics.3": "0.5 um" }[key] ?? null;
    }
    const before = last ? this.textAt(`${name}.${last}.${key}`) : null;
    if (key !== "share") {
      const [row, stated] = [this.controls.rows, new Map(Object.entries(this.controls.values))].map((each) => each.get(`load.${key}`));
      return before ?? (row && stated ? row.text(stated.value) : "");
    }
    if (before === null) return 1;
    const half = rounded(shareOf(before) / 2);
    values[`${name}.${last}.share`] = rounded(shareOf(before) - half);
    return half;
  }

  /** Leave a section out; its share of the time goes to its neighbour. */
  remove(name, place) {
    const values = {};
    const places = this.places(name);
    const neighbour = place > 1 ? place - 1 : place + 1;
    const key = `${name}.${neighbour}.share`;
    const share = this.controls.rows.has(key) ? rounded(shareOf(this.textAt(key)) + shareOf(this.textAt(`${name}.${place}.share`))) : null;
    for (const [path, value] of [...this.own(name), ...(share === null ? [] : [[key, share]])]) {
      const at = sectionOf(path);
      if (at.place !== place) values[`${name}.${at.place > place ? at.place - 1 : at.place}.${at.key}`] = value;
    }
    this.set(name, values, places.filter((_, i) => i !== place - 1));
    const left = this.bodies.get(name).querySelectorAll(".remove");
    (left[Math.min(place, left.length) - 1] || this.bodies.get(name).querySelector(".add")).focus();
  }

  none(name) {
    this.set(name, {}, []);
    this.bodies.get(name).querySelector(".add").focus();
  }

  /** What a slider of a share moves besides: the other loads keep their proportions, and all add up to 1. */
  balanced(row, value) {
    if (row.list?.key !== "share") return {};
    const others = [...this.controls.rows.values()].filter((each) => each.list?.key === "share" && each !== row);
    const shares = others.map((each) => shareOf(this.text(each)));
    const total = shares.reduce((sum, each) => sum + each, 0);
    const found = {};
    let left = 1 - value;
    others.forEach((each, i) => {
      const share = Number(((1 - value) * (total ? shares[i] / total : 1 / others.length)).toPrecision(4));
      found[each.path] = rounded(i === others.length - 1 ? left : share);
      left -= share;
    });
    return Object.values(found).every((share) => share > 0) ? found : {};
  }

  /** What follows from a new number of branches. */
  following(path) {
    const found = Object.entries(this.stated).find(([name, { one_for_each: counted }]) => counted === path && this.places(name).length);
    return found ? { [found[0]]: ONE_PER_BRANCH } : {};
  }

  /** The field that was changed last in the list that a message is about, or else the list itself. */
  named(message, lastPath) {
    const name = Object.keys(this.stated).find((each) => message.includes(`[[${each}]]`));
    if (!name) return {};
    return { [lastPath?.startsWith(`${name}.`) ? lastPath : name]: message };
  }

  showErrors(keys) {
    for (const [name, body] of this.bodies) {
      const error = body.querySelector(`#list-${name}-error`);
      if (!error) continue;
      error.textContent = keys[name] || "";
      if (keys[name]) body.closest("details").open = true;
    }
  }
}
