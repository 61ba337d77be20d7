// Motion under load: motor, run in time, steady cycle, flywheel. Loaded on demand.
import { byId, make } from "assur/core/dom.js";

/** @typedef {import("assur/state/model.js").Snapshot} Snapshot */

export class UnderLoad {
  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.element = make("section", { id: "under-load-shown", "data-field": "under_load" }, [make("h2", { "data-t": "under_load.heading" })]);
    byId("readouts", HTMLTableElement).after(this.element);
    page.words.fill(this.element);
  }

  /** @param {Snapshot} snapshot */
  render({ state, stale }) {
    if (!stale) this.element.hidden = !state.view.under_load;
  }
}
