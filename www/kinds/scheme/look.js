// Direction of view of a spatial scheme.
import { NumberRow } from "assur/controls/number-row.js";
import { section } from "assur/controls/section.js";
import { edited } from "assur/state/state.js";

/** @typedef {import("assur/kinds/scheme/opening.js").Snapshot} Snapshot */

const ROWS = Object.freeze([
  { field: "look.round", symbol: "↻", role: "secondary", unit: "°", slider: { min: -180, max: 180, step: 1 } },
  { field: "look.above", symbol: "↕", role: "secondary", unit: "°", slider: { min: -90, max: 90, step: 1 } },
]);

export class LookView {
  #rows;
  #element;

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store, drafts }) {
    const looked = (/** @type {number} */ at, /** @type {number} */ value) => store.update((state) => edited(state, "scheme", ({ look_deg: [round, above] }) => {
      /** @type {[number, number]} */
      const look = at === 0 ? [value, above] : [round, value];
      return { look_deg: look };
    }));
    this.#rows = ROWS.map((kind, at) => new NumberRow(kind, drafts, (value) => looked(at, value)));
    this.#element = section("scheme", "look.heading", "look", this.#rows.map(({ element }) => element));
  }

  /** @param {Snapshot} snapshot */
  render({ state: { document }, words, problems }) {
    this.#element.hidden = document.planar;
    const wrong = problems.some(({ field }) => field === "look_deg");
    this.#rows.forEach((row, at) => row.show(document.look_deg[at], words, wrong));
  }
}
