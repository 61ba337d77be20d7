// Above the plots: what is plotted, by what the derivatives are, and how the crank turns where they are by time.
import { NumberBox } from "assur/controls/number-box.js";
import { byId, make } from "assur/core/dom.js";
import { subscript } from "assur/core/symbols.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/core/numbers.js").Numbers} Numbers
 * @typedef {import("assur/state/state.js").View} View
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Radians per second in the units of ω₁. */
const UNITS = Object.freeze({ rad_per_s: 1, per_min: Math.PI / 30 });

export class PlotBar {
  #engine;
  #plot = byId("plot", HTMLSelectElement);
  #axes = byId("axes", HTMLSelectElement);
  #unit = byId("omega-unit", HTMLSelectElement);
  #input = byId("input", HTMLElement);
  #note = byId("input-note", HTMLElement);
  #omega;
  #epsilon;
  /** @type {readonly string[]} the points that can be chosen */
  #points = [];
  /** @type {readonly unknown[]} what was shown last */
  #shown = [];

  /**
   * @param {import("assur/app/page.js").Page} page
   */
  constructor({ store, engine, drafts }) {
    this.#engine = engine;
    const look = (/** @type {Partial<View>} */ change) => store.update((state) => withView(state, change));
    this.#plot.addEventListener("change", () => look({ plot: this.#plot.value }));
    this.#axes.addEventListener("change", () => look({ axes: /** @type {View["axes"]} */ (this.#axes.value) }));
    this.#unit.addEventListener("change", () => {
      drafts.drop("omega");
      look({ omega_unit: /** @type {View["omega_unit"]} */ (this.#unit.value) });
    });
    this.#omega = new NumberBox(byId("omega", HTMLInputElement), "omega", drafts, (value) => {
      look({ omega: value * UNITS[store.get().view.omega_unit] });
      return store.get().view.omega;
    });
    this.#epsilon = new NumberBox(byId("epsilon", HTMLInputElement), "epsilon", drafts, (value) => {
      look({ epsilon: value });
      return value;
    });
  }

  /** @param {Snapshot} snapshot */
  render({ state: { view }, kind, words, problems }) {
    const { plot, axes, omega, omega_unit: unit, epsilon, true_time: trueTime } = view;
    const { points } = this.#engine;
    const wrong = ["omega", "epsilon"].map((name) => problems.some(({ field }) => field === name));
    const shown = [points, plot, axes, omega, unit, epsilon, trueTime, words, ...wrong];
    if (shown.every((part, i) => part === this.#shown[i])) return;
    if (words !== this.#shown[7] || points !== this.#points) this.#offer(points, words, kind);
    this.#shown = shown;
    this.#plot.value = plot;
    this.#axes.value = axes;
    this.#unit.value = unit;
    this.#input.hidden = axes === "analogues" && !trueTime;
    this.#omega.show(omega, both(omega / UNITS[unit], words.numbers), wrong[0]);
    this.#epsilon.show(epsilon, both(epsilon, words.numbers), wrong[1]);
    this.#note.hidden = epsilon === 0 || !trueTime;
  }

  /**
   * @param {readonly string[]} points
   * @param {Words} words
   * @param {string} shown the kind of what is
   */
  #offer(points, words, shown) {
    this.#points = points;
    if (shown !== "mixer") {
      const option = (/** @type {string} */ value, /** @type {string} */ key, /** @type {string} */ name) =>
        make("option", { value }, [words.text(key, { name })]);
      this.#plot.replaceChildren(
        option("angles", "plots.links", ""),
        ...this.#engine.links.map((name) => option(`${name}.angle`, "plots.link", name)),
        ...points.map((name) => option(name, "plots.point", subscript(name))),
      );
      return;
    }
    const options = points.map((value) => {
      const kind = /^C\d/.test(value) ? "plots.centre" : value.startsWith("P") ? "plots.traced" : "plots.joint";
      return make("option", { value }, [words.text(kind, { name: subscript(value) })]);
    });
    this.#plot.replaceChildren(make("option", { value: "angles" }, [words.text("plots.angles")]), ...options);
  }
}

/**
 * @param {number} value
 * @param {Numbers} numbers
 */
function both(value, numbers) {
  return { brief: numbers.brief(value), full: numbers.exact(value) };
}
