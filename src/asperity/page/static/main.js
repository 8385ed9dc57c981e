// The page: asks the server about the joint, the newest request wins, and keeps address, undo and baseline.

import { Chart } from "/chart.js";
import { Comparison } from "/compare.js";
import { Controls } from "/controls.js";
import { followHeight, noVerdict, showFirst, showHeadline } from "/headline.js";
import { showHelp } from "/help.js";
import { JobList } from "/jobs.js";
import { banner, notice, say } from "/messages.js";
import { connectPanels } from "/panels.js";
import { connectPreferences } from "/preferences.js";
import { showAnswer } from "/results.js";
import { History, packed, unpacked } from "/state.js";
import { Uploads } from "/upload.js";

const get = (id) => document.getElementById(id);
const page = document.documentElement;
const RETRY = 2000; // ms
const NOTHING = "There is no joint without errors to save.";
const SLOW = 1500; // ms after which it is said that an answer takes long
const SETTLED = 80; // ms without a change before everything is computed
const PATIENCE = 1000; // ms after which it is computed although changes go on
const REST = 300; // ms without a change, before the joint goes into the address

let history = null;
let controls = null;
let chart = null;
let jobs = null;
let uploads = null;
let comparison = null;
let answer = null; // of the joint on the screen
let baseline = null;
let shown = null; // state of the joint on the screen
let baselineState = null;
let wanted = false; // something changed since the last request began
let asking = false;
let lastPath = null;
let changedAt = 0; // when the joint was changed the last time [ms]
let first = null; // state and figures that were known first
let firstAsked = null; // the request for the first figures that is on its way
let ownHash = "";
let addressLater = 0; // the timer of REST
let shownText = null; // of the joint file whose rows are on the page

page.dataset.revision = "0";

function showError(text) {
  get("error").hidden = !text;
  get("error").textContent = text;
  stale(Boolean(text) || page.dataset.state === "lost");
}

/** Grey the results that are not those of what was entered. */
function stale(old) {
  for (const id of ["answer", "cards"]) get(id).classList.toggle("stale", old);
}

async function post(path, body, type = "application/json") {
  const response = await fetch(path, { method: "POST", headers: { "content-type": type }, body });
  return [response.ok, await response.json()];
}

/** Ask for the newest state; while an answer is on its way, only the newest of all changes waits. */
async function ask() {
  wanted = true;
  if (asking) return;
  asking = true;
  while (wanted) {
    if (answer) await settled();
    wanted = false;
    await askOnce(history.state);
  }
  asking = false;
}

/** Wait until the newest first figures are there and no change has followed for a moment, but not for ever. */
async function settled() {
  const began = performance.now();
  while (performance.now() - began < PATIENCE) {
    await firstAsked;
    const left = changedAt + SETTLED - performance.now();
    if (left <= 0) return;
    await new Promise((done) => setTimeout(done, left));
  }
}

/** First figures stand until the whole answer of their joint is there. */
function showNewest() {
  const behind = first !== null && first.state === history.state && shown !== first.state;
  if (behind) showFirst(first.figures, baseline);
  get("answer").classList.toggle("behind", behind);
}

/** The figures that are known first, of the newest state; what else there is greys until it follows. */
async function askFirst() {
  const asked = history.state;
  let figures = [];
  try {
    const [ok, found] = await post("/api/figures", JSON.stringify(asked));
    if (ok) ({ figures } = found);
  } catch {
    // the whole answer says it
  }
  if (figures.length && page.dataset.state === "ready") {
    first = { state: asked, figures };
    showNewest();
    page.dataset.figures = String(Number(page.dataset.figures ?? 0) + 1);
  }
  firstAsked = history.state === asked ? null : askFirst();
}

