// Long computations: begin, watch, stop, and show what came out.

import { elements } from "/blocks.js";
import { Composer } from "/compose.js";
import { accuracyCurves, wearCurves } from "/courses.js";
import { element, number } from "/numbers.js";
import { fitTables } from "/panels.js";

const TITLES = { window: "Window of the torque", film: "Oil film", wear: "Wear over the years", accuracy: "Accuracy over a turn", sensitivity: "What matters most", uncertainty: "Uncertainty", design: "Design" };
const UNITS = { window: "steps", film: "temperatures", wear: "", accuracy: "", sensitivity: "", uncertainty: "samples", design: "searches" };
const COMPILED = ["sensitivity", "uncertainty", "design"]; // what computes many joints at once
const STATES = { waiting: "waits", running: "runs", done: "finished", failed: "failed", stopped: "stopped" };

export class JobList {
  /** `post(path, body)` asks the server; `takeOver(joint)` puts a designed joint on the page; `controls` know its numbers. */
  constructor(panel, post, takeOver, controls) {
    this.panel = panel;
    this.post = post;
    this.takeOver = takeOver;
    this.state = null;
    this.designFile = null;
    this.items = [];
    const begin = (text, kind, id, options) => {
      const button = element("button", { type: "button", id }, text);
      button.addEventListener("click", () => this.begin({ kind, ...options() }));
      return button;
    };
    this.reverse = element("input", { type: "checkbox", id: "job-reverse" });
    this.samples = element("input", { type: "number", id: "job-samples", min: 100, max: 1000000, value: 1000 });
    this.distribution = element(
      "select",
      { id: "job-distribution" },
      ...[["", "as in the file"], ["uniform", "uniform"], ["triangular", "triangular"], ["normal 2 sigma", "normal, ± is 2 σ"], ["normal 3 sigma", "normal, ± is 3 σ"]].map(([value, text]) => element("option", { value }, text)),
    );
    const field = (id, text, input) => element("div", { class: "field" }, element("label", { for: id }, text), input);
    this.design = begin("Design", "design", "begin-design", () => ({ design: this.designFile.design, file: this.designFile.name }));
    this.design.disabled = true;
    this.designNote = element("p", { class: "note", id: "design-note" }, "To design, open or drop a design file, or compose a design below. Its free numbers, goal and limits are applied to the joint on the page.");
    this.composer = new Composer(controls, post, (job, refused) => this.begin(job, refused));
    this.message = element("p", { class: "note fail", role: "alert", id: "job-message" });
    this.list = element("div", { id: "job-list" });
    panel.append(
      element("div", { class: "chart-fields" },
        element("div", { class: "field" }, element("span", {}, "Torque over temperature or preload"), begin("Window", "window", "begin-window", () => ({}))),
        element("div", { class: "field" }, element("span", {}, "Oil and asperities over speed"), begin("Film", "film", "begin-film", () => ({}))),
        element("div", { class: "field" }, element("span", {}, "Preload and capacity over the years"), begin("Wear", "wear", "begin-wear", () => ({}))),
        element("div", { class: "field" }, element("span", {}, "Transmission error over a turn"), element("div", { class: "beside" }, begin("Accuracy", "accuracy", "begin-accuracy", () => ({ reverse: this.reverse.checked })), element("label", { for: "job-reverse" }, this.reverse, " both directions"))),
        element("div", { class: "field" }, element("span", {}, "Elasticities of every number"), begin("What matters most", "sensitivity", "begin-sensitivity", () => ({}))),
        field("job-samples", "Samples", this.samples),
        field("job-distribution", "Distribution of tolerances", this.distribution),
        element("div", { class: "field" }, element("span", {}, "From the file's tolerances (±)"), begin("Uncertainty", "uncertainty", "begin-uncertainty", () => ({ samples: Number(this.samples.value), seed: 0, distribution: this.distribution.value }))),
        element("div", { class: "field" }, element("span", {}, "With a design file"), this.design),
      ),
      this.designNote,
      this.message,
      this.composer.node,
      this.list,
    );
  }

  /** The joint on the page; results of another one are marked. `baselineState` is that of the pinned baseline, or null. */
  follow(state, answer, baselineState) {
    this.state = state;
    this.baselineState = baselineState;
    this.composer.follow(state, answer);
    for (const item of this.items) item.other.hidden = item.state === state;
  }

  /** A design file was opened. */
  offerDesign(found) {
    this.designFile = found;
    this.design.disabled = false;
    this.designNote.textContent = `Design file: ${found.name}. The joint that it names is replaced by the joint on the page.`;
    this.panel.open = true;
    this.panel.scrollIntoView({ block: "nearest" });
    this.design.focus();
  }

  /** Begin a study; `refused` is called with the reason where the server refuses it. */
  async begin(job, refused = (text) => { this.message.textContent = text; }) {
    this.message.textContent = "";
    const state = this.state;
    let ok;
    let found;
    try {
      [ok, found] = await this.post("/api/jobs", JSON.stringify({ ...state, job }));
    } catch {
      refused("The server does not answer.");
      return;
    }
    if (!ok) {
      refused(found.error);
      return;
    }
    this.watch(found, state);
  }

