// The drive to scale, with the contact forces of its first sector.

import { element, number, svg } from "/numbers.js";

const LONGEST_WALL = 0.35; // of the inner radius; a thicker wall is broken off
const LONGEST_ARROW = 0.24; // of the inner radius

/** The interference with which rings are made, and the bore of a single one: the drawing shows where all just touch. */
function made(drawing, rings) {
  const less = drawing.made_interference_m;
  if (less === null) return "The interference with which the ring is made is not known.";
  if (!rings.length) return ""; // the parts have no interference
  const said = `Interference ${number(1e6 * less)} µm on the radius`;
  if (rings.length !== 1) return `${said}.`;
  const [ring] = rings;
  const held = 2e3 * (ring.inner_radius_m - less);
  const free = held + 1e3 * ring.bore_change_m;
  const seat = free > held ? `, ⌀${number(held, 7)} mm in its housing` : "";
  return `${said} (made bore ⌀${number(free, 7)} mm${seat}, all just touch in ⌀${number(2e3 * ring.inner_radius_m, 7)} mm).`;
}

/** What the arrows mean, or that there are none. */
function keys(drawing, largest) {
  if (!drawing.forces.length) return ["Without forces, which are not known."];
  return [element("span", { class: "key normal" }, "→ normal"), " and ", element("span", { class: "key tangential" }, "→ tangential"), ` forces up to ${number(largest)} N`];
}

/** A box around points that grows with every one. */
class Box {
  constructor() {
    [this.left, this.top, this.right, this.bottom] = [Infinity, Infinity, -Infinity, -Infinity];
  }

  add(x, y, reach = 0, rise = reach) {
    [this.left, this.right] = [Math.min(this.left, x - reach), Math.max(this.right, x + reach)];
    [this.top, this.bottom] = [Math.min(this.top, y - rise), Math.max(this.bottom, y + rise)];
  }

  view(margin) {
    return [this.left - margin, this.top - margin, this.right - this.left + 2 * margin, this.bottom - this.top + 2 * margin].join(" ");
  }
}

/** Circles of all tracks of a drive, with the contact forces of its first sector, and beside them its section. */
export function driveDrawing(drawing, document_) {
  const rings = drawing.rings.map((ring) => ({ inner: 1e3 * ring.inner_radius_m, wall: 1e3 * ring.wall_m }));
  const shown = rings.map(({ inner, wall }) => ({ inner, wall, outer: inner + Math.min(wall, LONGEST_WALL * inner) }));
  shown.sort((one, other) => other.outer - one.outer);
  const box = new Box();
  for (const { outer } of shown) box.add(0, 0, outer);
  for (const roller of drawing.rollers) box.add(1e3 * roller.x_m, -1e3 * roller.y_m, 1e3 * roller.radius_m);
  const reach = Math.max(box.right - box.left, box.bottom - box.top) / 2;
  const largest = Math.max(...drawing.forces.map((force) => Math.hypot(...force.normal_N)), 1e-300);
  const names = [...new Set([...drawing.rings, ...drawing.rollers].map((each) => each.body))];
  const forces = arrows(drawing, reach, largest, 0.075 * reach, box);
  const picture = svg("svg", { role: "img", class: "drive", "aria-label": `Drive to scale: ${names.join(", ")}. ${forcesDescribed(document_)}` });
  picture.append(svg("defs", {}, marker("normal"), marker("tangential"), marker("pin"))); // also those of the rollers drawn apart
  for (const ring of shown) {
    picture.append(svg("circle", { class: ring.outer < ring.inner + ring.wall ? "ring broken" : "ring", r: ring.outer }), svg("circle", { class: "bore", r: ring.inner }));
  }
  picture.append(...circles(drawing.rollers, reach), ...forces, ...section(drawing.section, reach, box), ...scaleBar(box, reach, 0.075 * reach));
  picture.setAttribute("viewBox", box.view(0.02 * reach));
  const thinner = shown.some((ring) => ring.outer < ring.inner + ring.wall) ? " A thick wall of a ring is drawn thinner (dashed edge)." : "";
  const about = drawing.forces.length ? `${shownSectors(document_)} with the forces on the first body of each contact, to one scale.` : "";
  const interference = made(drawing, drawing.rings);
  return [
    element("div", { class: "drawings" }, picture),
    element("p", { class: "note of-forces" }, ...keys(drawing, largest)),
    element("details", { class: "more" }, element("summary", {}, "About this drawing"), element("p", { class: "note" }, `${about} On the right is the section along the axis, developed through the contacts.${thinner} ${interference}`)),
  ];
}

