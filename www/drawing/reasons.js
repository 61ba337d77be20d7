// Reasons why a drawing does not move, with remedies, in the panel beside it.
import { sentence } from "assur/controls/problems.js";
import { make } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { step } from "assur/drawing/edit.js";

/**
 * @typedef {import("assur/types/edit.js").Edit} Edit
 * @typedef {import("assur/types/edit.js").Mend} Mend
 */

export class Reasons {
  #page;
  #reasons = make("div", { id: "draw-reasons", class: "draw-reasons", role: "status" });
  #mends = make("div", { id: "draw-mends", class: "draw-mends" });
  elements = [this.#reasons, this.#mends];

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
  }

  /**
   * @param {import("assur/state/model.js").AnySnapshot} snapshot
   * @param {import("assur/state/state.js").Documents["linkage"]} document
   */
  show({ summary, words }, document) {
    if (summary.moves) {
      render(html`<p>${words.text("draw.moves")}</p>`, this.#reasons);
      render([], this.#mends);
      return;
    }
    const told = /** @type {import("assur/types/web.js").DraftSummary} */ (/** @type {unknown} */ (summary));
    const said = (/** @type {import("assur/core/problem.js").Problem} */ reason) => (
      reason.code === "no_driver" && document.links.length === 0 ? words.text("draw.empty") : sentence(reason, words, document)
    );
    const reasons = told.reasons.map((reason) => html`<p data-code=${reason.code} class=${tone(reason.code)}>${said(reason)}</p>`);
    render(reasons.length > 0 ? reasons : html`<p>${words.text("draw.sound")}</p>`, this.#reasons);
    /** @type {readonly { wanted: Edit, text: string }[]} */
    const mends = told.reasons.length === 0
      ? [{ wanted: { edit: "move", points: [], by: [0, 0] }, text: words.text("draw.mend.go") }]
      : told.mends.map((mend) => ({ wanted: mending(mend), text: mendText(mend, words) }));
    render(mends.map(({ wanted, text }) => html`<button class="control" type="button" @click=${() => step(this.#page, wanted)}>${text}</button>`), this.#mends);
  }
}

/** @param {string} code of a reason */
function tone(code) {
  if (code === "locked" || code === "instant") return "draw-locked";
  return code === "loose" || code === "underdriven" ? "draw-loose" : "";
}

/**
 * @param {Mend} mend
 * @returns {Edit}
 */
function mending(mend) {
  if ("drive" in mend) return { edit: "drive", link: mend.drive };
  if ("release" in mend) return { edit: "drive", link: mend.release };
  if ("remove" in mend) return { edit: "remove", points: [], links: [mend.remove] };
  if ("exact" in mend) return { edit: "make_exact" };
  return { edit: "fix", point: mend.fix };
}

/**
 * @param {Mend} mend
 * @param {import("assur/core/words.js").Words} words
 */
function mendText(mend, words) {
  if ("exact" in mend) return words.text("draw.mend.exact", { n: mend.exact.point, by: words.length(words.numbers.short(mend.exact.by)) });
  const [[name, of]] = Object.entries(mend);
  return words.text(`draw.mend.${name}`, { n: name === "fix" ? of : called(of, words) });
}
