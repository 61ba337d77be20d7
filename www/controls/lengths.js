// What the lengths of the document are in. Another unit is another name beside its numbers, which stay.
import { byId, make } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { edited, lengthsOf } from "assur/state/state.js";

/** Those there are, with the words `unit.…`. */
const UNITS = Object.freeze(/** @type {const} */ (["m", "cm", "mm", "in", "none"]));

/** The kinds of documents that may choose. */
const CHOOSING = Object.freeze(/** @type {const} */ (["linkage", "mixer", "synthesis"]));

export class LengthUnits {
  #select = byId("unit", HTMLSelectElement);
  #row = byId("units", HTMLElement);
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store }) {
    this.#select.append(...UNITS.map((unit) => make("option", { value: unit, "data-t": `unit.${unit}` })));
    this.#select.addEventListener("change", () => {
      const unit = UNITS[this.#select.selectedIndex];
      store.update((state) => CHOOSING.reduce((changed, kind) => edited(changed, kind, () => ({ unit })), state));
    });
  }

  /** @param {import("assur/state/model.js").AnySnapshot} snapshot */
  render({ state }) {
    if (this.#shown.same(state.kind, state.document)) return;
    this.#row.hidden = !CHOOSING.some((kind) => kind === state.kind);
    this.#select.value = lengthsOf(state);
  }
}
