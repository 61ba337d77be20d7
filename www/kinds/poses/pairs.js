// The pairs of dyads with their verdicts. The chosen pair is drawn. Buttons move it to each pose, or open it as a
// linkage.
import { readoutText } from "assur/controls/readout.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { download } from "assur/core/download.js";
import { html, nothing, render } from "assur/core/html.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { FILTERS, csvOf, saidOf, typeOf, verdictOf } from "assur/kinds/poses/verdicts.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/poses/task.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Name by which lessons withhold the verdicts. */
const VERDICT = "poses-passage";

export class PairsView {
  #page;
  #said = make("p", { id: "pairs-said" });
  #filter = make("select", { id: "pairs-filter", class: "control", "data-t-label": "poses.filter" });
  #count = make("p", { id: "pairs-count" });
  #body = make("tbody");
  #go = make("div", { id: "pairs-go", role: "group", "data-t-label": "poses.go" });
  #send;
  #save;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    for (const name of Object.keys(FILTERS)) this.#filter.append(make("option", { value: name, "data-t": `poses.filter.${name}` }));
    this.#filter.addEventListener("change", () => this.#list());
    this.#send = make("button", { id: "pairs-send", class: "control add", type: "button", "data-t": "poses.send", onclick: () => this.#open() });
    this.#save = make("button", { id: "poses.csv", class: "control add", type: "button", "data-t": "poses.csv", onclick: () => this.#download() });
    const table = make("table", { class: "pairs", "data-t-label": "poses.pairs" }, [this.#body]);
    section("poses", "poses.pairs", "pairs", [this.#said, this.#go, this.#filter, this.#count, make("div", { class: "pairs-scroll" }, [table]), this.#send, this.#save]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { summary, words, state, withheld } = snapshot;
    if (this.#shown.same(summary, words, state.document, withheld)) return;
    this.#snapshot = snapshot;
    write(this.#said, saidOf(snapshot).join(" "));
    this.#list();
    const { met } = summary;
    this.#go.hidden = met.length === 0;
    render(met.map((input, k) => this.#button(input, k, snapshot)), this.#go);
    this.#send.disabled = summary.linkage === null;
  }

  /** Lists the pairs that pass the filter. */
  #list() {
    const snapshot = this.#snapshot;
    if (!snapshot) return;
    const { summary: { pairs, number }, words } = snapshot;
    const listed = this.#listed(snapshot);
    this.#save.disabled = pairs.length === 0;
    this.#filter.hidden = pairs.length === 0 || snapshot.withheld.has(VERDICT);
    this.#count.hidden = listed.length === pairs.length;
    const [shown, all] = [listed.length, pairs.length].map((count) => words.numbers.exact(count));
    write(this.#count, words.text("poses.listed", { shown, all }));
    render(listed.map((one) => this.#row(one, one === number, snapshot)), this.#body);
  }

  /**
   * @param {Snapshot} snapshot
   * @returns {readonly number[]} numbers of the pairs that pass the filter, the best first; of all pairs if a lesson withholds the verdicts
   */
  #listed({ summary: { ranking, pairs }, withheld }) {
    return withheld.has(VERDICT) ? pairs.map((_, k) => k + 1) : ranking.filter((number) => FILTERS[this.#filter.value](pairs[number - 1]));
  }

  /**
   * @param {number} number
   * @param {boolean} chosen
   * @param {Snapshot} snapshot
   */
  #row(number, chosen, { summary: { pairs, dyads }, words, withheld }) {
    const pair = pairs[number - 1];
    const choose = () => this.#page.store.update((state) => edited(state, "poses", () => ({ solution: number })));
    const name = pair.dyads.map((k) => `${dyads[k - 1].code}${subscript(String(k))}`).join(" + ");
    const type = pair.verdict ? `: ${typeOf(pair.verdict, words)}` : "";
    const hidden = withheld.has(VERDICT);
    const verdict = hidden ? readoutText({ text: "?", asked: words.text("lesson.asked") }) : verdictOf(pair, words);
    return html`<tr data-sound=${hidden ? nothing : pair.sound}><td><label for="pair-${number}"><input id="pair-${number}" type="radio" name="pair" .checked=${chosen} @change=${choose}> <span>${name}${type}</span></label><small>${verdict}</small></td></tr>`;
  }

  /**
   * @param {number | null} input at which the pose is met
   * @param {number} k
   * @param {Snapshot} snapshot
   */
  #button(input, k, { words, coordinate }) {
    const n = String(k + 1);
    const go = () => {
      if (input !== null) this.#page.drive(coordinate.inputShown(input));
    };
    const label = words.text(input === null ? "poses.missed" : "poses.go_to", { n });
    return html`<button id="pose-go-${n}" class="control" type="button" aria-label=${label} title=${label} ?disabled=${input === null} @click=${go}>${n}${input === null ? " ✗" : " ✓"}</button>`;
  }

  #open() {
    const linkage = this.#snapshot?.summary.linkage;
    if (linkage) this.#page.choose(linkage.kind, linkage.document);
  }

  #download() {
    if (this.#snapshot) download(new Blob([csvOf(this.#snapshot.summary, this.#listed(this.#snapshot))], { type: "text/csv" }), "linkages.csv");
  }
}
