// The results of one joint beside those of a pinned baseline: cards, tables, margins, warnings, plots.

import { curves, driven, standing } from "/curves.js";
import { driveDrawing, freeBodies } from "/drawing.js";
import { arcmin, element, number, orInfinite, scaled, table, unitText } from "/numbers.js";

const LEVELS = [
  ["assembly", "assembled", "asperities, bodies, rollers free to move, structure"],
  ["series_with_bulk", "bodies in series", "asperities and bodies; roller centres held"],
  ["published", "asperities alone", "the level of Zou et al. 2025: an upper bound"],
];
const SEVERITIES = { function: "Fails", damage: "Damage", accuracy: "Outside the model's range", state: "State" };
const SPRINGS = {
  tangential: "contacts, tangential",
  normal: "contacts, normal (rollers free to move)",
  ring_bending: "ring, bending",
  pin: "carrier pins",
  planet_support: "planet supports",
  input_shaft: "input shaft",
  output_shaft: "output shaft",
};

const NO_SHARE = 1e-12; // of the compliance: what is less is only the rounding of the others

/** Text for screen readers alone. */
const hidden = (text) => element("span", { class: "visually-hidden" }, text);

const get = (id) => document.getElementById(id);

export function showAnswer(answer, baseline) {
  const found = answer.document;
  const before = baseline ? baseline.document : null;
  get("verdict").textContent = verdictWords(found.verdict);
  cards(found, before);
  get("drawing").replaceChildren(...driveDrawing(answer.drawing, found));
  const bodies = freeBodies(answer.drawing);
  get("forces").hidden = !bodies.length;
  get("forces").classList.toggle("several", bodies.length > 0 && answer.drawing.bodies.length > 1);
  get("bodies").replaceChildren(...bodies);
  get("levels").replaceChildren(levels(found, before), ...clearance(found), ...lawRange(found), drift(found), ...laws(found), ...interval(found));
  get("budget").replaceChildren(budget(found));
  get("numbers").replaceChildren(...numbers(found, answer.drawing.made_interference_m));
  get("margins").replaceChildren(margins(answer));
  get("warnings").replaceChildren(...branchNote(found), warnings(found));
  get("plots").replaceChildren(...curves(answer, baseline));
  get("contacts").replaceChildren(contacts(found), ...surfaces(found), roughness(found), ...branches(found));
  get("assumptions").replaceChildren(...found.assumptions.map((text) => element("li", {}, text)));
}

/** Whether the joint works, what fails, and the tightest margin of what is met. */
function verdictWords({ title, words, nearest }) {
  return `${title}: ${words}${nearest ? ` Tightest margin: ${nearest.words}.` : ""}`;
}

function change(now, before) {
  if (before === null || before === undefined || now === null || now === undefined || before === 0) return null;
  const share = 100 * (now / before - 1);
  const text = Math.abs(share) < 0.005 ? "as the baseline" : `${share > 0 ? "+" : "−"}${number(Math.abs(share), 3)} % against the baseline`;
  return element("p", { class: "change" }, text);
}

function card(name, value, unit, detail, difference) {
  return element(
    "div",
    { class: "card" },
    element("h2", {}, name),
    element("p", { class: "value" }, element("span", { "data-value": name }, value), " ", element("span", { class: "unit" }, unit)),
    element("p", { class: "detail" }, detail),
    difference,
  );
}

/** One of both directions: that of the torque. */
const inItsDirection = (found, both) => (found.standing.forces.output_torque_Nm < 0 ? both.reverse : both);

/** Torque capacity of a joint, and in words what limits it, and where the joint that stands slips. */
function capacityWords(found) {
  const capacity = inItsDirection(found, found.torque_capacity);
  const standing = inItsDirection(found, found.standing_torque_capacity).output_torque_Nm;
  if (standing === null || standing === capacity.output_torque_Nm) return [capacity.output_torque_Nm, capacity.meaning];
  return [capacity.output_torque_Nm, `${capacity.meaning}; passes up to ${number(standing)} N·m standing`];
}

