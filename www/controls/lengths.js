// Choice of the unit of length. Choosing another unit changes the unit shown beside the numbers, not the numbers.
import { byId, make } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { withDocument } from "assur/state/state.js";

/** Units of lengths; `unit.…` are the keys of their names. */
const UNITS = Object.freeze(/** @type {const} */ (["m", "cm", "mm", "in", "none"]));

export class LengthUnits {
  #engine;
  #select = byId("unit", HTMLSelectElement);
  #row = byId("units", HTMLElement);
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store, engine, model }) {
    this.#engine = engine;
    this.#select.append(...UNITS.map((unit) => make("option", { value: unit, "data-t": `unit.${unit}` })));
    this.#select.addEventListener("change", () => {
      const unit = UNITS[this.#select.selectedIndex];
      if (model.accepted && engine.choosesLengths) store.update((state) => withDocument(state, { unit }));
    });
  }

  /** @param {import("assur/state/model.js").AnySnapshot} snapshot */
  render({ summary }) {
    const { lengths, choosesLengths } = this.#engine;
    if (this.#shown.same(summary, lengths)) return;
    this.#row.hidden = !choosesLengths;
    this.#select.value = lengths;
  }
}
