// Force plans, Zhukovsky's lever and free bodies at the current input. Loaded on demand.
import { byId, make } from "assur/core/dom.js";

/** @typedef {import("assur/state/model.js").Snapshot} Snapshot */

export class ForcePlan {
  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.element = make("section", { id: "force-plan-shown", "data-field": "force_plan" }, [make("h2", { "data-t": "force_plan.heading" })]);
    byId("readouts", HTMLTableElement).after(this.element);
    page.words.fill(this.element);
  }

  /** @param {Snapshot} snapshot */
  render({ state, stale }) {
    if (!stale) this.element.hidden = !state.view.force_plan;
  }
}
