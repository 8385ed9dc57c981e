// Long computations: begin, watch, stop, and show what came out.

import { Composer } from "/compose.js";
import { label } from "/controls.js";
import { element, number, table } from "/numbers.js";
import { warnings } from "/results.js";

const TITLES = { sensitivity: "What matters most", uncertainty: "Uncertainty", design: "Design" };
const UNITS = { sensitivity: "", uncertainty: "samples", design: "searches" };
const STATES = { waiting: "waits", running: "runs", done: "finished", failed: "failed", stopped: "stopped" };
const MOST_SHOWN = 10;

const plain = (text) => text.replaceAll("_", " ");

/** A number of the joint file in words, with its section where the name alone is not clear. */
const named = (path) => (path.startsWith("materials.") ? label(path) : `${label(path)} (${path.split(".")[0]})`);

/** Numbers of a document in the unit of the cards. */
function shown(unit) {
  if (unit === "N*m/rad") return [Math.PI / 10800, "N·m/arcmin"];
  if (unit === "rad") return [10800 / Math.PI, "arcmin"];
  return [1, unit === "1" ? "" : unit.replaceAll("*", "·")];
}

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
    this.samples = element("input", { type: "number", id: "job-samples", min: 100, max: 1000000, value: 1000 });
    this.distribution = element(
      "select",
      { id: "job-distribution" },
      ...[["", "as the file states them"], ["uniform", "uniform"], ["triangular", "triangular"], ["normal 2 sigma", "normal, 2 standard deviations"], ["normal 3 sigma", "normal, 3 standard deviations"]].map(([value, text]) => element("option", { value }, text)),
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

  /** The joint on the page; results of another one are marked. */
  follow(state, answer) {
    this.state = state;
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
    const begins = job.state === "running" && !job.done ? ": starts, and compiles if it is the first of its kind (up to a minute)" : "";
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
    const parts = { sensitivity, uncertainty, design: (found) => this.designed(found, item) }[job.kind](result);
    item.body.replaceChildren(...parts, element("a", { class: "button", href: `/api/jobs/${job.id}/result.json`, download: true }, "Save JSON"));
  }

  designed(found, item) {
    const { shown } = found;
    const rows = Object.entries(shown.variables).map(([path, value]) => [named(path), value.before ?? "–", value.after, found.at_bound[path] ? `at its ${found.at_bound[path]} bound` : ""]);
    const limits = found.limits
      .map((each, i) => ({ ...each, ...shown.limits[i] }))
      .filter((each) => !each.implied)
      .map((each) => [each.label + (each.row ? `, ${plain(each.row)}` : ""), each.value, `${each.at_most ? "at most" : "at least"} ${each.limit}`, !each.met ? "✗ missed" : each.active ? "✓ reached" : "✓ kept"]);
    const take = element("button", { type: "button" }, "Put this design on the page");
    take.addEventListener("click", () => this.takeOver({ name: item.state.name, toml: found.joint_text }));
    return [
      element("p", { class: found.conflict ? "fail" : "pass" }, found.conflict ? `✗ ${found.conflict}` : `✓ ${found.shown.met}`),
      element("p", {}, `${shown.goal[0].toUpperCase()}${shown.goal.slice(1)}: ${shown.after}, before ${shown.before}.`),
      scrolled("Free numbers", ["number", "before", "design", "bound"], rows),
      ...(limits.length ? [scrolled("Limits", ["limit", "actual", "required", "result"], limits)] : []),
      element("h4", {}, "Warnings of this design"),
      found.diagnostics ? warnings(found) : element("p", { class: "note" }, `Under the output torque of its file it has no result: ${found.no_result_because}.`),
      take,
      " ",
    ];
  }
}

const scrolled = (name, headings, rows) => element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": `${name}, scrollable` }, table(name, headings, rows));

