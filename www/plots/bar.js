// The bar above the plots: choice of the plotted quantities, choice of the variable of differentiation, and rates of the input.
import { NumberBox } from "assur/controls/number-box.js";
import { byId, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { partsOf } from "assur/core/quantity.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { derived } from "assur/core/units.js";
import { PairChoice, furtherOptions, pointsOfFrame } from "assur/plots/pairs.js";
import { whose } from "assur/plots/readouts.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").View} View
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/details.js").MotionSummary["transmissions"][number]} Transmission
 */

/** @type {readonly Transmission[]} */
const NONE = Object.freeze([]);

/** Units of ω₁, in radians per second. */
const UNITS = Object.freeze({ rad_per_s: 1, per_min: Math.PI / 30 });

export class PlotBar {
  #engine;
  #page;
  #plot = byId("plot", HTMLSelectElement);
  #only = byId("only", HTMLSelectElement);
  #axes = byId("axes", HTMLSelectElement);
  #unit = byId("omega-unit", HTMLSelectElement);
  #input = byId("input", HTMLElement);
  #note = byId("input-note", HTMLElement);
  #pairs;
  #omega;
  #epsilon;
  #shown = new Seen();
  #offered = new Seen();
  #named = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    const { store, engine, model, drafts } = page;
    this.#engine = engine;
    this.#page = page;
    this.#pairs = new PairChoice(page);
    const look = (/** @type {Partial<View>} */ change) => store.update((state) => withView(state, change));
    this.#plot.addEventListener("change", () => {
      const against = this.#pairs.pair(this.#plot.value);
      look(against ? { against } : { against, plot: this.#plot.value });
    });
    this.#only.addEventListener("change", () => look({ only: /** @type {View["only"]} */ (this.#only.value) }));
    this.#axes.addEventListener("change", () => look({ axes: /** @type {View["axes"]} */ (this.#axes.value) }));
    this.#unit.addEventListener("change", () => {
      drafts.drop("omega");
      look({ omega_unit: /** @type {View["omega_unit"]} */ (this.#unit.value) });
    });
    this.#omega = new NumberBox(byId("omega", HTMLInputElement), "omega", drafts, (value) => {
      look({ omega: value * this.#per(model.coordinate.moves, store.get().view.omega_unit) });
      return store.get().view.omega;
    });
    this.#epsilon = new NumberBox(byId("epsilon", HTMLInputElement), "epsilon", drafts, (epsilon) => look({ epsilon }));
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state: { view }, summary, coordinate, words, problems } = snapshot;
    const { overviews } = summary;
    const transmissions = "transmissions" in summary ? summary.transmissions : NONE;
    const { plot, against, measures, only, axes, omega, omega_unit: unit, epsilon, true_time: trueTime } = view;
    const { points } = this.#engine.names;
    const wrong = ["omega", "epsilon"].map((name) => problems.some(({ field }) => field === name));
    const { moves } = coordinate;
    if (this.#shown.same(points, plot, axes, omega, unit, epsilon, trueTime, words, moves, only, against, measures, summary, ...wrong)) return;
    const names = [pointsOfFrame(snapshot.state), transmissions.map(({ what, joint }) => `${joint}.${what}`), measures, overviews, this.#page.furtherPlots().map(({ name }) => name)];
    if (!this.#offered.same(words, points, names.join("/"))) this.#offer(snapshot, points, transmissions);
    if (!this.#named.same(words, moves)) this.#name(coordinate, words);
    this.#plot.value = plot;
    this.#pairs.show(against, this.#plot, snapshot);
    this.#only.value = only;
    // Forces have no derivatives.
    this.#only.hidden = against !== null || this.#page.furtherPlots().some(({ name }) => name === plot);
    this.#axes.value = axes;
    this.#unit.value = unit;
    this.#axes.hidden = moves === "time";
    this.#input.hidden = moves === "time" || (axes === "analogues" && !trueTime);
    this.#unit.hidden = moves !== "angle";
    this.#omega.show(omega, both(omega / this.#per(moves, unit), words.numbers), wrong[0]);
    this.#epsilon.show(epsilon, both(epsilon, words.numbers), wrong[1]);
    this.#note.hidden = epsilon === 0 || !trueTime;
  }

  /**
   * @param {string} moves
   * @param {View["omega_unit"]} unit
   * @returns {number} factor from the unit to the engine's unit
   */
  #per(moves, unit) {
    return moves === "angle" ? UNITS[unit] : 1;
  }

  /**
   * @param {import("assur/state/coordinate.js").Coordinate} coordinate
   * @param {Words} words
   */
  #name({ moves, rates }, words) {
    if (moves === "time") return;
    const of = moves === "angle" ? words.text("unit.rad") : words.unit;
    const unit = (/** @type {number} */ order) => derived(of, words.text("unit.s"), order);
    const said = (/** @type {string} */ key, order = 1) => words.text(`input.${key}.${moves}`, { unit: unit(order) });
    for (const [i, name] of /** @type {const} */ (["omega", "epsilon"]).entries()) {
      write(byId(`${name}-symbol`, HTMLElement), rates[i]);
      byId(name, HTMLInputElement).ariaLabel = said(name, i + 1);
    }
    byId("epsilon", HTMLInputElement).title = said("instant");
    write(byId("epsilon-unit", HTMLElement), unit(2));
    write(this.#note, said("true_time"));
    const physical = this.#axes.options.namedItem("axes-physical");
    if (physical) write(physical, words.text(`axes.physical.${moves}`));
  }

  /**
   * @param {Snapshot} snapshot
   * @param {readonly string[]} points
   * @param {readonly Transmission[]} transmissions
   */
  #offer(snapshot, points, transmissions) {
    const { summary: { overviews }, state: { view: { measures } }, words } = snapshot;
    const options = [
      ...overviews.map((name) => [name, words.text(`plots.overview.${name}`)]),
      ...this.#engine.names.links.map((link) => [`${link}.angle`, words.text("plots.link", { name: called(link, words) })]),
      ...points.map((point) => [point, words.text("plots.point", { name: subscript(point) })]),
      ...transmissions.map(({ what, joint }) => [`${joint}.${what}`, whose({ what, of: [joint] }, words)]),
      ...measures.map((name) => [name, measure(name, words)]),
    ];
    render([options.map(([value, text]) => html`<option value=${value}>${text}</option>`), furtherOptions(this.#page.furtherPlots(), words), this.#pairs.offered(snapshot)], this.#plot);
  }
}

/**
 * @param {string} name of a measure
 * @param {Words} words
 * @returns {string} the measure's name for readers
 */
function measure(name, words) {
  const { of, what } = partsOf(name);
  return whose({ what: /** @type {import("assur/types/web.js").ListedSummary["what"]} */ (what), of: [of] }, words);
}

/**
 * @param {number} value
 * @param {import("assur/core/numbers.js").Numbers} numbers
 */
function both(value, numbers) {
  return { brief: numbers.brief(value), full: numbers.exact(value) };
}