/** The section along the axis, right of the view and at its height. */
function section(blocks, reach, box) {
  if (!blocks.length) return [];
  const left = box.right + 0.22 * reach;
  const first = Math.min(...blocks.map((block) => block.left_m));
  const outlines = blocks.map((block) => ({ x: left + 1e3 * (block.left_m - first), y: -1e3 * block.high_m, width: 1e3 * (block.right_m - block.left_m), height: 1e3 * (block.high_m - block.low_m), cut: block.cut }));
  const right = Math.max(...outlines.map(({ x, width }) => x + width));
  for (const { x, y, width, height } of outlines) {
    box.add(x, y);
    box.add(x + width, y + height);
  }
  const parts = outlines.map(({ cut, ...place }) => svg("rect", { class: cut ? "ring" : "roller", ...place }));
  const beyond = 0.06 * reach;
  box.add(right + beyond, 0);
  return [...parts, svg("path", { class: "axis-line", d: `M${left - beyond},0H${right + beyond}` })];
}

/** The bodies that are drawn apart, each with the forces on it. */
export function freeBodies(drawing) {
  const held = drawing.bodies.flatMap((body) => body.forces).filter((force) => force.kind === "pin" && Math.hypot(...force.force_N) > 0);
  return [
    element("div", { class: "bodies" }, ...drawing.bodies.map(freeBody)),
    element(
      "p",
      { class: "note" },
      element("span", { class: "key normal" }, "→ normal"),
      held.length ? ", " : " and ",
      element("span", { class: "key tangential" }, "→ tangential"),
      ...(held.length ? [" and ", element("span", { class: "key pin" }, `→ ${held[0].name}`)] : []),
      " forces on each body: arrows show directions, numbers sizes. Centrifugal forces are not drawn.",
    ),
  ];
}

const LETTER = 7.5; // width of a letter of the forces' names, which are bold

/** One roller apart from the others: its tracks, and an arrow with its size for every force on it. */
function freeBody(body) {
  const [width, height, size, arrow] = [320, 226, 42, 30];
  const largest = Math.max(...body.radii_m);
  const parts = [...body.radii_m].sort((one, other) => other - one).map((radius) => svg("circle", { class: "roller", r: (size * radius) / largest }));
  parts.push(svg("path", { class: "axis-mark", d: "M-4,0h8M0,-4v8" }));
  const said = [];
  const taken = [];
  let [left, right, top, bottom] = [-width / 2, width / 2, -height / 2, height / 2]; // grows with the texts
  for (const force of body.forces) {
    const [fx, fy] = force.force_N;
    const total = Math.hypot(fx, fy);
    said.push(`${force.name} ${force.kind === "pin" ? "" : force.kind} ${number(total)} N`);
    if (total === 0) continue;
    const [e, f] = [(arrow * fx) / total, (-arrow * fy) / total];
    const rim = (size * force.radius_m) / largest;
    const [px, py] = [force.place[0], -force.place[1]];
    const [x, y] = [rim * px, rim * py];
    const kind = force.kind === "pin" ? "pin" : force.kind;
    // normal forces end at the rim, tangential ones lie beside it, the pin pushes at the axis
    const beside = force.kind === "tangential" ? 3 : 0;
    const [x1, y1] = force.kind === "normal" ? [x - e, y - f] : [x + beside * px, y + beside * py];
    parts.push(svg("line", { class: `force ${kind}`, x1, y1, x2: x1 + e, y2: y1 + f, "marker-end": `url(#head-${kind})` }));
    const side = Math.abs(px) < 0.35 ? 0 : Math.sign(px);
    const text = force.kind === "tangential" ? `${number(total)} N` : `${force.name} ${number(total)} N`;
    const [tx, wanted] = labelPlace(force.kind, [x1, y1], [e, f], [px, py], side);
    const away = py > 0 ? 12 : -12; // from another text in the same place
    let ty = wanted;
    while (taken.some(([ox, oy]) => Math.abs(ox - tx) < 40 && Math.abs(oy - ty) < 11)) ty += away;
    taken.push([tx, ty]);
    const anchor = { normal: ["end", "middle", "start"][side + 1], tangential: (Math.abs(e) > 5 ? e : px) > 0 ? "start" : "end", pin: "middle" }[kind];
    parts.push(svg("text", { class: "force-name", x: tx, y: ty, "font-size": 11, "text-anchor": anchor }, text));
    const start = tx - { start: 0, middle: 0.5, end: 1 }[anchor] * LETTER * text.length;
    [left, right] = [Math.min(left, start), Math.max(right, start + LETTER * text.length)];
    [top, bottom] = [Math.min(top, ty - 12), Math.max(bottom, ty + 5)];
  }
  const picture = svg(
    "svg",
    { viewBox: `${left} ${top} ${right - left} ${bottom - top}`, role: "img", "aria-label": `Forces on ${body.body}: ${said.join("; ")}.` },
    ...parts,
  );
  return element("figure", {}, picture, element("figcaption", {}, body.body));
}

