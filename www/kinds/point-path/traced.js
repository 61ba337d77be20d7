// The shown linkage: its distances from the points of the path, its cognates and geared five-bars.
import { section } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { Seen } from "assur/core/seen.js";
import { choose } from "assur/kinds/point-path/choose.js";
import { missedBy, typeOf, verdictOf } from "assur/kinds/point-path/verdict.js";

/**
 * @typedef {import("assur/kinds/point-path/verdict.js").Snapshot} Snapshot
 * @typedef {import("assur/types/file.js").TracingDocument} Tracing
 */

/** Greatest number of points for which there are buttons that move the linkage to a point. */
const GO = 24;

/** Distance of a point from the curve up to which the point is met, as a part of the size of the path. */
const MET = 1e-6;

export class TracedView {
  #page;
  #body = make("div");
  #section;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#section = section("point-path", "path.traced", "traced", [this.#body]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { summary, words, state } = snapshot;
    if (this.#shown.same(summary, words, state.document)) return;
    this.#section.hidden = summary.traced === null;
    if (!summary.traced) return;
    const { traced, size, geared, linkage } = summary;
    const open = (/** @type {typeof linkage} */ one) => () => {
      if (one) this.#page.choose(one.kind, one.document);
    };
    const bars = geared.map((one, k) => html`<button id="path-geared-${k + 1}" class="control" type="button" @click=${open(one)}>${words.text("path.geared", { n: String(k + 1) })}</button>`);
    render(html`
      <p id="path-verdict">${typeOf(traced, words)}: ${missedBy(traced, size, words)}; ${verdictOf(traced, words)}.</p>
      ${this.#points(snapshot)}
      ${this.#cognates(snapshot)}
      ${bars.length > 0 ? html`<div class="path-go" role="group" aria-label=${words.text("path.five_bars")}>${bars}</div>` : nothing}
      <button id="path-send" class="control add" type="button" ?disabled=${linkage === null} @click=${open(linkage)}>${words.text("path.send")}</button>`, this.#body);
  }

  /** @param {Snapshot} snapshot */
  #points({ summary: { met, distances, size }, state: { document: { course = "points" } }, words, coordinate }) {
    if (course !== "points" || met.length === 0 || met.length > GO) return nothing;
    const one = (/** @type {number | null} */ input, /** @type {number} */ k) => {
      const n = String(k + 1);
      if (input === null) {
        const label = words.text("path.unreached", { n });
        return html`<button id="path-go-${n}" class="control" type="button" aria-label=${label} title=${label} disabled>${n} ✗</button>`;
      }
      const is = distances[k] <= MET * size;
      const label = words.text(is ? "path.go_to" : "path.go_near", { n, length: words.numbers.short(distances[k]) });
      const go = () => this.#page.drive(coordinate.inputShown(input));
      return html`<button id="path-go-${n}" class="control" type="button" aria-label=${label} title=${label} @click=${go}>${n}${is ? " ✓" : ""}</button>`;
    };
    return html`<div class="path-go" role="group" aria-label=${words.text("path.go")}>${met.map(one)}</div>`;
  }

  /** @param {Snapshot} snapshot */
  #cognates({ summary: { cognates }, words }) {
    const button = (/** @type {Tracing | null} */ one, /** @type {number} */ k) => {
      const take = () => {
        if (one) choose(this.#page, one);
      };
      const text = words.text(cognates.length > 1 ? `path.cognate.${k + 1}` : "path.cognate");
      return html`<button id="path-cognate-${k + 1}" class="control" type="button" ?disabled=${one === null} @click=${take}>${text}</button>`;
    };
    return html`<div class="path-go" role="group" aria-label=${words.text("path.cognates")}>${cognates.map(button)}</div>`;
  }
}
