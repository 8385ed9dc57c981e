// Files that are opened or dropped: joint, design, measured surface; the server recognises them by their content.

import { element, jsonLink, number, table } from "/numbers.js";

const LARGEST = 64 * 1024 * 1024; // byte, as the server
const MISSING = [
  ["", "are refused"],
  ["longest", "the largest complete piece"],
  ["interpolate", "filled by straight lines"],
];
const OF = [
  ["body", "one body: both bodies of a contact are alike"],
  ["pair", "both bodies together"],
];
const LAYS = [
  ["", "not stated"],
  ["rolling", "grooves in the rolling direction"],
  ["axis", "grooves along the rollers' axis"],
  ["isotropic", "no grooves"],
];

export class Uploads {
  /** `take` has: joint({name, toml}), design({name, design}), surface(document, beside), surfaces(), opened(), say(text), fail(text, name), post. */
  constructor(panel, take) {
    this.panel = panel;
    this.take = take;
  }

  async open(file, units = {}) {
    if (file.size > LARGEST) {
      this.take.fail(`${file.name} has ${number(file.size / 1048576, 3)} MiB; at most 64 MiB are read here. The command 'asperity surface measure' reads larger files.`, file.name);
      return;
    }
    const query = new URLSearchParams({ name: file.name, ...units });
    const slow = setTimeout(() => this.take.say(`Reading ${file.name}. A measurement takes some seconds.`), 500);
    let ok;
    let found;
    try {
      [ok, found] = await this.take.post(`/api/open?${query}`, await file.arrayBuffer(), "application/octet-stream");
    } catch {
      this.take.fail(`${file.name}: the server does not answer, or refused the file because of its size.`, file.name);
      return;
    } finally {
      clearTimeout(slow);
    }
    if (ok) this.take.opened();
    if (!ok) {
      this.take.fail(found.error, file.name);
      if (/unit|spacing|distance of the points|missing|column|decimal/i.test(found.error) && !file.name.endsWith(".toml")) this.show(file.name, [element("p", { class: "fail" }, found.error), this.units(file, units)]);
    } else if (found.kind === "joint") this.take.joint(found);
    else if (found.kind === "design") this.take.design(found);
    else this.measured(found, file, units);
  }

  show(name, parts) {
    const close = element("button", { type: "button" }, "Close");
    close.addEventListener("click", () => {
      this.panel.hidden = true;
    });
    this.panel.replaceChildren(element("h2", {}, `Measured surface: ${name}`), ...parts, close);
    this.panel.hidden = false;
    this.panel.scrollIntoView({ block: "nearest" });
  }

  /** What the file does not say: units, the distance of the points, the column, and what happens with missing points. */
  units(file, given) {
    const fields = [
      ["position_unit", "Unit of positions", "mm"],
      ["height_unit", "Unit of heights", "um"],
      ["spacing", "Distance of the points", "0.5 um"],
      ["column", "Column of heights", "2"],
      ["no_data", "Number for no data", "-9999"],
      ["decimal", "Decimal sign", "point or comma"],
    ].map(([name, text, example]) => {
      const input = element("input", { type: "text", id: `units-${name}`, placeholder: `e.g. ${example}`, value: given[name] || "" });
      return [name, input, element("div", { class: "field" }, element("label", { for: `units-${name}` }, text), input)];
    });
    const gaps = element("select", { id: "units-missing" }, ...MISSING.map(([value, text]) => element("option", { value, selected: value === given.missing }, text)));
    fields.push(["missing", gaps, element("div", { class: "field" }, element("label", { for: gaps.id }, "Missing points"), gaps)]);
    const again = element("button", { type: "button" }, "Measure again");
    again.addEventListener("click", () => {
      const { lay, direction, measurement_of: of } = given;
      const stated = [["lay", lay], ["direction", direction], ["measurement_of", of], ...fields.map(([name, input]) => [name, input.value.trim()])];
      this.open(file, Object.fromEntries(stated.filter((pair) => pair[1])));
    });
    return element("div", { class: "chart-fields" }, ...fields.map((field) => field[2]), element("div", { class: "field" }, again));
  }