/** Where the size of a force is written: behind the tail of a normal force, before the tip of a tangential one, beside the axis for a pin, where its arrow does not point. */
function labelPlace(kind, [x, y], [e, f], [px, py], side) {
  if (kind === "pin") return [0, f > 0 ? -12 : 22];
  if (kind === "normal") return side === 0 ? [x, y + (py < 0 ? -4 : 12)] : [x + 3 * side, y + 4];
  const [tx, ty] = [x + 1.12 * e, y + 1.12 * f];
  return [tx, ty + 4 + 5 * py];
}

/** Rollers with the marks of their axes. */
function circles(rollers, size) {
  const mark = 0.03 * size;
  return rollers.flatMap((roller) => {
    const [x, y] = [1e3 * roller.x_m, -1e3 * roller.y_m];
    const kind = `roller ${roller.body.split(" ").pop()} ${roller.body.split(" ")[0]}`;
    return [
      svg("circle", { class: kind, cx: x, cy: y, r: 1e3 * roller.radius_m }),
      svg("path", { class: "axis-mark", d: `M${x - mark},${y}h${2 * mark}M${x},${y - mark}v${2 * mark}` }),
    ];
  });
}

function marker(name) {
  return svg(
    "marker",
    { id: `head-${name}`, viewBox: "0 0 10 10", refX: 9, refY: 5, markerWidth: 5, markerHeight: 5, orient: "auto-start-reverse" },
    svg("path", { d: "M0,0L10,5L0,10z", class: `head ${name}` }),
  );
}

/** A contact force on paper: its place, the arrow of the normal force, and both arrows as lines. */
function arrow(force, factor, shortest) {
  const [x, y] = [1e3 * force.x_m, -1e3 * force.y_m];
  const [nx, ny] = [force.normal_N[0] * factor, -force.normal_N[1] * factor];
  const [tx, ty] = [force.tangential_N[0] * factor, -force.tangential_N[1] * factor];
  // normal forces end at the contact, tangential ones begin there
  const lines = [svg("line", { class: "force normal", x1: x - nx, y1: y - ny, x2: x, y2: y, "marker-end": "url(#head-normal)" })];
  if (Math.hypot(tx, ty) > shortest) {
    lines.push(svg("line", { class: "force tangential", x1: x, y1: y, x2: x + tx, y2: y + ty, "marker-end": "url(#head-tangential)" }));
  }
  return { x, y, nx, ny, lines };
}

/** The forces of a drive with the names of their contacts, for which the box grows. */
function arrows(drawing, size, largest, font, box) {
  const taken = [];
  return drawing.forces.flatMap((force) => {
    const { x, y, nx, ny, lines } = arrow(force, (LONGEST_ARROW * size) / largest, 0.004 * size);
    const length = Math.hypot(nx, ny) || 1;
    const place = { x: x - nx - (1.1 * font * ny) / length, y: y - ny + (1.1 * font * nx) / length + 0.35 * font };
    while (taken.some((other) => Math.abs(other.x - place.x) < 2.2 * font && Math.abs(other.y - place.y) < font)) place.y += font;
    taken.push(place);
    box.add(x - nx, y - ny, 0.02 * size);
    box.add(place.x, place.y - 0.35 * font, 0.32 * font * force.contact.length, 0.55 * font);
    return [...lines, svg("text", { class: "force-name", ...place, "font-size": font, "text-anchor": "middle" }, force.contact)];
  });
}

/** Whose forces the drawing shows: those of a drive that has no sectors, or of which of them. */
function shownSectors(document_) {
  if (document_.geometry.sectors === 1) return "The drive";
  return document_.of_own_branches ? "All sectors" : "One sector";
}

function forcesDescribed(document_) {
  const { normal_N: normal, tangential_N: tangential } = document_.standing.forces;
  const each = Object.keys(normal).map((name) => `${name} ${number(normal[name])} N and ${number(tangential[name])} N`);
  return `${shownSectors(document_)} with normal and tangential forces: ${each.join("; ")}.`;
}

/** A length to compare with, below the view. */
function scaleBar(box, reach, font) {
  const bar = [500, 200, 100, 50, 20, 10, 5, 2, 1, 0.5, 0.2, 0.1].find((size) => size <= 0.6 * reach) || reach;
  const [x, y] = [box.left, box.bottom + 1.1 * font];
  box.add(x, y, 0, 0.1 * font);
  const text = `${number(bar)} mm`;
  return [
    svg("path", { class: "scale", d: `M${x},${y - 0.03 * reach}v${0.03 * reach}h${bar}v${-0.03 * reach}` }),
    svg("text", { class: "scale-text", x: x + bar + font * 0.4, y, "font-size": font }, text),
  ];
}
