// A number of the form with its unit: taken apart, and written in another unit of the server's table.

import { element, number, unitText } from "/numbers.js";

const SAME = 5e-13; // relative difference up to which a converted number is the same
const QUANTITY = /^\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?)(?![\d.]|\s*\/)\s*([^±+,]*?)\s*((?:[±+,].*)?)$/i;

/** Number, unit, and what follows them, such as a tolerance; null where the text does not begin with a number. */
function parts(text) {
  const found = text.match(QUANTITY);
  return found ? { written: found[1], unit: found[2], rest: found[3] } : null;
}

/** A text as it is; of a number alone with the unit of another text, or with another text that is a unit. */
export function withUnit(text, other) {
  const typed = parts(text);
  const { unit } = parts(other) || { unit: other.trim() };
  return typed && unit && !typed.unit && !typed.rest ? `${typed.written} ${unit}` : text;
}

/** A unit as the table of the server spells it. */
function spelled(unit) {
  const plain = unit.replace(/[·⋅×∙]/g, "*").replace(/[µμ]/g, "u").replaceAll("²", "^2").replaceAll("³", "^3");
  const joined = plain.replace(/\barc\s*[-.]?\s*(?=min|sec)/g, "arc");
  const [top, ...below] = joined.split("/"); // below a stroke a hyphen binds closer than the table's spelling
  const products = [top.replace(/([a-z])\s*\.?[-.]\s*(?=[a-z])/gi, "$1*"), ...below].join("/");
  return products.replace(/\s*([*/])\s*/g, "$1").replace(/\s+/g, "*");
}

/** The shortest number that is the same; with a number of digits rounded to those. */
function shortest(value, size, digits) {
  if (digits) return number(value, digits);
  for (let few = 1; few < 15; few += 1) {
    const short = number(value, few);
    if (Math.abs(Number(short) - value) <= SAME * size) return short;
  }
  return number(value, 15);
}

export class UnitPicker {
  /** The list of the units of a field; `units` are those of the table: name, how many make an SI unit, and where they begin. */
  constructor(id, name, units, first) {
    this.units = units;
    this.other = element("option", { value: "", hidden: true }); // one that the table has in another spelling, or not at all
    const options = units.map(({ unit }) => element("option", { value: unit }, unitText(unit)));
    this.select = element("select", { id: `${id}-unit`, "aria-label": `${name}, unit` }, this.other, ...options);
    this.node = element("span", { class: "unit-list", title: "Unit" }, this.select);
    this.select.value = first;
  }

  known(unit) {
    return this.units.find((each) => each.unit === spelled(unit));
  }

  /** Choose the unit that a text has; an empty one leaves the list as it is. */
  follow(text) {
    const typed = parts(text);
    if (!typed || !typed.unit) return;
    const known = this.known(typed.unit);
    this.other.hidden = Boolean(known);
    this.other.textContent = known ? "" : typed.unit;
    this.select.value = known ? known.unit : "";
  }

  /** A text in the chosen unit, its tolerance as it stands; `si` is its value where the table lacks its unit. Null if neither is known. */
  converted(text, si = null, digits = 0) {
    const typed = parts(text);
    const wanted = this.known(this.select.value);
    if (!typed || !wanted) return null;
    const old = this.known(typed.unit);
    if (old === wanted && !digits) return text;
    const inSi = old ? old.zero + Number(typed.written) / old.per_si : si;
    if (inSi === null) return null;
    const size = Math.max(Math.abs(inSi), Math.abs(wanted.zero)) * wanted.per_si;
    return `${shortest((inSi - wanted.zero) * wanted.per_si, size, digits)} ${wanted.unit} ${typed.rest}`.trimEnd();
  }

  /** A number in the chosen unit instead of one that is none of this kind. */
  renamed(text) {
    const typed = parts(text);
    return typed && this.select.value ? `${typed.written} ${this.select.value} ${typed.rest}`.trimEnd() : null;
  }
}
