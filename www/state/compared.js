// Mechanism A, compared with the shown mechanism B. A has its own simulator and the input of B, and is never edited.
import { NotLoaded } from "assur/core/parts.js";
import { problemsOf } from "assur/core/problem.js";
import { Seen } from "assur/core/seen.js";
import { Names, Readouts } from "assur/state/readouts.js";
import { PARTS, initialState, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/types/web.js").Summary} Summary
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/pkg/assur_web.js").Simulator} Simulator
 * @typedef {{ scene: Float32Array, labels: readonly string[], revision: number, frame: Float32Array, readouts: Readouts | null }} Comparison
 * mechanism A at an input, with the same data as the drawing of B; `revision`: number of mechanisms that have been A so far
 */

/** Fields of the view that A shares with B: quantities plotted and read, and the input rate. */
const SHARED = Object.freeze(/** @type {const} */ (["traces", "measures", "plot", "against", "axes", "omega", "omega_unit", "epsilon", "true_time"]));

/** Kinds of input with which mechanisms can be compared. */
const INPUTS = Object.freeze(["angle", "length"]);

/**
 * Frees a simulator. A simulator in which a call has trapped stays borrowed, and cannot be freed.
 * @param {Simulator} simulator
 */
export function discard(simulator) {
  try {
    simulator.free();
  } catch (thrown) {
    console.error(thrown);
  }
}

export class Compared {
  /** @type {Simulator | null} simulator of A, if A can be shown */
  simulator = null;
  /** Whether a call of A's simulator has broken off, which makes the instance of the engine unusable. */
  broken = false;
  #newSimulator;
  #seen = new Seen();
  /** @type {Summary | null} */
  #summary = null;
  /** @type {Omit<Comparison, "frame" | "readouts">} */
  #drawn = { scene: new Float32Array(), labels: [], revision: 0 };
  #names = new Names([]);
  /** Whether A and B have the same kind of input. */
  #alike = false;

  /** @param {() => Simulator} newSimulator */
  constructor(newSimulator) {
    this.#newSimulator = newSimulator;
  }

  /**
   * Makes A from the state, if A or a field of the view that it shares with B has changed.
   * @param {State} state
   * @param {Summary} summary of B
   * @returns {Summary} the summary with bounds that also contain A, if A is shown
   */
  follow(state, summary) {
    const { compared, view } = state;
    if (!this.#seen.same(compared, ...SHARED.map((name) => view[name]))) this.#take(state);
    const a = this.#summary;
    this.#alike = INPUTS.includes(summary.moves ?? "") && a?.moves === summary.moves;
    if (!a || !this.#alike) return summary;
    const [left, bottom, right, top] = summary.bounds;
    const [ofLeft, ofBottom, ofRight, ofTop] = a.bounds;
    return { ...summary, bounds: [Math.min(left, ofLeft), Math.min(bottom, ofBottom), Math.max(right, ofRight), Math.max(top, ofTop)] };
  }

  /** @returns {Simulator | null} simulator of A, if A is shown */
  get shown() {
    return this.#alike ? this.simulator : null;
  }

  /**
   * @param {number} input
   * @returns {Comparison | null} null if A is not shown or cannot be assembled
   */
  at(input) {
    const simulator = this.shown;
    if (!simulator) return null;
    try {
      const { frame, readouts } = simulator.at(input);
      return { ...this.#drawn, frame, readouts: Readouts.of(this.#names, readouts) };
    } catch (thrown) {
      this.#noteBreak(thrown);
      return null;
    }
  }

  /** Hides A until another A is chosen or a field of the view that A shares with B changes. */
  hide() {
    this.broken = false;
    this.simulator = null;
    this.#summary = null;
  }

  /** Forgets A's simulator, which was lost with the instance of the engine. The next state makes a new one. */
  takeAnew() {
    this.hide();
    this.#seen = new Seen();
  }

  /** @param {State} state */
  #take({ compared, view }) {
    this.#drop();
    if (!compared) return;
    const shared = Object.fromEntries(SHARED.map((name) => [name, view[name]]));
    const state = initialState(compared.kind, compared.document, shared);
    // A may lack the quantities plotted or measured on B: the second attempt is without them.
    for (const wanted of [state, withView(state, PARTS)]) {
      if (this.broken) return;
      const simulator = this.#newSimulator();
      try {
        this.#summary = /** @type {Summary} */ (simulator.set(wanted));
        this.#names = new Names(simulator.readouts());
        this.#drawn = { scene: simulator.scene(), labels: simulator.labelNames(), revision: this.#drawn.revision + 1 };
        this.simulator = simulator;
        return;
      } catch (thrown) {
        this.#noteBreak(thrown);
        discard(simulator);
      }
    }
  }

  /**
   * Records whether A's simulator broke.
   * @param {unknown} thrown refusal of the engine, or the exception of a trap
   */
  #noteBreak(thrown) {
    if (problemsOf(thrown)) return;
    console.error(thrown);
    // If A needs a part of the engine that has not loaded, the next state tries A again.
    if (thrown instanceof NotLoaded) this.takeAnew();
    else this.hide();
    this.broken = true;
  }

  #drop() {
    if (this.simulator) discard(this.simulator);
    this.simulator = null;
    this.#summary = null;
  }
}
