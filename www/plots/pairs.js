// Choice of two quantities to plot against each other: usual pairs in the list of plots, and two lists for other pairs.
import { byId } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { partsOf } from "assur/core/quantity.js";
import { Seen } from "assur/core/seen.js";
import { MEASURES, calledWhole, subscript, symbol } from "assur/core/symbols.js";
import { outputsOf } from "assur/state/details.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").View} View
 * @typedef {NonNullable<View["against"]>} Pair
 * @typedef {Readonly<{ name: string, text: string, vector?: string }>} Further a force that can be plotted. `vector`: name of its hodograph for readers, if
 * it is a vector, whose components are named with `_x` and `_y`
 */

/** Name of the input in a pair. */
const INPUT = "input";

/** Separator between the two names of a usual pair; no name of a quantity contains it. */
const MARK = "|";

/** Choice, in the list of plots, that opens the two lists. */
const OWN = `${MARK}own`;

const ORDERS = Object.freeze([0, 1, 2]);

/**
 * @param {Pair} pair
 * @returns {string} the pair as a value of the list of plots
 */
function chosen({ x, y }) {
  return `${x}${MARK}${y}`;
}

/**
 * @param {string} name of a quantity
 * @param {number} order
 * @returns {string} name of the derivative, as in the headings of exported tables
 */
function derivative(name, order) {
  const { of, what } = partsOf(name);
  return `${of}.${"d".repeat(order)}${what}`;
}

export class PairChoice {
  #engine;
  #model;
  #lists = byId("against", HTMLElement);
  #y = byId("against-y", HTMLSelectElement);
  #x = byId("against-x", HTMLSelectElement);
  #built = new Seen();

