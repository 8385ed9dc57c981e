// The drive to scale, with the contact forces of its first branch.

import { element, number, svg } from "/numbers.js";

const LONGEST_WALL = 0.35; // of the inner radius; a thicker wall is broken off
const LONGEST_ARROW = 0.24; // of the inner radius

export function driveDrawing(drawing, document_) {
  const inner = 1e3 * drawing.ring.inner_radius_m;
  const wall = 1e3 * drawing.ring.wall_m;
  const shown = Math.min(wall, LONGEST_WALL * inner);
  const outer = inner + shown;
  const half = outer * 1.04;
  const picture = svg("svg", {
    viewBox: `${-half} ${-half} ${2 * half} ${2 * half * 1.07}`,
    role: "img",
    class: "drive",
    "aria-label": described(drawing, document_, wall),
  });
  const marker = (name) =>
    svg(
      "marker",
      { id: `head-${name}`, viewBox: "0 0 10 10", refX: 9, refY: 5, markerWidth: 4.2, markerHeight: 4.2, orient: "auto-start-reverse" },
      svg("path", { d: "M0,0L10,5L0,10z", class: `head ${name}` }),
    );
  picture.append(svg("defs", {}, marker("normal"), marker("tangential")));
  picture.append(
    svg("circle", { class: shown < wall ? "ring broken" : "ring", r: outer }),
    svg("circle", { class: "bore", r: inner }),
  );
  for (const roller of drawing.rollers) {
    const [x, y] = [1e3 * roller.x_m, -1e3 * roller.y_m];
    picture.append(
      svg("circle", { class: `roller ${roller.body.split(" ").pop()} ${roller.body.split(" ")[0]}`, cx: x, cy: y, r: 1e3 * roller.radius_m }),
      svg("path", { class: "axis-mark", d: `M${x - 1.2},${y}h2.4M${x},${y - 1.2}v2.4` }),
    );
  }
  const largest = Math.max(...drawing.forces.map((force) => Math.hypot(...force.normal_N)), 1e-300);
  const length = (LONGEST_ARROW * inner) / largest;
  const font = 0.062 * inner;
  for (const force of drawing.forces) {
    const [x, y] = [1e3 * force.x_m, -1e3 * force.y_m];
    const arrow = (vector, name) => {
      const [dx, dy] = [vector[0] * length, -vector[1] * length];
      if (Math.hypot(dx, dy) < 0.004 * inner) return;
      // normal forces end at the contact, tangential ones begin there
      const [start, end] = name === "normal" ? [[x - dx, y - dy], [x, y]] : [[x, y], [x + dx, y + dy]];
      picture.append(
        svg("line", { class: `force ${name}`, x1: start[0], y1: start[1], x2: end[0], y2: end[1], "marker-end": `url(#head-${name})` }),
      );
    };
    arrow(force.normal_N, "normal");
    arrow(force.tangential_N, "tangential");
    const tail = [x - force.normal_N[0] * length, y + force.normal_N[1] * length];
    const away = Math.hypot(tail[0] - x, tail[1] - y) || 1;
    const place = [tail[0] + ((tail[0] - x) / away) * font * 0.8, tail[1] + ((tail[1] - y) / away) * font * 0.8];
    picture.append(
      svg("text", { class: "force-name", x: place[0], y: place[1] + font * 0.35, "font-size": font, "text-anchor": "middle" }, force.contact),
    );
  }
  const bar = [50, 20, 10, 5, 2, 1, 0.5, 0.2, 0.1, 100, 200, 500].find((size) => size <= 0.5 * inner) || inner;
  const level = half * 1.06;
  picture.append(
    svg("path", { class: "scale", d: `M${-half * 0.97},${level - 1}v1h${bar}v-1` }),
    svg("text", { class: "scale-text", x: -half * 0.97 + bar + font * 0.4, y: level, "font-size": font }, `${number(bar)} mm`),
  );
  const note = shown < wall ? `The ring's wall of ${number(wall)} mm is drawn thinner (dashed edge).` : `Ring wall ${number(wall)} mm.`;
  return [
    picture,
    element(
      "p",
      { class: "note" },
      element("span", { class: "key normal" }, "→ normal"),
      " and ",
      element("span", { class: "key tangential" }, "→ tangential"),
      ` forces on the planet and on the loading rollers of one branch, to one scale (longest: ${number(largest)} N). ${note}`,
    ),
  ];
}

function described(drawing, document_, wall) {
  const size = (body) => number(1e3 * drawing.rollers.find((roller) => roller.body === body).radius_m);
  const planets = drawing.rollers.filter((roller) => roller.body === "planet").length;
  const normal = Object.entries(document_.forces.normal_N).map(([name, force]) => `${name} ${number(force)} N`);
  return (
    `Drive to scale: sun radius ${size("sun")} mm, ${planets} planets of ${size("planet")} mm, loading rollers of ` +
    `${size("right loading roller")} mm in a ring of ${number(1e3 * drawing.ring.inner_radius_m)} mm, wall ` +
    `${number(wall)} mm. Normal forces: ${normal.join(", ")}.`
  );
}