async function askOnce(state) {
  const slow = setTimeout(() => say("Computing…"), SLOW);
  const slower = setTimeout(() => say("Still computing. Crowns, skew and unlike branches take some seconds."), 3000);
  try {
    const [ok, found] = await post("/api/joint", JSON.stringify(state));
    banner("");
    if (ok) {
      page.dataset.state = "ready";
      answer = found;
      if (state.toml !== shownText) controls.build(found); // another file
      shownText = state.toml;
      controls.show(found, history.state.changes, state.changes);
      controls.showErrors({});
      showError("");
      showAnswer(found, baseline);
      shown = state;
      showNewest();
      followed();
      links();
      const stiffness = found.document.torsional_stiffness.assembly.output_Nm_per_arcmin;
      const bound = found.document.stiffness_bound ? `, ${found.document.stiffness_bound}` : "";
      say(stiffness === null ? "No stiffness" : `Stiffness ${Number(stiffness.toPrecision(4))} N·m/arcmin at the output${bound}`, true);
    } else if (found.kind === "busy") {
      setTimeout(ask, 500);
    } else {
      page.dataset.state = "error";
      const named = Object.keys(found.keys).length ? found.keys : controls.named(found.error, lastPath);
      const keys = Object.keys(named).length || lastPath === null ? named : { [lastPath]: found.error };
      controls.showErrors(keys);
      showError(found.error);
      first = null;
      get("answer").classList.remove("behind");
      if (answer) showHeadline(answer, baseline);
      say("No result: see the message. The results shown are those of the last valid joint.", true);
      noVerdict("✗ No result", "See the message; the results shown are those of the last valid joint.");
    }
  } catch {
    page.dataset.state = "lost";
    banner("The server does not answer: it has been stopped, or the computer was asleep. Nothing you typed is lost; the page tries again every two seconds. To start it again: asperity serve");
    stale(true);
    say("The server does not answer.", true);
    setTimeout(ask, RETRY);
  } finally {
    clearTimeout(slow);
    clearTimeout(slower);
  }
  page.dataset.revision = String(Number(page.dataset.revision) + 1);
}

/** What is computed beside the joint follows it. */
function followed() {
  jobs.follow(shown, answer, baseline ? baselineState : null);
  comparison.follow(shown);
  chart.follow(shown, answer, baseline ? { answer: baseline, state: baselineState } : null);
}

function links() {
  for (const kind of ["toml", "json"]) get(`save-${kind}`).href = `/api/joint/${answer.id}/joint.${kind}`;
}

/** What the form says, and the joint with the newest results does not: dotted paths, or the name of another file. */
function leftOut() {
  const { name, toml, changes, surfaces } = history.state;
  if (toml !== shown.toml) return [name];
  const paths = [...new Set([...Object.keys(shown.changes), ...Object.keys(changes)])];
  const left = paths.filter((path) => shown.changes[path] !== changes[path]);
  return surfaces === shown.surfaces ? left : [...left, "the measured surface"];
}

/** What is saved, in words; where the form is ahead of the results, what is not part of it. */
function savedWords(what) {
  const left = leftOut();
  if (!left.length) return `${what} is saved.`;
  const joint = page.dataset.state === "error" ? "the last joint without errors" : "the last joint with results";
  return `Saved ${joint}; ${left.join(", ")} ${left.length > 1 ? "are" : "is"} not part of it.`;
}

