// Conditions of assembly of a train with their numbers, suggested numbers of teeth if a condition fails, and mobility.
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { Seen } from "assur/core/seen.js";
import { withSubscripts } from "assur/core/subscripts.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/gear-train/drives.js").Snapshot} Snapshot
 * @typedef {Snapshot["summary"]["conditions"][number]} Condition
 * @typedef {Snapshot["summary"]["suggestions"][number]} Suggestion
 * @typedef {import("assur/core/words.js").Words} Words
 */

export class ConditionsView {
  #store;
  #said = make("p", { id: "train-builds" });
  #list = make("ul", { class: "train-list", id: "train-conditions" });
  #near = make("div", { id: "train-suggestions" });
  #contact = make("p");
  #mobility = make("p", { id: "train-mobility" });
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store }) {
    this.#store = store;
    section("gear-train", "build.heading", "conditions", [this.#said, this.#list, this.#near, this.#contact, this.#mobility]);
  }

  /** @param {Snapshot} snapshot */
  render({ state, summary, words, stale }) {
    if (this.#shown.same(summary, words, stale)) return;
    const { conditions, builds, suggestions, in_contact: contact } = summary;
    write(this.#said, words.text(builds ? "build.builds" : "build.fails"));
    this.#said.dataset.holds = String(builds);
    render(conditions.map((one) => condition(one, words)), this.#list);
    const near = suggestions.map((one) => this.#offer(one, words));
    const offered = near.length > 0 ? html`<ul class="train-list">${near}</ul>` : words.text("suggestions.none");
    render(builds ? nothing : html`<h3>${words.text("suggestions.heading")}</h3>${offered}`, this.#near);
    const planar = (state.document.form ?? "planar") === "planar";
    this.#contact.hidden = !planar;
    write(this.#contact, contact == null ? words.text("build.no_contact") : words.text("build.contact", { z2: words.numbers.exact(contact) }));
    write(this.#mobility, mobility(summary.mobility, words));
  }

  /**
   * @param {Suggestion} suggestion
   * @param {Words} words
   */
  #offer({ z1, z2, z2_step: step, z4 }, words) {
    const numbers = [["z₁", z1], ["z₂", z2], ["z₂′", step], ["z₄", z4]].filter(([, value]) => value != null);
    const take = words.text("suggestions.take");
    const said = numbers.map(([symbol, value]) => `${symbol} = ${words.numbers.exact(Number(value))}`).join(", ");
    const act = () => this.#store.update((state) => edited(state, "gear-train", () => ({ z1, z2, z4, ...(step == null ? {} : { z2_step: step }) })));
    return html`<li><span>${said}</span><button class="control" type="button" aria-label="${take}: ${said}" @click=${act}>${take}</button></li>`;
  }
}

/**
 * @param {Condition} condition
 * @param {Words} words
 */
function condition({ kind, left, right, met, shifted }, words) {
  const [one, other] = [left, right].map((value) => words.numbers.upTo(value, 4));
  const mark = html`<b data-holds=${met}>${met ? "✓" : "✗"}<span class="unseen"> ${words.text(met ? "build.met" : "build.unmet")}</span></b>`;
  const said = words.text(`condition.${kind}`, { left: one, right: other });
  return html`<li>${mark}<span>${withSubscripts(shifted ? `${said} ${words.text("condition.shifted")}` : said)}</span></li>`;
}

/**
 * @param {Snapshot["summary"]["mobility"]} mobility
 * @param {Words} words
 */
function mobility({ links, one_freedom: one, two_freedoms: two, mobility: w, passive }, words) {
  const { numbers } = words;
  const said = words.text("mobility.said", { links: numbers.exact(links), one: numbers.exact(one), two: numbers.exact(two), w: numbers.exact(w) });
  return passive > 0 ? `${said} ${words.counted("mobility.passive", passive)}` : said;
}
