// A list of linkages with their verdicts, of which one is chosen.
import { make } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { choose } from "assur/kinds/point-path/choose.js";
import { FILTERS, missedBy, typeOf, verdictOf } from "assur/kinds/point-path/verdict.js";

/**
 * @typedef {import("assur/kinds/point-path/verdict.js").Found} Found
 * @typedef {import("assur/kinds/point-path/verdict.js").Snapshot} Snapshot
 */

export class TracingList {
  #page;
  #name;
  #body = make("tbody");
  element;

  /**
   * @param {string} name of the list
   * @param {string} key of its description
   * @param {import("assur/app/page.js").Page} page
   */
  constructor(name, key, page) {
    this.#page = page;
    this.#name = name;
    this.element = make("div", { class: "tracings-scroll" }, [make("table", { class: "tracings", "data-t-label": key }, [this.#body])]);
  }

  /**
   * @param {readonly Found[]} all
   * @param {Snapshot} snapshot
   */
  show(all, { state: { document }, summary: { size }, words }) {
    const chosen = JSON.stringify(document.linkage ?? null);
    const row = (/** @type {Found} */ found, /** @type {number} */ k) => {
      const n = k + 1;
      const curve = found.curve === null ? "" : ` ${words.text("path.curve", { n: String(found.curve) })}`;
      return html`<tr data-sound=${FILTERS.sound(found)}><td><label for="${this.#name}-${n}"><input id="${this.#name}-${n}" type="radio" name=${this.#name} .checked=${JSON.stringify(found.linkage) === chosen} @change=${() => choose(this.#page, found.linkage)}> <span>${n}${curve}: ${typeOf(found, words)}</span></label><small>${missedBy(found, size, words)}; ${verdictOf(found, words)}</small></td></tr>`;
    };
    render(all.map(row), this.#body);
  }
}
