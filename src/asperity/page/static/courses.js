// Curves of a study of its own document: wear over the years, accuracy over a turn.

import { arcmin, element, number, scaled } from "/numbers.js";
import { linePlot } from "/plots.js";

const CAPACITY = "torque_capacity_Nm"; // computed at some points of the course alone
const ARCSEC = 648000 / Math.PI;
const NOTHING = 1e-6; // of the largest transmission error: rounding
const KINDS = ["one", "two", "three", "four", "five"];
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

/** Spectrum of the transmission error, and the transmission error and the input torque over one turn of the output. */
export function accuracyCurves({ accuracy: found, over_turn: turn }, before) {
  const output = turn.output.replaceAll("_", " ");
  const degrees = (of) => of.angle_rad.map((angle) => (angle * 180) / Math.PI);
  const unknown = found.components.some((one) => one.phase_rad === null);
  const over = (title, y, name, key, factor) =>
    linePlot({
      title,
      x: `angle of the ${output}, °`,
      xAt: [0, 60, 120, 180, 240, 300, 360],
      y,
      series: [
        ...(before ? [{ name: "baseline", kind: "one", ghost: true, x: degrees(before.over_turn), y: before.over_turn[key].map((value) => value * factor) }] : []),
        { name, kind: "one", x: degrees(turn), y: turn[key].map((value) => value * factor) },
      ],
      note: unknown ? "Phases that the file does not state are drawn as 0." : "",
    });
  return plots(
    spectrum(found, output),
    over("Transmission error over one turn", "arcsec", "transmission error", "transmission_error_rad", ARCSEC),
    over("Input torque over one turn", "N·m", "input torque", "input_torque_Nm", 1),
    over(`Normal force of ${turn.contact.replaceAll("_", " ")} over one turn`, "N", "of all contacts the one that swings most", "normal_N", 1),
  );
}

/** What each form error adds to the transmission error, over its order. */
function spectrum(found, output) {
  const size = (one) => one.transmission_error_rad * ARCSEC;
  const largest = Math.max(...found.components.map(size));
  const seen = new Set();
  const shown = found.components.filter((one) => {
    const key = [one.part, one.harmonic, size(one).toPrecision(4)].join(" ");
    if (seen.has(key) || !(size(one) > NOTHING * largest)) return false;
    return seen.add(key); // those of the other sectors are alike
  });
  const name = (one) => `${one.part.replaceAll("_", " ")}, ${one.harmonic} ${one.harmonic === 1 ? "wave" : "waves"}: order ${number(one.order)}, ${number(size(one))} arcsec`;
  const parts = [...new Set(shown.map((one) => one.part))];
  return linePlot({
    title: "Transmission error by order",
    x: `order: waves per turn of the ${output}`,
    y: "amplitude of each, arcsec",
    zero: true,
    stems: true,
    empty: "no form error reaches the output",
    series: parts.map((part, i) => {
      const own = shown.filter((one) => one.part === part);
      return { name: part.replaceAll("_", " "), kind: KINDS[i % KINDS.length], x: own.map((one) => one.order), y: own.map(size), names: own.map(name) };
    }),
    note: shown.length ? `Largest: ${name(shown.reduce((one, other) => (size(other) > size(one) ? other : one)))}.` : "",
  });
}