/** Words for the stiffness of the assembled joint, with what bounds it. */
const bounded = (words, found) => (found.stiffness_bound ? `${words} (${found.stiffness_bound})` : words);

function cards(found, before) {
  const stiffness = found.torsional_stiffness.assembly;
  const was = before && before.torsional_stiffness.assembly;
  const [capacity, slips] = capacityWords(found);
  const per = arcmin(found.drift_rad_per_output_turn);
  const unknown = found.stiffness_unknown_because;
  const [hours, turns] = [found.life_hours, found.rolling.life_output_turns];
  const life = hours !== null ? `life ${number(hours)} h` : turns !== null ? `life ${number(turns)} output turns` : "no life";
  get("cards").replaceChildren(
    card(
      "Stiffness at the output",
      number(stiffness.output_Nm_per_arcmin),
      "N·m/arcmin",
      unknown || bounded(`assembled joint, ${driven(found)} locked; ${number(stiffness.output_Nm_per_rad)} N·m/rad`, found),
      change(stiffness.output_Nm_per_rad, was && was.output_Nm_per_rad),
    ),
    card(
      "Drift per output turn",
      number(per),
      "arcmin",
      per === null ? standing(found) : "lost when it turns under the torque; does not come back",
      change(found.drift_rad_per_output_turn, before && before.drift_rad_per_output_turn),
    ),
    card(
      "Torque capacity",
      number(capacity),
      "N·m",
      `${slips}; load ${number(found.standing.forces.output_torque_Nm)} N·m`,
      change(capacity, before && capacityWords(before)[0]),
    ),
    card(
      "Efficiency",
      number(scaled(found.efficiency, 100), 4),
      "%",
      `${found.efficiency === null ? `${standing(found).split(":")[0]}: no efficiency; ` : ""}${life} at ${number(100 * found.rolling.reliability)} % reliability`,
      change(found.efficiency, before && before.efficiency),
    ),
  );
}

function levels(found, before) {
  const rows = LEVELS.map(([key, name, words]) => {
    const level = found.torsional_stiffness[key];
    const cells = [number(level.output_Nm_per_arcmin), number(level.output_Nm_per_rad)];
    cells.push(before ? number(before.torsional_stiffness[key].output_Nm_per_arcmin) : number(level.input_Nm_per_rad));
    const said = key === "assembly" ? bounded(words, found) : words;
    return [element("span", {}, name, element("small", {}, said)), ...cells];
  });
  const last = before ? "baseline, N·m/arcmin" : `at the ${driven(found)}, N·m/rad`;
  const headings = ["level of the model", "N·m/arcmin", "N·m/rad", last];
  return element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Stiffness, scrollable" }, table("Torsional stiffness on three levels", headings, rows));
}

/** From what to what the stiffness reaches over a clearance of the pins that the file does not state. */
const clearance = (found) =>
  found.pin_clearance_interval ? [element("p", { class: "note" }, `${found.pin_clearance_interval.words}.`)] : [];

/** Where the published contact law is outside its range, which concerns the level of the asperities alone. */
function lawRange(found) {
  const crossed = found.diagnostics.filter((entry) => !entry.ok && entry.severity === "model");
  if (!crossed.length) return [];
  const labels = [...new Set(crossed.map((entry) => entry.label))].map((label) => {
    const entries = crossed.filter((entry) => entry.label === label);
    const worst = entries.find((entry) => entry.infinite) ?? entries.reduce((one, other) => (other.value > one.value ? other : one));
    return `${label} ${worst.infinite ? "infinite" : `up to ${worst.shown}`}`;
  });
  return [element("p", { class: "note" }, `Asperities alone: outside the range of this law, ${labels.join(", ")}; ${crossed[0].remedy}.`)];
}

function drift(found) {
  const per = arcmin(found.drift_rad_per_output_turn);
  const said =
    per === null
      ? `Drift: ${standing(found)}.`
      : `Beside every stiffness: the output drifts by ${number(per)} arcmin in each turn under this torque. The wind-up comes back, the drift does not.`;
  return element("p", { class: "note strong" }, said);
}

