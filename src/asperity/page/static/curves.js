// The curves of an answer: stiffness, wind-up, drift, losses, life and creep.

import { arcmin, element, number, scaled } from "/numbers.js";
import { linePlot } from "/plots.js";

/** What drives, in words. */
export const driven = (found) => found.geometry.input.replaceAll("_", " ");

/** Why the joint does not turn, if it does not. */
export const standing = (found) => found.rolling.unknown_because[0] || "";

/** Levels of the stiffness, the fullest model first, as curves. */
const LEVELS = [
  ["assembly_Nm_per_rad", "assembled", "one"],
  ["series_with_bulk_Nm_per_rad", "bodies in series", "two"],
  ["published_Nm_per_rad", "asperities alone", "three"],
];
/** How many times as stiff as the assembled joint a level may be that is drawn with it. */
const BESIDE = 4;
/** Share of the largest torque from which on the efficiency is drawn. */
const WORKING = 0.1;

/** Every curve of an answer as a picture; those without a value in a sentence below them. */
export function curves(answer, baseline) {
  const figures = pictures(answer, baseline);
  const drawn = figures.filter((figure) => !figure.classList.contains("without"));
  const reasons = new Map();
  for (const figure of figures.filter((each) => !drawn.includes(each))) {
    const why = figure.querySelector(".empty").textContent;
    reasons.set(why, [...(reasons.get(why) ?? []), figure.querySelector("figcaption").textContent.toLowerCase()]);
  }
  return [...drawn, ...[...reasons].map(([why, names]) => element("p", { class: "note wide" }, `Not drawn: ${names.join(", ")}. ${why[0].toUpperCase()}${why.slice(1).replace(/\.$/, "")}.`))];
}

/** The torque capacity in the direction of the torque, as a line across a chart; null where it is none. */
function capacityLine(found) {
  const torque = found.standing.forces.output_torque_Nm;
  const { output_torque_Nm: size } = torque < 0 ? found.torque_capacity.reverse : found.torque_capacity;
  return size ? { x: Math.sign(torque || 1) * size, name: "torque capacity" } : null;
}

/** The levels that are drawn beside the assembled joint, and in words those that lie above the chart. */
function levels(sampled, over, perArcmin) {
  const largest = (kind) => Math.max(...sampled[kind].map((value) => value ?? 0));
  const fits = ([kind]) => largest(kind) <= BESIDE * largest(LEVELS[0][0]);
  const above = LEVELS.filter((level) => !fits(level)).map(([kind, name]) => `${name} (${number(largest(kind) * perArcmin, 3)})`);
  return [LEVELS.filter(fits).map(([kind, name, look]) => over(kind, name, look, perArcmin)), above.length ? ` Above this chart: ${above.join(", ")}.` : ""];
}

function pictures(answer, baseline) {
  const { curves: sampled, windup, document: found } = answer;
  const torque = found.standing.forces.output_torque_Nm;
  const ghosts = (kind, factor = 1) =>
    baseline
      ? [{ name: "baseline", kind: "one", ghost: true, x: baseline.curves.torque_Nm, y: baseline.curves[kind].map((value) => scaled(value, factor)) }]
      : [];
  const over = (kind, name, look, factor = 1) => ({ name, kind: look, x: sampled.torque_Nm, y: sampled[kind].map((value) => scaled(value, factor)) });
  const x = "output torque, N·m";
  const limit = capacityLine(found);
  const perArcmin = Math.PI / 10800;
  const toArcmin = 10800 / Math.PI;
  const why = standing(found);
  const loop = windup.unknown_because ? null : windup;
  const before = baseline && !baseline.windup.unknown_because ? baseline.windup : null;
  const [stiffness, above] = levels(sampled, over, perArcmin);
  const angles = (from, key) => from[key].map((value) => scaled(value, toArcmin));
  return [
    linePlot({
      title: "Stiffness over torque",
      x,
      y: "N·m/arcmin at the output",
      zero: true,
      limit,
      series: [...ghosts("assembly_Nm_per_rad", perArcmin), ...stiffness],
      point: { x: torque, y: found.torsional_stiffness.assembly.output_Nm_per_arcmin, name: "this joint" },
      note: `Up to gross slip at standstill.${found.stiffness_bound ? ` Assembled (${found.stiffness_bound}).` : ""}${above}`,
    }),
    linePlot({
      title: `Wind-up, ${driven(found)} locked`,
      x,
      y: "angle, arcmin",
      empty: windup.unknown_because,
      series: loop
        ? [
            ...(before ? [{ name: "baseline", kind: "one", ghost: true, x: before.torque_Nm, y: angles(before, "loading_angle_rad") }] : []),
            { name: "first loading", kind: "one", x: loop.torque_Nm, y: angles(loop, "loading_angle_rad") },
            { name: "unloading", kind: "two", x: loop.torque_Nm, y: angles(loop, "unloading_angle_rad") },
            { name: "reloading", kind: "three", x: loop.torque_Nm, y: angles(loop, "reloading_angle_rad") },
          ]
        : [],
      note: loop
        ? `Hysteresis ${number(scaled(loop.hysteresis_rad, toArcmin), 3)} arcmin, lost motion ${number(scaled(loop.lost_motion_rad, toArcmin), 3)} arcmin.`
        : "",
    }),
    linePlot({
      title: "Wind-up less a straight line",
      x,
      y: "deviation, arcmin",
      empty: windup.unknown_because,
      series: loop
        ? [
            { name: "first loading", kind: "one", x: loop.torque_Nm, y: deviation(loop, "loading_angle_rad", toArcmin) },
            { name: "unloading", kind: "two", x: loop.torque_Nm, y: deviation(loop, "unloading_angle_rad", toArcmin) },
            { name: "reloading", kind: "three", x: loop.torque_Nm, y: deviation(loop, "reloading_angle_rad", toArcmin) },
          ]
        : [],
      note: loop ? "The line joins both ends of the loop, which is too narrow to be seen otherwise." : "",
    }),
    linePlot({
      title: "Drift over torque",
      x,
      limit,
      y: "arcmin per output turn",
      zero: true,
      empty: why,
      series: [...ghosts("drift_rad_per_output_turn", toArcmin), over("drift_rad_per_output_turn", "drift", "one", toArcmin)],
      point: { x: torque, y: arcmin(found.drift_rad_per_output_turn), name: "this joint" },
    }),
    linePlot({
      title: "Efficiency over torque",
      x,
      limit,
      y: "efficiency, %",
      from: WORKING * Math.max(...sampled.torque_Nm.map(Math.abs)),
      note: "From a tenth of the largest torque: without torque there is no efficiency.",
      empty: why,
      series: [...ghosts("efficiency", 100), over("efficiency", "efficiency", "one", 100)],
      point: { x: torque, y: scaled(found.efficiency, 100), name: "this joint" },
    }),
    linePlot({
      title: "Losses over torque",
      x,
      limit,
      y: "power lost, W",
      zero: true,
      empty: why,
      series: [...ghosts("total_loss_W"), over("total_loss_W", "losses that the file describes", "one")],
      point: { x: torque, y: found.losses_W.total, name: "this joint" },
    }),
    life(answer, ghosts, over, x, torque, why, limit),
    creepCurves(answer, why),
    linePlot({
      title: "Friction used, worst contact",
      x,
      limit,
      y: "T/(μ·N)",
      zero: true,
      series: [...ghosts("largest_slip_ratio"), over("largest_slip_ratio", "T/(μ·N); slips at 1", "one")],
    }),
  ];
}

