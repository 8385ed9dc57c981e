// A second joint file beside the joint on the page: what 'asperity compare' says of both.

import { elements } from "/blocks.js";
import { element, number } from "/numbers.js";

const LARGEST = 1000000; // byte, as the server
const PAUSE = 300; // ms without a change of the joint before it is compared again

export class Comparison {
  /** `post(path, body, type)` asks the server; `fail(text, name)` says what is wrong with a file; `opened()` that nothing is. */
  constructor(panel, post, opened, fail) {
    this.panel = panel;
    this.post = post;
    this.opened = opened;
    this.fail = fail;
    this.other = null;
    this.full = false;
  }

  /** Compare the joint on the page with a joint file. */
  async open(file) {
    if (file.size > LARGEST) {
      this.fail(`${file.name} has ${number(file.size / 1e6, 3)} MB; a joint file of at most 1 MB is read here.`, file.name);
      return;
    }
    try {
      const [ok, found] = await this.post(`/api/file?${new URLSearchParams({ name: file.name })}`, await file.arrayBuffer(), "application/octet-stream");
      if (!ok) {
        this.fail(found.error, file.name);
        return;
      }
      this.other = { name: found.name, toml: found.toml };
    } catch {
      this.fail(`${file.name}: the server does not answer.`, file.name);
      return;
    }
    this.opened();
    this.build();
    await this.ask();
    this.panel.scrollIntoView({ block: "nearest" });
  }

  build() {
    const close = element("button", { type: "button" }, "Close");
    close.addEventListener("click", () => {
      this.panel.hidden = true;
      this.other = null;
    });
    const all = element("input", { type: "checkbox", id: "compare-all" });
    all.checked = this.full;
    all.addEventListener("change", () => {
      this.full = all.checked;
      this.show();
    });
    this.message = element("p", { class: "note", role: "status", id: "compare-message" });
    this.body = element("div", {});
    this.title = element("h2", {});
    this.panel.replaceChildren(this.title, this.message, this.body, element("p", { class: "compare-end" }, all, element("label", { for: all.id }, "Every result that differs"), close));
    this.panel.hidden = false;
  }

  /** Another state of the joint is on the page. */
  follow(state) {
    if (this.state === state) return;
    this.state = state;
    clearTimeout(this.timer);
    if (this.other) this.timer = setTimeout(() => this.ask(), PAUSE);
  }

  /** Ask for the newest; what comes late is not shown. */
  async ask() {
    const asked = [this.state, this.other];
    if (!this.state) return;
    this.message.textContent = "Comparing…";
    let ok = false;
    let found;
    try {
      [ok, found] = await this.post("/api/compare", JSON.stringify({ one: this.state, other: this.other }));
    } catch {
      found = { error: "The server does not answer." };
    }
    if (asked[0] !== this.state || asked[1] !== this.other) return;
    if (found.kind === "busy") {
      this.timer = setTimeout(() => this.ask(), 2 * PAUSE);
      return;
    }
    this.found = ok ? found : null;
    this.message.textContent = ok ? "" : found.error;
    this.message.classList.toggle("fail", !ok);
    this.title.textContent = `${this.state.name}, on the page, beside ${this.other.name}`;
    this.show();
  }

  show() {
    const parts = this.found ? this.found[this.full ? "all_parts" : "parts"] : [];
    this.body.replaceChildren(...elements(parts));
    this.panel.dataset.compared = String(Number(this.panel.dataset.compared || 0) + 1);
  }
}