/** Stiffness and drift by every contact law that the surfaces allow. */
function laws(found) {
  if (!found.contact_laws) return [];
  const rows = found.contact_laws.map((each) => [
    element("span", {}, each.law, element("small", {}, each.used ? "used here" : "")),
    number(scaled(each.assembly_Nm_per_rad, 1 / arcmin(1))),
    number(arcmin(each.drift_rad_per_output_turn)),
    each.over_boundary_elements.map((end) => number(end)).join("–"),
  ]);
  const title = "Contact laws side by side";
  const headings = ["law", "assembled, N·m/arcmin", "drift per turn, arcmin", "over boundary elements"];
  const words = "Last column: how stiff a contact is by this law, over boundary elements on measured surfaces.";
  return [
    element("h3", {}, title),
    element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": `${title}, scrollable` }, table(title, headings, rows)),
    element("p", { class: "note" }, words),
  ];
}

/** From what to what stiffness and drift reach over what a file leaves open of its surfaces. */
function interval(found) {
  const ends = found.stiffness_interval;
  if (!ends) return [];
  const rows = LEVELS.map(([key, name]) => [name, ...[ends[key].low_Nm_per_rad, ends[key].high_Nm_per_rad].map((each) => number(scaled(each, 1 / arcmin(1))))]);
  const [low, high] = [ends.drift.low_rad_per_output_turn, ends.drift.high_rad_per_output_turn].map((each) => number(arcmin(each)));
  return [
    element("h3", {}, ends.title),
    table(ends.title, ["level of the model", "from, N·m/arcmin", "to, N·m/arcmin"], rows),
    element("p", { class: "note" }, `Drift from ${low} to ${high} arcmin per output turn.`),
    element("p", { class: "note" }, ends.words),
  ];
}

/** What a designer asks of a joint besides its stiffness, and the forces of its rollers on their pins. */
function numbers(found, made) {
  const { geometry, preload, rolling, standing: { forces } } = found;
  const torque = rolling.input_torque_Nm ?? forces.input_torque_Nm;
  const rows = [
    [`speed ratio, ${geometry.input} over ${geometry.output}`, number(geometry.speed_ratio), ""],
    ["rolling parts, mass", number(found.mass_kg), "kg"],
    ["outside diameter", number(scaled(found.envelope_diameter_m, 1e3)), "mm"],
    ["preload of the first contact", number(preload.force_N), "N"],
    ["interference", number(scaled(preload.interference_m, 1e6)), "µm"],
    ["interference to be made", number(scaled(made, 1e6)), "µm"],
    [`torque at the input, ${rolling.input_torque_Nm === null ? "standing" : "rolling"}`, number(torque), "N·m"],
    ...Object.entries(forces.pin_N).map(([name, { radial, tangential }]) => [`${name.replaceAll("_", " ")} on its pin, standing`, number(Math.hypot(radial, tangential)), "N"]),
  ];
  const of = table("The joint in numbers", ["quantity", "value", "unit"], rows);
  return [of, element("p", { class: "note" }, "Bearings, shafts and housing, and what mounts the rings: asperity loads.")];
}

/** Temperatures and oil film of the contacts in rolling, where the file has the numbers for them. */
function surfaces(found) {
  const entries = Object.entries(found.rolling.contacts);
  const columns = [
    ["flash temperature, K", "flash_temperature_K", 1],
    ["thinnest film, µm", "film_thickness_m", 1e6],
    ["film over roughness λ", "film_ratio", 1],
    ["drag of the oil, N", "oil_drag_N", 1],
    ["loss, W", "total", 1],
  ];
  const value = (each, key) => (key === "total" ? each.losses_W.total : each[key]);
  const known = columns.filter(([, key]) => entries.some((entry) => value(entry[1], key)));
  if (!known.length) return [];
  const rows = entries.map(([name, each]) => [name, ...known.map(([, key, factor]) => number(scaled(value(each, key), factor)))]);
  const title = "Contacts in rolling: temperature, film, losses";
  return [element("h3", {}, title), table(title, ["contact", ...known.map(([heading]) => heading)], rows)];
}

