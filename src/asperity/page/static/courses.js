// Curves of a study over time or over a turn, of its own document: wear over the years.

import { arcmin, element, number, scaled } from "/numbers.js";
import { linePlot } from "/plots.js";

const CAPACITY = "torque_capacity_Nm"; // computed at some points of the course alone
const same = (curve) => curve;

/** Curves beside each other. */
const plots = (...drawn) => (drawn.length ? [element("div", { class: "plots" }, ...drawn)] : []);

/** Interference, preload, torque of the first slide and drift over time; nothing where the preload stays. */
export function wearCurves({ wear: found }, before) {
  if (found.keeps_force) return plots();
  const known = found.hours !== null;
  const time = (from) => (known ? from.hours : from.kt_s_per_Pa);
  const earlier = before && !before.wear.keeps_force && time(before.wear) ? before.wear : null;
  const torques = [...new Set(found.loads.map((load) => Math.abs(load.output_torque_Nm)))];
  const last = time(found)[time(found).length - 1];
  const over = (title, y, name, key, factor = 1, more = []) =>
    linePlot({
      title,
      x: known ? "time, h" : "wear coefficient times time, s/Pa",
      y,
      zero: true,
      empty: "not known: with skew or oil the joint in which one contact slides is not computed",
      limit: known && found.life_hours ? { x: found.life_hours, name: "required life" } : null,
      series: [...(earlier ? [{ name: "baseline", kind: "one", ghost: true, ...values(earlier, key, factor) }] : []), { name, kind: "one", ...values(found, key, factor) }, ...more],
    });
  const values = (from, key, factor) => (key === CAPACITY ? without : same)({ x: time(from), y: from[key].map((value) => scaled(value, factor)) });
  const slides = found[CAPACITY].some((value) => value !== null);
  const levels = { x: torques.flatMap(() => [0, last, last]), y: torques.flatMap((torque) => [torque, torque, null]) };
  const drawn = plots(
    over("Preload", "N", "preload", "preload_N"),
    over("Interference", "µm", "interference", "interference_m", 1e6),
    over("Torque of the first slide", "N·m at the output", "first contact slides", CAPACITY, 1, slides ? [{ name: torques.length > 1 ? "torques of the duty" : "torque of the joint", kind: "two", ...levels }] : []),
    over("Drift", "arcmin per output turn", "by creep", "drift_rad_per_output_turn", arcmin(1), [{ name: "by worn radii", kind: "two", ...values(found, "size_drift_rad_per_output_turn", arcmin(1)) }]),
  );
  return [...drawn, element("p", { class: "note" }, ends(found, known, last))];
}

/** Where the curves end, and a life that lies beyond. */
function ends(found, known, last) {
  const beyond = known && found.life_hours > last ? ` The required life of ${number(found.life_hours)} h lies beyond.` : "";
  return `The curves end ${known ? `after ${number(last)} h` : `at ${number(last)} s/Pa`}: see “How long the joint carries its load”.${beyond}`;
}

/** A curve without the points that have no value. */
function without({ x, y }) {
  const good = y.map((value, i) => [x[i], value]).filter(([, value]) => value !== null);
  return { x: good.map(([at]) => at), y: good.map(([, value]) => value) };
}