  measured(found, file, units) {
    const measured = found.document;
    const notes = (measured.files || []).flatMap((each) => each.notes);
    const heights = [];
    for (const each of measured.files || []) {
      const rough = each.roughness || {};
      const behind = `, µm, behind the cut-off ${number(1e3 * rough.cut_off_m)} mm`;
      for (const [values, key, name] of [[rough, "Ra_m", `Ra${behind}`], [rough, "Rz_m", `Rz${behind}`], [each, "Pq_m", "Pq, µm, without a filter"], [each, "Sq_m", "Sq, µm"]]) {
        if (key in values) heights.push([name, number(1e6 * values[key]), ""]);
      }
    }
    const interval = (pair, factor = 1) => `${number(pair[0] * factor)} to ${number(pair[1] * factor)}`;
    const refused = measured.no_power_law;
    const fractal = refused !== undefined ? [] : [
      ["fractal dimension D", number(measured.fractal_dimension), interval(measured.fractal_dimension_interval_95)],
      ["fractal roughness G, nm", number(1e9 * measured.fractal_roughness_m), interval(measured.fractal_roughness_interval_95_m, 1e9)],
    ];
    const band = refused !== undefined
      ? `${refused[0].toUpperCase()}${refused.slice(1)}.`
      : `Self-affine from ${number(1e6 * measured.shortest_wavelength_m, 3)} to ${number(1e6 * measured.longest_wavelength_m, 3)} µm; estimator ${measured.estimator}, ${measured.profiles} profile${measured.profiles === 1 ? "" : "s"}. D and G belong together: their errors are almost fully correlated.`;
    const [use, ...parts] = this.uses(found, file, units);
    this.show(found.name, [
      table("Measured surface", ["number", "value", refused === undefined ? "95 % interval" : ""], [...fractal, ...heights]),
      ...[band, ...notes].map((text) => element("p", { class: "note" }, text)),
      ...(refused === undefined ? [] : [this.units(file, units)]),
      ...parts,
      ...(use ? [use, " "] : []),
      jsonLink("Save measurement", found.name, JSON.stringify(measured, null, 2)),
      " ",
    ]);
    this.take.say(refused === undefined ? `Measured: D ${number(measured.fractal_dimension)}, G ${number(1e9 * measured.fractal_roughness_m)} nm.` : found.surface ? "Measured: no power law; the joint uses the measured spectrum." : "The surface has neither a power law nor a spectrum; see the message.");
    if (use && !use.disabled) use.focus();
  }

  /** The button that puts a measured surface into the joint, null where none can be, and what stands before it. */
  uses(found, file, units) {
    if (!found.surface) return [null, element("p", { class: "fail" }, "No joint: a spectrum needs 16 points or more.")];
    const { spectra = [], measurement_of: of } = found.surface;
    const [spectrum] = spectra;
    const sentence = spectrum
      ? "The joint uses the measured spectrum: of its waves those that each contact feels, by the exponential contact law where Model, contact law states none."
      : "A document of an earlier release, without a spectrum: its D and G go into the joint.";
    const use = element("button", { type: "button", id: "use-surface" }, "Put into the joint, at every contact");
    const parts = [element("p", { class: "note" }, sentence)];
    const put = (beside) => () => {
      this.take.surface(found.surface, beside);
      this.panel.hidden = true;
    };
    use.addEventListener("click", put([]));
    const choice = (key, label, words, chosen) => {
      const select = element("select", { id: `surface-${key}` }, ...words.map(([value, text]) => element("option", { value, selected: value === chosen }, text)));
      select.addEventListener("change", () => this.open(file, { ...units, [key]: select.value }));
      parts.push(element("div", { class: "chart-fields" }, element("div", { class: "field wide" }, element("label", { for: select.id }, label), select)));
    };
    if (spectrum && spectrum.is_map && found.document.direction) {
      choice("direction", "The contact rolls along", [["x", "x"], ["y", "y"]], found.document.direction);
    } else if (spectrum && !spectrum.is_map) {
      choice("lay", "Lay of the profile", LAYS, spectrum.lay || "");
      if (!spectrum.lay) parts.push(element("p", { class: "note strong" }, "State the lay: a profile crosses its grooves and tells nothing of the waves along them. Ground rollers, measured along their axis, have grooves in the rolling direction."));
      use.disabled = !spectrum.lay;
    }
    if (spectra.length < 2 && !/^sum of /.test(found.surface.estimator || "")) choice("measurement_of", "The measurement is of", OF, of);
    const there = this.take.surfaces();
    if (there.length === 1 && !use.disabled && of === "body" && there[0].measurement_of !== "pair") {
      const other = element("button", { type: "button", id: "use-other-body" }, `Put in as the other body, beside ${there[0].source}`);
      other.addEventListener("click", put(there));
      parts.push(other, " ");
    }
    return [use, ...parts];
  }
}