/** A bar to the right for more, to the left for less. */
function signed(value, largest) {
  const fill = element("span", { class: `fill ${value < 0 ? "less" : "more"}` });
  fill.style.width = `${(50 * Math.abs(value)) / largest}%`;
  fill.style.marginLeft = value < 0 ? `${50 - (50 * Math.abs(value)) / largest}%` : "50%";
  return element("span", { class: "bar-track", "aria-hidden": "true" }, fill);
}

function sensitivity(found) {
  const names = Object.keys(found.results);
  const select = element("select", { id: "sensitivity-result", "aria-label": "Result that is ranked" }, ...names.map((name) => element("option", { value: name }, found.results[name].description)));
  select.value = names.includes("assembly_stiffness_output") ? "assembly_stiffness_output" : names[0];
  const place = element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Elasticities, scrollable" });
  const draw = () => {
    const ranked = Object.entries(found.results[select.value].elasticity)
      .filter((pair) => pair[1] !== null && pair[1] !== 0)
      .sort((one, other) => Math.abs(other[1]) - Math.abs(one[1]))
      .slice(0, MOST_SHOWN);
    const largest = ranked.length ? Math.abs(ranked[0][1]) : 1;
    const rows = ranked.map(([path, value]) => [named(path), `${value > 0 ? "+" : "−"}${number(Math.abs(value), 3)}`, signed(value, largest)]);
    place.replaceChildren(rows.length ? table("Largest elasticities", ["number of the file", "elasticity", element("span", { class: "visually-hidden" }, "bar")], rows) : element("p", { class: "note" }, "This result has no elasticities: it is 0 or infinite."));
  };
  select.addEventListener("change", draw);
  draw();
  return [select, place, element("p", { class: "note" }, "An elasticity of 2: one per cent more of the number makes about two per cent more of the result. The ten largest. A radius is that of another drive, whose ring follows it; a finished part deviates while all others stay as they are.")];
}

function uncertainty(found) {
  const results = Object.entries(found.results).filter((pair) => pair[1].nominal !== null);
  const rows = results.map(([, each]) => {
    const [factor, unit] = shown(each.unit);
    const cell = (value) => (value === null ? "–" : number(value * factor));
    const end = (share) => (each.failing_ends.includes(share) ? "fails" : cell(each[`quantile_${share}`]));
    const failed = each.failed_share > 0 ? ` (${number(100 * each.failed_share, 3)} % of the drives fail)` : "";
    return [`${each.description}${unit ? `, ${unit}` : ""}${failed}`, cell(each.nominal), cell(each.mean), end("0.025"), end("0.975")];
  });
  const failing = results.some((pair) => pair[1].failed_share > 0) ? "; those that fail count as the worst there, and not in the mean" : "";
  const first = results.find((pair) => Object.values(pair[1].sobol).some((index) => index.total_order !== null));
  const shares = first ? Object.entries(first[1].sobol).sort((one, other) => other[1].total_order - one[1].total_order).slice(0, MOST_SHOWN) : [];
  const bar = (share) => {
    const fill = element("span", { class: "fill" });
    fill.style.width = `${Math.min(Math.max(share, 0), 1) * 100}%`;
    return element("span", { class: "bar-track", "aria-hidden": "true" }, fill);
  };
  return [
    element("p", {}, `${found.solved} of ${found.samples} samples have a result, seed ${found.seed}. 95 % of the drives lie between the last two columns${failing}.`),
    element("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Intervals, scrollable" }, table("Intervals", ["result", "nominal", "mean", "2.5 %", "97.5 %"], rows)),
    ...(shares.length
      ? [element("h4", {}, `Shares in the variance of: ${first[1].description}`), table("Sobol indices", ["tolerance", "total order", element("span", { class: "visually-hidden" }, "bar")], shares.map(([path, index]) => [named(path), `${number(index.total_order, 2)} ± ${number(index.total_order_half_width, 1)}`, bar(index.total_order)]))]
      : []),
  ];
}