/** Hours at the joint's speed; turns of the output where nothing turns. */
function life(answer, ghosts, over, x, torque, why, limit) {
  const { curves, document: found } = answer;
  const hours = curves.life_hours.some((each) => each !== null);
  const [kind, y, factor] = hours ? ["life_hours", "life, h", 1] : ["life_output_turns", "life, million output turns", 1e-6];
  const here = hours ? found.life_hours : found.rolling.life_output_turns;
  const known = curves[kind].filter((each) => each !== null);
  const log = Math.max(...known) > 10 * Math.min(...known);
  return linePlot({
    title: "Rating life over torque",
    x,
    limit,
    y,
    log,
    zero: !log,
    empty: why || found.rolling.no_life_because,
    series: [...ghosts(kind, factor), over(kind, `${number(100 * found.rolling.reliability)} % reliability`, "one", factor)],
    point: { x: torque, y: scaled(here, factor), name: "this joint" },
    note: log ? "The vertical axis is logarithmic." : "",
  });
}

/** Traction over creepage of each contact up to gross slip, with its working point. */
function creepCurves(answer, why) {
  const rolling = answer.document.rolling.contacts;
  const kinds = ["one", "two", "three", "four", "five"];
  const series = Object.entries(answer.creep).map(([name, curve], i) => ({
    name,
    kind: kinds[i % kinds.length],
    x: curve.creepage.map((each) => scaled(each, 100)),
    y: curve.traction,
    mark: { x: Math.abs(100 * rolling[name].creepage), y: Math.abs(rolling[name].traction_coefficient) },
  }));
  const known = Object.values(rolling).every((each) => each.creepage !== null);
  return linePlot({
    title: "Creep curves of the contacts",
    x: "creepage, %",
    y: "traction T/N",
    zero: true,
    empty: why,
    series: known ? series : [],
    note: "Up to gross slip. A dot is the working point of its contact.",
  });
}

/** Losses over the temperature of the rollers, and what leaves them: they meet where the drive settles. */
export function heatCurve(found, before) {
  const { heat } = found;
  if (!heat) return [];
  const leaving = (at) => (at - heat.ambient_degC) / (heat.resistance_K_per_W + heat.roller_resistance_K_per_W);
  const { roller_temperature_degC: x, loss_W: y } = heat.over_temperature;
  const lost = (from) => ({ x: from.over_temperature.roller_temperature_degC, y: from.over_temperature.loss_W });
  const most = 1.15 * Math.max(...y.map((value) => value ?? 0));
  return [
    linePlot({
      title: "Losses over temperature",
      x: "temperature of rollers and oil, °C",
      y: "W",
      zero: true,
      series: [
        ...(before?.heat ? [{ name: "baseline", kind: "one", ghost: true, ...lost(before.heat) }] : []),
        { name: "losses of the joint", kind: "one", x, y },
        { name: "heat that leaves", kind: "two", x, y: x.map((at) => (leaving(at) <= most ? leaving(at) : null)) },
      ],
      point: heat.steady ? { x: heat.roller_temperature_degC, y: heat.loss_W, name: "settles here" } : undefined,
      note: y.includes(null) ? "The losses end where a contact slips." : "",
    }),
  ];
}

/** The angle less the straight line between both ends of the loop. */
function deviation(loop, key, factor) {
  const torque = loop.torque_Nm;
  const [first, last] = [0, torque.length - 1];
  const ends = loop.loading_angle_rad;
  const slope = (ends[last] - ends[first]) / (torque[last] - torque[first]);
  return loop[key].map((angle, i) => (angle - ends[first] - slope * (torque[i] - torque[first])) * factor);
}
