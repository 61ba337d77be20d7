// Reactions and applied forces at the current input. Loaded on demand.
import { byId, make } from "assur/core/dom.js";

/** @typedef {import("assur/state/model.js").Snapshot} Snapshot */

export class Forces {
  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.element = make("section", { id: "forces-shown", "data-field": "forces" }, [make("h2", { "data-t": "forces.heading" })]);
    byId("readouts", HTMLTableElement).after(this.element);
    page.words.fill(this.element);
  }

  /** @param {Snapshot} snapshot */
  render({ state, stale }) {
    if (!stale) this.element.hidden = !state.view.forces;
  }
}
