// The wheels of a train: arrangement, coupling, plates or teeth, number of satellites, module, axis distance.
import { NumberRow } from "assur/controls/number-row.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { Choice } from "assur/kinds/gear-train/choice.js";
import { edited } from "assur/state/state.js";

/** @typedef {import("assur/kinds/gear-train/drives.js").Document} Document */

/** @type {readonly (import("assur/controls/number-row.js").RowKind & { field: "z1" | "z2" | "z2_step" | "z4" | "satellites" | "module_mm" })[]} */
const ROWS = Object.freeze([
  { field: "z1", symbol: "z₁", role: "crank", slider: { min: 6, max: 60, step: 1 } },
  { field: "z2", symbol: "z₂", role: "coupler", slider: { min: 6, max: 60, step: 1 } },
  { field: "z2_step", symbol: "z₂′", role: "coupler", slider: { min: 6, max: 60, step: 1 } },
  { field: "z4", id: "z4_ring", key: "z4_ring", symbol: "z₄", role: "accent2", slider: { min: 12, max: 120, step: 1 } },
  { field: "satellites", symbol: "k", role: "rocker", slider: { min: 1, max: 6, step: 1 } },
  { field: "module_mm", symbol: "m", role: "secondary", slider: { min: 1, max: 10, step: 0.5 } },
]);

export class WheelsView {
  #form;
  #coupling;
  #poles;
  #rows;
  #distance;
  #equal = make("button", { id: "train-equal-gaps", class: "control add", type: "button", "data-t": "axis_distance.equal" });
  #gaps = make("p", { id: "train-gaps" });
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ store, drafts }) {
    const edit = (/** @type {Partial<Document>} */ change) => store.update((state) => edited(state, "gear-train", () => change));
    this.#form = new Choice("form", ["planar", "stepped", "bevel"], (value) => `form.${value}`, (value) => {
      const form = /** @type {Document["form"]} */ (value);
      // A satellite that becomes stepped starts with two equal wheels.
      store.update((state) => edited(state, "gear-train", ({ z2, z2_step: step }) => ({ form, z2_step: form === "stepped" ? (step ?? z2) : null })));
    });
    this.#coupling = new Choice("coupling", ["magnetic", "contact"], (value) => `coupling.${value}`, (value) => edit({ coupling: /** @type {Document["coupling"]} */ (value) }));
    this.#poles = new Choice("magnets.poles", ["alike", "alternating"], (value) => `poles.${value}`, (value) => {
      store.update((state) => edited(state, "gear-train", ({ magnets }) => ({ magnets: /** @type {Document["magnets"]} */ ({ ...magnets, poles: value }) })));
    });
    this.#rows = ROWS.map((kind) => ({ field: kind.field, row: new NumberRow(kind, drafts, (value) => edit({ [kind.field]: value })) }));
    this.#distance = new NumberRow({ field: "axis_distance_mm", symbol: "a_w", role: "rocker" }, drafts, (value) => edit({ axis_distance_mm: value }));
    this.#equal.addEventListener("click", () => {
      drafts.drop("axis_distance_mm");
      edit({ axis_distance_mm: null });
    });
    section("gear-train", "train.wheels", "wheels", [
      this.#form.element, this.#coupling.element, this.#poles.element, ...this.#rows.map(({ row }) => row.element),
      this.#distance.element, this.#equal, this.#gaps,
    ]);
  }

  /** @param {import("assur/kinds/gear-train/drives.js").Snapshot} snapshot */
  render({ state: { document }, summary, words, problems }) {
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(document, summary, words, ...wrong)) return;
    const { form = "planar", coupling = "magnetic", magnets } = document;
    this.#form.show(form);
    this.#coupling.show(coupling);
    this.#poles.show(magnets?.poles ?? "alike");
    const apart = coupling === "magnetic" && form !== "bevel";
    this.#poles.element.hidden = coupling !== "magnetic";
    this.#distance.element.hidden = this.#equal.hidden = this.#gaps.hidden = !apart;
    for (const { field, row } of this.#rows) {
      const value = document[field];
      row.element.hidden = value == null;
      if (value != null) row.show(value, words, wrong.has(field));
    }
    this.#distance.show(document.axis_distance_mm ?? summary.axis_distance, words, wrong.has("axis_distance_mm"));
    this.#equal.disabled = document.axis_distance_mm == null;
    const [sun, ring] = (summary.gaps ?? []).map((gap) => words.numbers.upTo(gap, 3));
    write(this.#gaps, summary.gaps ? words.text("gaps.said", { sun, ring }) : "");
  }
}
