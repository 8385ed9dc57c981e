// Files that are opened or dropped: joint, design, measured surface; the server recognises them by their content.

import { element, number, table } from "/numbers.js";

const LARGEST = 64 * 1024 * 1024; // byte, as the server

export class Uploads {
  /** `take` has: joint({name, toml}), design({name, design}), surface(changes), say(text), fail(text, name), post. */
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
    if (!ok) {
      this.take.fail(found.error, file.name);
      if (/unit|spacing/i.test(found.error) && !file.name.endsWith(".toml")) this.show(file.name, [element("p", { class: "fail" }, found.error), this.units(file, units)]);
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

  /** What the file does not say: units and the distance of the points. */
  units(file, given) {
    const fields = [
      ["position_unit", "Unit of positions", "mm"],
      ["height_unit", "Unit of heights", "um"],
      ["spacing", "Distance of the points", "0.5 um"],
    ].map(([name, text, example]) => {
      const input = element("input", { type: "text", id: `units-${name}`, placeholder: `e.g. ${example}`, value: given[name] || "" });
      return [name, input, element("div", { class: "field" }, element("label", { for: `units-${name}` }, text), input)];
    });
    const again = element("button", { type: "button" }, "Measure again");
    again.addEventListener("click", () => this.open(file, Object.fromEntries(fields.map(([name, input]) => [name, input.value.trim()]).filter((pair) => pair[1]))));
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
    if (measured.no_power_law !== undefined) {
      this.show(found.name, [table("Measured surface", ["number", "value", ""], heights), element("p", { class: "fail" }, `No D and G: ${measured.no_power_law}. 'asperity surface measure --json' and 'asperity joint --surface' make a joint of its spectrum.`), ...notes.map((text) => element("p", { class: "note" }, text)), this.units(file, units)]);
      this.take.say("The surface has no power law; see the message.");
      return;
    }
    const interval = (pair, factor = 1) => `${number(pair[0] * factor)} to ${number(pair[1] * factor)}`;
    const rows = [
      ["fractal dimension D", number(measured.fractal_dimension), interval(measured.fractal_dimension_interval_95)],
      ["fractal roughness G, nm", number(1e9 * measured.fractal_roughness_m), interval(measured.fractal_roughness_interval_95_m, 1e9)],
      ...heights,
    ];
    const band = `Self-affine from ${number(1e6 * measured.shortest_wavelength_m, 3)} to ${number(1e6 * measured.longest_wavelength_m, 3)} µm; estimator ${measured.estimator}, ${measured.profiles} profile${measured.profiles === 1 ? "" : "s"}. D and G belong together: their errors are almost fully correlated.`;
    const use = element("button", { type: "button", id: "use-surface" }, "Put into the joint, at every contact");
    use.addEventListener("click", () => {
      this.take.surface(found.changes);
      this.panel.hidden = true;
    });
    const save = element("a", { class: "button", download: `${found.name}.json`, href: URL.createObjectURL(new Blob([JSON.stringify(measured, null, 2)], { type: "application/json" })) }, "Save measurement");
    this.show(found.name, [
      table("Measured surface", ["number", "value", "95 % interval"], rows),
      element("p", { class: "note" }, band),
      ...notes.map((text) => element("p", { class: "note" }, text)),
      element("p", { class: "note" }, "The joint needs the roughness of both bodies together. This takes the measured one for it; two measurements are combined by 'asperity surface combine'. D and G go to the published contact law, which is 2 to 22 times too soft on measured surfaces; 'asperity joint --surface' takes the measured spectrum."),
      use,
      " ",
      save,
      " ",
    ]);
    this.take.say(`Measured: D ${number(measured.fractal_dimension)}, G ${number(1e9 * measured.fractal_roughness_m)} nm.`);
    use.focus();
  }
}