  watch(job, state) {
    const progress = element("progress", { "aria-label": `${TITLES[job.kind]}, progress` });
    const text = element("p", { role: "status" });
    const stop = element("button", { type: "button" }, "Stop");
    const other = element("p", { class: "note", hidden: true }, "Computed for another state of the joint than the one on the page.");
    const body = element("div", { class: "job-result" });
    const head = element("div", { class: "job-head" }, element("h3", {}, TITLES[job.kind]), progress, stop);
    const node = element("article", { class: "job", "data-kind": job.kind }, head, text, other, body);
    const item = { node, progress, text, stop, other, body, state };
    this.items.unshift(item);
    this.list.prepend(node);
    while (this.items.length > 6) this.items.pop().node.remove();
    stop.addEventListener("click", () => this.post(`/api/jobs/${job.id}/stop`, "{}"));
    this.tell(item, job);
    const events = new EventSource(`/api/jobs/${job.id}/events`);
    events.onmessage = (event) => {
      const told = JSON.parse(event.data);
      this.tell(item, told);
      if (["done", "failed", "stopped"].includes(told.state)) {
        events.close();
        this.ended(item, told);
      }
    };
    events.onerror = () => {
      if (events.readyState !== EventSource.CLOSED) return; // it tries again by itself
      item.text.textContent = "The server has ended, and this job with it.";
      item.node.dataset.state = "failed";
      stop.hidden = progress.hidden = true;
    };
  }

  tell(item, job) {
    item.node.dataset.state = job.state;
    const left = job.state === "running" && job.done > 0 && job.total > job.done ? `, about ${number(Math.ceil((job.seconds * (job.total - job.done)) / job.done), 2)} s left` : "";
    const begins = job.state === "running" && !job.done ? `: starts${COMPILED.includes(job.kind) ? ", and compiles if it is the first of its kind (up to a minute)" : ""}` : "";
    const count = job.total ? `, ${job.done} of ${job.total} ${UNITS[job.kind]}` : "";
    const time = job.seconds ? `, ${number(job.seconds, 3)} s` : "";
    item.text.textContent = `${job.name}: ${STATES[job.state]}${begins}${count}${time}${left}${job.state === "failed" ? `. ${job.message}` : ""}`;
    item.text.classList.toggle("fail", job.state === "failed");
    if (job.total) {
      item.progress.max = job.total;
      item.progress.value = job.done;
    }
  }

  async ended(item, job) {
    item.stop.hidden = item.progress.hidden = true;
    if (job.state !== "done") return;
    const { result } = await (await fetch(`/api/jobs/${job.id}`)).json();
    item.result = result;
    const parts = { window: (found) => elements(found.views), film: (found) => elements(found.views), wear: (found) => drawn(found, wearCurves, this.before(item, job)), accuracy: (found) => drawn(found, accuracyCurves, this.before(item, job)), sensitivity, uncertainty, design: (found) => this.designed(found, item) }[job.kind](result);
    item.body.replaceChildren(...parts, element("a", { class: "button", href: `/api/jobs/${job.id}/result.json`, download: true }, "Save JSON"));
    fitTables(item.body);
  }

  /** What the same study found of the pinned baseline, if it was asked of it. */
  before(item, job) {
    if (!this.baselineState || item.state === this.baselineState) return null;
    return this.items.find((each) => each.node.dataset.kind === job.kind && each.state === this.baselineState && each.result)?.result ?? null;
  }

  designed(found, item) {
    const take = element("button", { type: "button" }, "Put this design on the page");
    take.addEventListener("click", () => this.takeOver({ name: item.state.name, toml: found.joint_text }));
    return [...elements(found.views), take, " "];
  }
}

/** The first figures of a view, its curves, and everything else. */
function drawn(found, curves, before) {
  const [first, ...others] = found.views;
  return [...elements([first]), ...curves(found, before), ...elements(others)];
}

/** Elasticities of one result after the other. */
function sensitivity(found) {
  const names = Object.keys(found.views);
  const select = element("select", { id: "sensitivity-result", "aria-label": "Result that is ranked" }, ...names.map((name) => element("option", { value: name }, found.results[name].description)));
  select.value = names.includes("assembly_stiffness_output") ? "assembly_stiffness_output" : names[0];
  const place = element("div", {});
  const draw = () => place.replaceChildren(...elements(found.views[select.value]));
  select.addEventListener("change", draw);
  draw();
  return [select, place, element("p", { class: "note" }, "An elasticity of 2: one per cent more of the number makes about two per cent more of the result. A radius is that of another drive, whose ring follows it; a finished part deviates while all others stay as they are.")];
}

/** Where 95 % of the drives lie, and what each tolerance contributes. */
const uncertainty = (found) => [
  element("p", {}, `${found.solved} of ${found.samples} samples have a result, seed ${found.seed}.`),
  ...elements(found.views),
];