function bar(share, kind = "") {
  const inner = element("span", { class: `fill ${kind}` });
  inner.style.width = `${Math.min(Math.max(share, 0), 1) * 100}%`;
  return element("span", { class: "bar-track", "aria-hidden": "true" }, inner);
}

function budget(found) {
  const shares = Object.entries(found.stiffness_budget).map(([key, share]) => {
    const parts = typeof share === "object" && share !== null ? Object.values(share) : [share];
    const total = parts.includes(null) ? null : parts.reduce((sum, part) => sum + part, 0);
    return [SPRINGS[key.replace("_share", "")] || key, total, share];
  });
  const rows = shares
    .filter((each) => Math.abs(each[1]) > NO_SHARE)
    .sort((one, other) => other[1] - one[1])
    .map(([name, total, share]) => {
      const each = typeof share === "object" ? Object.entries(share).sort((a, b) => b[1] - a[1]) : [];
      const detail = each.filter((pair) => Math.abs(pair[1]) >= 0.001).map(([contact, part]) => `${contact} ${number(100 * part, 3)} %`).join(", ");
      return [element("span", {}, name, element("small", {}, detail)), `${number(100 * total, 3)} %`, bar(total)];
    });
  if (!rows.length) return element("p", { class: "note" }, "No compliance: the joint has no stiffness here.");
  const shown = table("Shares of the springs in the compliance", ["spring", "share", hidden("bar")], rows);
  const parts = Object.values(found.stiffness_budget).flatMap((share) => (share !== null && typeof share === "object" ? Object.values(share) : [share]));
  if (!parts.some((part) => part < -NO_SHARE)) return shown;
  const words =
    "A negative share: the other forces on its bodies deflect this spring against its own force; the shares add up to 100 %.";
  return element("div", {}, shown, element("p", { class: "note" }, words));
}

/** The limits of function, damage and accuracy, the one that is used most on top; residuals are no margins. */
export function margins(answer) {
  const judged = answer.margins.filter((each) => ["function", "damage", "accuracy", "state"].includes(each.severity) && !each.name.endsWith("_residual"));
  const rank = (each) => (each.ok ? each.used ?? 0 : each.state ? 1e9 : each.known ? Infinity : 2e9);
  const rows = judged
    .sort((one, other) => rank(other) - rank(one))
    .map((each) => {
      const unit = unitText(each.unit);
      const bounds = [
        [each.lowest, each.inclusive ? "≥" : ">"],
        [each.highest, each.inclusive ? "≤" : "<"],
      ].filter(([bound]) => bound !== null);
      const required = (each.state ? [] : bounds).map(([bound, word]) => element("span", {}, `${word} ${number(bound)}${unit && ` ${unit}`}`));
      return [
        element("span", {}, each.label, element("small", {}, each.place ? `at ${each.place}` : "")),
        `${orInfinite(each.infinite, each.actual)}${unit && !each.infinite ? ` ${unit}` : ""}`,
        element("span", { class: "bounds" }, ...required),
        each.used === null || each.state || !each.known ? "" : bar(each.used, each.ok ? "good" : "bad"),
        each.state || !each.known ? element("span", { class: "state" }, each.state || "? unknown") : verdict(each.ok),
      ];
    });
  return table("Safety margins", ["limit", "actual", "required", hidden("used share of the limit"), "result"], rows);
}

function verdict(ok) {
  return element("span", { class: ok ? "pass" : "fail" }, ok ? "✓ pass" : "✗ fail");
}

function branchNote(found) {
  return found.branches ? [element("p", { class: "note" }, found.branches.note)] : [];
}

function branches(found) {
  if (!found.branches) return [];
  const { branch_is: noun, branches: each, standing, rolling } = found.branches;
  const of = (state, name, index, factor) => number(state && state[name][index] !== null ? factor * state[name][index] : null, 3);
  const rows = each.map((branch, index) => [
    `${noun} ${index + 1}`,
    number(1e6 * branch.interference_m),
    number(branch.preload_N),
    of(standing, "share", index, 100),
    of(rolling, "share", index, 100),
    of(standing, "slip_ratio", index, 1),
    of(rolling, "slip_ratio", index, 1),
  ]);
  const headings = ["branch", "interference, µm", "preload, N", "share standing, %", "share rolling, %", "slip standing", "slip rolling"];
  const title = "Branches by their own sizes";
  return [element("div", {}, element("h3", {}, title), table(title, headings, rows))];
}

