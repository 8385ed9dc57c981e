// The results of one joint beside those of a pinned baseline: its views, drawing and curves.

import { elements } from "/blocks.js";
import { curves } from "/curves.js";
import { driveDrawing, freeBodies } from "/drawing.js";

/** Panels whose numbers stand beside those of the baseline. */
const COMPARED = ["cards", "levels"];

const get = (id) => document.getElementById(id);

export function showAnswer(answer, baseline) {
  for (const [name, blocks] of Object.entries(answer.views)) {
    const heading = get(name).closest(".panel")?.querySelector("h2")?.textContent;
    get(name).replaceChildren(...elements(blocks, baseline && COMPARED.includes(name) ? baseline.views[name] : [], heading));
  }
  get("drawing").replaceChildren(...driveDrawing(answer.drawing, answer.document));
  const bodies = freeBodies(answer.drawing);
  get("forces").hidden = !bodies.length;
  get("forces").classList.toggle("several", bodies.length > 0 && answer.drawing.bodies.length > 1);
  get("bodies").replaceChildren(...bodies);
  get("plots").replaceChildren(...curves(answer, baseline));
}
