// The results of one joint beside those of a pinned baseline: its views, drawing and curves.

import { elements, keyFigures, marginsTable, pairs } from "/blocks.js";
import { curves, heatCurve } from "/curves.js";
import { driveDrawing, freeBodies } from "/drawing.js";
import { showHeadline } from "/headline.js";
import { element } from "/numbers.js";
import { fill, fitTables } from "/panels.js";

const get = (id) => document.getElementById(id);

/** What each panel shows of an answer, by its place on the page; with what the baseline has there. */
const PANELS = {
  overview: ({ views }, baseline) => keyFigures(views.cards[0], baseline?.views.cards[0]),
  drawing: ({ drawing, document: found }) => driveDrawing(drawing, found),
  warnings: ({ views }) => elements(views.warnings),
  margins: ({ views }) => marginsTable(views.margins),
  levels: ({ views }, baseline) => elements(views.levels, { before: baseline?.views.levels, panel: "Torsional stiffness", fold: true }),
  budget: ({ views }) => elements(views.budget, { panel: "Compliance of the assembled joint, by spring", fold: true }),
  plots: curves,
  numbers: ({ views }) => pairs(views.numbers[0]),
  bodies: ({ drawing }) => freeBodies(drawing),
  contacts: ({ views }) => elements(views.contacts),
  heat: ({ views, document: found }, baseline) => [...elements(views.heat), element("div", { class: "plots" }, ...heatCurve(found, baseline?.document))],
  assumptions: ({ views }) => elements(views.assumptions),
};

export function showAnswer(answer, baseline) {
  showHeadline(answer, baseline);
  get("forces").hidden = !answer.drawing.bodies.length;
  get("forces").classList.toggle("several", answer.drawing.bodies.length > 2);
  get("heat-panel").hidden = !answer.document.heat;
  get("warned").classList.toggle("none", !answer.views.warnings[0].items);
  for (const [name, make] of Object.entries(PANELS)) fill(get(name), () => make(answer, baseline));
  fitTables();
}
