// The height of a surface as its drawing states it: Ra or Rz of a body, and of its partner; one of the two is shown.

import { element, number } from "/numbers.js";

const AVERAGE = "roughness_average";
const DEPTH = "mean_roughness_depth";

/** The Rz that may stand in place of an Ra, and the other way round; null for other keys. */
export function otherHeight(path) {
  if (!path.startsWith("surface.")) return null;
  if (path.endsWith(AVERAGE)) return path.replace(AVERAGE, DEPTH);
  return path.endsWith(DEPTH) ? path.replace(DEPTH, AVERAGE) : null;
}

export const isDepth = (path) => path.startsWith("surface.") && path.endsWith(DEPTH);

export class Height {
  /** The list above the rows of Ra and Rz, which decides which one is seen. */
  constructor(controls, average, title) {
    this.controls = controls;
    this.average = average;
    this.depth = otherHeight(average);
    this.wanted = null; // chosen, but without a value yet
    const id = `height-${average.replaceAll(".", "-")}`;
    const options = [["Ra", "Ra (average)"], ["Rz", "Rz (depth)"]].map(([value, text]) => element("option", { value }, text));
    this.select = element("select", { id, "aria-describedby": `${id}-help` }, ...options);
    const help = element("p", { class: "help", id: `${id}-help` }, "What the drawing states. An Rz is read as the range of Ra that normally distributed heights have; the file keeps the one that is given.");
    this.node = element("div", { class: "row choice" }, element("label", { for: id }, title), this.select, help);
    this.select.addEventListener("change", () => this.chosen());
  }

  chosen() {
    const { values } = this.controls;
    const { average, depth } = this;
    this.wanted = this.select.value;
    if (this.wanted === "Ra" && depth in values && average in values) {
      const found = (path) => this.controls.rows.get(path).text(values[path].value);
      const { value, si, tolerance } = values[average];
      const { unit } = this.controls.rows.get(average).parameter;
      const range = tolerance ? ` +- ${number((tolerance * value) / si, 12)} ${unit}, uniform` : "";
      const cutOff = `${average.split(".").slice(0, -1).join(".")}.cut_off`;
      const also = cutOff in values && this.controls.rows.has(cutOff) ? { [cutOff]: found(cutOff) } : {};
      this.controls.changed(average, `${found(average)}${range}`, false, also);
    } else this.view(this.wanted);
  }

  /** Which of the two the file states; the one that was chosen where it states none. */
  show(values, changes) {
    const stated = this.depth in values ? "Rz" : null;
    if (stated === this.wanted || changes[this.average]) this.wanted = null;
    this.view(stated || this.wanted || "Ra");
  }

  view(kind) {
    this.select.value = kind;
    for (const [path, name] of [[this.average, "Ra"], [this.depth, "Rz"]]) {
      const row = this.controls.rows.get(path);
      if (row) row.node.hidden = name !== kind;
    }
  }
}