/** The limits that a joint crosses, most serious first. */
export function warnings(found) {
  const grouped = new Map();
  for (const each of found.diagnostics.filter((one) => !one.ok && one.severity !== "model")) {
    const key = `${each.name}|${each.meaning}`;
    if (!grouped.has(key)) grouped.set(key, { ...each, contacts: [] });
    const kept = grouped.get(key);
    if (each.contact) kept.contacts.push(each.contact);
    if (each.infinite) kept.shown = each.shown;
    if (each.value !== null && kept.value !== null && Math.abs(each.value - each.limit) > Math.abs(kept.value - kept.limit)) [kept.value, kept.shown] = [each.value, each.shown];
  }
  if (!grouped.size) return element("p", { class: "note" }, "None: all limits are met.");
  const order = Object.keys(SEVERITIES);
  const sorted = [...grouped.values()].sort((one, other) => order.indexOf(one.severity) - order.indexOf(other.severity));
  return element(
    "ul",
    { class: "warnings" },
    ...sorted.map((each) =>
      element(
        "li",
        { class: each.severity },
        element("strong", {}, `${each.known ? SEVERITIES[each.severity] : "Not checked"}: `),
        `${each.meaning} `,
        element(
          "span",
          { class: "how-much" },
          `(${each.label} ${each.shown}, ${each.state || `limit ${each.limit_shown}`}${each.contacts.length ? `; ${each.contacts.join(", ")}` : ""})`,
        ),
        each.remedy ? element("p", { class: "remedy" }, `What to do: ${each.remedy}.`) : "",
      ),
    ),
  );
}

function contacts(found) {
  const ratio = Object.fromEntries(found.diagnostics.filter((each) => each.name === "slip_ratio").map((each) => [each.contact, each.value]));
  const headings = ["contact", "normal, N", "tangential, N", "slip T/(μ·N)", "Hertz pressure, MPa", "Hertz width, µm", "K_t asperities, N/µm", "K_t bodies, N/µm", "creepage, %"];
  return table(
    "Contacts",
    headings,
    Object.entries(found.standing.contacts).map(([name, each]) => {
      return [
        name,
        number(found.standing.forces.normal_N[name]),
        number(found.standing.forces.tangential_N[name]),
        number(ratio[name], 3),
        number(scaled(each.hertz_pressure_Pa, 1e-6)),
        number(scaled(each.hertz_half_width_m, 2e6)),
        number(scaled(each.asperity_tangential_stiffness_N_per_m, 1e-6)),
        number(scaled(each.bulk_tangential_stiffness_N_per_m, 1e-6)),
        number(scaled(found.rolling.contacts[name].creepage, 100), 3),
      ];
    }),
  );
}

/** Which Ra of two like bodies the D and G of the surfaces mean. */
function roughness(found) {
  if (!found.surfaces.length) return "";
  const micro = (value) => number(scaled(value, 1e6), 3);
  const all = Object.keys(found.standing.contacts).length;
  const rows = found.surfaces.map((each) => [
    each.contacts.length === all ? "all contacts" : each.contacts.join(", "),
    number(each.fractal_dimension),
    number(scaled(each.fractal_roughness_m, 1e3), 3),
    number(scaled(each.cut_off_m, 1e3), 3),
    micro(each.roughness_average_m),
    `${micro(each.roughness_average_low_m)} to ${micro(each.roughness_average_high_m)}`,
  ]);
  const title = "Ra to which D and G correspond, on each of two like bodies";
  return element("div", {}, element("h3", {}, title), table(title, ["contacts", "D", "G, mm", "cut-off, mm", "Ra, µm", "95 % of measurements, µm"], rows));
}