  #further;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    const { store, engine, model } = page;
    this.#engine = engine;
    this.#model = model;
    this.#further = () => page.furtherPlots();
    for (const list of [this.#x, this.#y]) {
      list.addEventListener("change", () => store.update((state) => withView(state, { against: { x: this.#x.value, y: this.#y.value } })));
    }
  }

  /**
   * @param {string} choice value of the list of plots
   * @returns {Pair | null} the pair that the choice stands for, or null if it is not a pair
   */
  pair(choice) {
    if (!choice.includes(MARK)) return null;
    if (choice !== OWN) {
      const [x, y] = choice.split(MARK);
      return { x, y };
    }
    const names = this.#engine.names.quantities;
    const { summary } = this.#model;
    const output = outputsOf(summary)[0]?.name;
    const y = output ?? names[names.length - 1];
    return y === undefined ? null : { x: names.find((name) => name !== y) ?? INPUT, y };
  }

  /**
   * @param {Snapshot} snapshot
   * @returns choices of pairs for the list of plots
   */
  offered({ state, summary, words }) {
    const option = (/** @type {string} */ key, /** @type {string} */ x, /** @type {string} */ y, /** @type {string} */ name) =>
      html`<option value=${chosen({ x, y })}>${words.text(key, { name })}</option>`;
    const { quantities } = this.#engine.names;
    const still = pointsOfFrame(state);
    const points = this.#engine.names.points.filter((point) => !still.includes(point));
    // For a mechanism without an output, the pairs of all its angles are offered.
    const named = outputsOf(summary).map(({ name }) => name);
    const outputs = named.length > 0 ? named : quantities.filter((name) => name.endsWith("angle"));
    const whose = (/** @type {string} */ name) => {
      const { of, what } = partsOf(name);
      if (what === "load_angle") return words.text("readouts.load_angle", { name: called(of, words) });
      if (what === "angle") return called(of, words);
      return /^[xy]$/.test(what) ? `${what} ${subscript(of)}` : calledWhole(of, what, words);
    };
    return html`<optgroup label=${words.text("plots.against")}>${[
      ...points.map((point) => option("plots.path", `${point}.x`, `${point}.y`, subscript(point))),
      ...points.map((point) => option("plots.hodograph", `${point}.dx`, `${point}.dy`, subscript(point))),
      ...outputs.map((name) => option("plots.over_input", INPUT, name, whose(name))),
      ...outputs.map((name) => option("plots.phase", name, derivative(name, 1), whose(name))),
      html`<option value=${OWN}>${words.text("plots.pair")}</option>`,
    ]}</optgroup>`;
  }

  /**
   * @param {View["against"]} against
   * @param {HTMLSelectElement} plot list of plots
   * @param {Snapshot} snapshot
   */
  show(against, plot, snapshot) {
    this.#lists.hidden = !against;
    if (!against) return;
    plot.value = chosen(against);
    if (plot.selectedIndex < 0) plot.value = OWN;
    this.#build(snapshot);
    this.#x.value = against.x;
    this.#y.value = against.y;
  }

  /** @param {Snapshot} snapshot */
  #build(snapshot) {
    const { summary, state, coordinate, words } = snapshot;
    const transmissions = "transmissions" in summary ? summary.transmissions.map(({ what, joint }) => `${joint}.${what}`) : [];
    const names = [...this.#engine.names.quantities, ...transmissions];
    const physical = state.view.axes === "physical" || coordinate.moves === "time";
    const further = this.#further();
    if (this.#built.same(JSON.stringify([names, physical, coordinate.symbol, summary.numbers, further]), words)) return;
    const forces = further.flatMap(({ name, text, vector }) => [[name, text], ...(vector ? [[`${name}_x`, `${text}, x`], [`${name}_y`, `${text}, y`]] : [])]);
    const options = [listed(names, summary.numbers, physical, words), forces.length > 0 ? html`<optgroup label=${words.text("forces.plots")}>${forces.map(([name, text]) => html`<option value=${name}>${text}</option>`)}</optgroup>` : nothing];
    render(options, this.#y);
    render([html`<option value=${INPUT}>${coordinate.symbol}</option>`, options], this.#x);
  }
}

/**
 * @param {readonly Further[]} further
 * @param {import("assur/core/words.js").Words} words
 * @returns choices of forces for the list of plots: each by the input, and the hodographs of vectors
 */
export function furtherOptions(further, words) {
  if (further.length === 0) return nothing;
  return html`<optgroup label=${words.text("forces.plots")}>${further.map(({ name, text }) => html`<option value=${name}>${text}</option>`)}${further.map(({ name, vector }) => (vector ? html`<option value=${chosen({ x: `${name}_x`, y: `${name}_y` })}>${vector}</option>` : nothing))}</optgroup>`;
}

/**
 * @param {import("assur/state/state.js").State} state
 * @returns {readonly string[]} fixed pivots and the points of fixed guides, which have neither path nor hodograph
 */
export function pointsOfFrame({ document }) {
  return "frame" in document && Array.isArray(document.frame) ? document.frame : [];
}

/**
 * @param {readonly string[]} names of quantities
 * @param {Readonly<Record<string, string>>} numbers of links
 * @param {boolean} physical whether derivatives are with respect to time
 * @param {import("assur/core/words.js").Words} words
 * @returns options for the quantities and their derivatives, grouped by link or point
 */
function listed(names, numbers, physical, words) {
  /** @type {Map<string, { owner: string, point: boolean, own: string[] }>} groups by key; the key of a link differs from that of a point of the same name */
  const groups = new Map();
  for (const name of names) {
    const { of: owner, what } = partsOf(name);
    const point = !what.endsWith("angle");
    const key = `${point} ${owner}`;
    groups.set(key, { owner, point, own: [...(groups.get(key)?.own ?? []), name] });
  }
  return [...groups.values()].map(({ owner, point, own }) => {
    const measured = MEASURES.find((what) => own.some((name) => name.endsWith(`.${what}`)));
    const label = measured ? calledWhole(owner, measured, words) : point ? words.text("plots.point", { name: subscript(owner) }) : called(owner, words);
    const options = own.flatMap((name) =>
      ORDERS.map((order) => {
        const spelled = symbol({ name, number: numbers[owner] }, order, physical, words);
        const text = /\.[xy]$/.test(name) ? `${spelled} ${subscript(owner)}` : spelled;
        return html`<option value=${derivative(name, order)}>${text}</option>`;
      }),
    );
    return html`<optgroup label=${label}>${options}</optgroup>`;
  });
}