/** A report takes some seconds, and may not be possible: then the page says why. */
async function saveReport(kind) {
  const button = get(`save-${kind}`);
  if (button.disabled) return;
  if (!answer) {
    say(NOTHING);
    return;
  }
  const { id, name } = answer;
  const words = savedWords("The report");
  button.disabled = true;
  say("Making the report…");
  try {
    const response = await fetch(`/api/joint/${id}/joint.${kind}`);
    if (!response.ok) {
      notice((await response.json()).error);
      say("There is no report: see the message.");
      return;
    }
    const link = document.createElement("a");
    link.href = URL.createObjectURL(await response.blob());
    link.download = `${name.replace(/\.toml$/, "")}.${kind}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
    say(words);
  } catch {
    say("The server does not answer.");
  } finally {
    button.disabled = false;
  }
}

/** The joint in the address: when it rests, because a new address costs a browser more time than the plots. */
function addressSoon() {
  clearTimeout(addressLater);
  addressLater = setTimeout(address, REST);
}

async function address() {
  clearTimeout(addressLater);
  const text = await packed(history.state);
  ownHash = `#joint=${text}`;
  window.history.replaceState(null, "", ownHash);
}

function refresh() {
  const state = history.state;
  get("file-name").textContent = state.name;
  document.title = `${state.name} – asperity`;
  get("undo").disabled = !history.canUndo;
  get("redo").disabled = !history.canRedo;
  if (state.toml === shownText) controls.lists.show(state.changes);
  addressSoon();
  changedAt = performance.now();
  if (answer && !firstAsked) firstAsked = askFirst();
  ask();
}

function changed(path, value, moving = false, also = {}) {
  if (path === null) {
    history.settle();
    return;
  }
  const changes = { ...history.state.changes };
  delete changes[path];
  if (value !== null) {
    if (value !== "") for (const other of controls.replaced(path)) delete changes[other];
    changes[path] = value; // behind the others: of keys that exclude each other the last holds
  }
  Object.assign(changes, also, controls.lists.following(path));
  history.add({ ...history.state, changes }, moving ? path : null);
  lastPath = path;
  refresh();
}

/** New values of several keys in one step, in place of the changes below some sections. */
function changedTogether(values, instead = []) {
  const kept = Object.entries(history.state.changes).filter(([path]) => !instead.some((section) => path === section || path.startsWith(`${section}.`)));
  history.add({ ...history.state, changes: { ...Object.fromEntries(kept), ...values } });
  lastPath = null;
  refresh();
}

function step(count) {
  if (history.move(count)) {
    lastPath = null;
    if (document.activeElement instanceof HTMLInputElement) document.activeElement.blur();
    refresh();
  }
}

/** Another joint on the page, as a new state. */
function takeJoint({ name, toml }) {
  lastPath = null;
  const named = /^\s*measurement\s*=/m.test(toml); // its measured surface, which the page may have
  history.add({ name, toml, changes: {}, surfaces: named ? history.state.surfaces : [] });
  refresh();
}

/** Other measured surfaces in the joint: one, one of each body, or none. */
function takeSurfaces(surfaces) {
  lastPath = null;
  history.add({ ...history.state, surfaces });
  refresh();
}

function refused(text, name) {
  notice(text);
  say("The file was not opened; the joint on the page is unchanged.");
  page.dataset.refused = name;
}

/** A file was opened: what an earlier one was refused for is gone. */
function opened() {
  if (page.dataset.state === "ready") showError("");
}

function pin() {
  baseline = baseline ? null : answer;
  baselineState = shown;
  get("pin").setAttribute("aria-pressed", String(Boolean(baseline)));
  const [what, of] = baseline ? ["Remove", " baseline"] : ["Pin", " as baseline"];
  get("pin").firstChild.data = what;
  get("pin").lastElementChild.textContent = of;
  get("headline").classList.toggle("compared", Boolean(baseline));
  showAnswer(answer, baseline);
  followed();
}

function connect() {
  get("undo").addEventListener("click", () => step(-1));
  get("redo").addEventListener("click", () => step(1));
  get("pin").addEventListener("click", () => answer && pin());
  for (const [id, take] of [["open-file", uploads], ["compare-file", comparison]]) {
    get(id).addEventListener("change", (event) => {
      const [file] = event.target.files;
      event.target.value = "";
      if (file) take.open(file);
    });
  }
  for (const [kind, what] of [["toml", "The joint file"], ["json", "The JSON document"]]) {
    get(`save-${kind}`).addEventListener("click", () => say(answer ? savedWords(what) : NOTHING));
  }
  for (const kind of ["html", "pdf"]) get(`save-${kind}`).addEventListener("click", () => saveReport(kind));
  get("copy-link").addEventListener("click", async () => {
    await address();
    try {
      await navigator.clipboard.writeText(location.href);
      say("The link was copied.");
    } catch {
      say("The browser does not allow copying; copy the address of the page instead.");
    }
  });
  document.addEventListener("keydown", (event) => {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || !["z", "y"].includes(key)) return;
    event.preventDefault();
    step(key === "y" || event.shiftKey ? 1 : -1);
  });
  document.addEventListener("dragover", (event) => event.preventDefault());
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    const [file] = event.dataTransfer.files;
    if (file) uploads.open(file);
  });
  window.addEventListener("hashchange", async () => {
    if (location.hash === ownHash) return;
    const linked = location.hash.startsWith("#joint=") ? await unpacked(location.hash.slice(7)) : null;
    if (!linked) address(); // an anchor on the page
    else {
      history.add(linked);
      refresh();
    }
  });
}

async function begin() {
  followHeight();
  connectPanels();
  connectPreferences();
  const described = await (await fetch("/api/description")).json();
  const linked = location.hash.startsWith("#joint=") ? await unpacked(location.hash.slice(7)) : null;
  controls = new Controls(get("controls"), described, changed, changedTogether, () => takeSurfaces([]));
  controls.build(described.start);
  showHelp(get("controls"));
  jobs = new JobList(get("jobs"), post, takeJoint, controls);
  uploads = new Uploads(get("measured"), {
    post,
    say,
    joint: takeJoint,
    design: (found) => jobs.offerDesign(found),
    surface: (found, beside = []) => takeSurfaces([...beside, found]),
    surfaces: () => history.state.surfaces,
    opened,
    fail: refused,
  });
  comparison = new Comparison(get("compared"), post, opened, refused);
  chart = new Chart(get("chart"), controls, post);
  history = new History(linked || { name: described.start.name, toml: described.start.toml, changes: {}, surfaces: described.start.surfaces });
  connect();
  refresh();
}

begin();
