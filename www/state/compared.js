// Mechanism A, with which the one that is shown, B, is compared: a simulator of its own at the same input. It stays as it is.
import { Seen } from "assur/core/seen.js";
import { PARTS, initialState, withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/engine.js").Summary} Summary
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/pkg/assur_web.js").Simulator} Simulator
 * @typedef {{ scene: Float32Array, labels: readonly string[], revision: number, frame: Float64Array, readouts: import("assur/engine.js").Readouts | null }} Beside
 * A at an input: what the drawing of B has as well; `revision` counts the mechanisms that were A
 */

/** What of the view A shares with B: what is plotted and read, and by what. */
const SHARED = Object.freeze(/** @type {const} */ (["traces", "measures", "plot", "against", "axes", "omega", "omega_unit", "epsilon", "true_time"]));

/** Of mechanisms that go by these inputs one can be beside the other. */
const INPUTS = Object.freeze(["angle", "length"]);

/**
 * Frees a simulator. One whose call trapped cannot be freed: it counts as borrowed for ever.
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
  /** @type {Simulator | null} with A, where it can be shown */
  simulator = null;
  /** Whether its simulator has trapped: the instance of the engine is of no use any more. */
  broken = false;
  #newSimulator;
  #seen = new Seen();
  /** @type {Summary | null} */
  #summary = null;
  /** @type {Omit<Beside, "frame" | "readouts">} */
  #drawn = { scene: new Float32Array(), labels: [], revision: 0 };
  /** @type {readonly string[]} */
  #names = [];
  /** Whether both go by inputs of one sort. */
  #alike = false;

  /** @param {() => Simulator} newSimulator */
  constructor(newSimulator) {
    this.#newSimulator = newSimulator;
  }

  /**
   * @param {State} state
   * @param {Summary} summary of B
   * @returns {Summary} the same, of a drawing that has room for A
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

  /** @returns {Simulator | null} with A, where it is shown */
  get shown() {
    return this.#alike ? this.simulator : null;
  }

  /**
   * @param {number} input
   * @param {import("assur/engine.js").Engine} engine
   * @returns {Beside | null} none where A is not shown, or cannot be assembled
   */
  at(input, engine) {
    const simulator = this.shown;
    if (!simulator) return null;
    try {
      const { frame, values } = engine.placeOf(simulator, input);
      const readouts = values.length > 0 ? Object.fromEntries(this.#names.map((name, i) => [name, values[i]])) : null;
      return { ...this.#drawn, frame, readouts };
    } catch (thrown) {
      this.#noteBreak(thrown);
      return null;
    }
  }

  /** Shows A no more until another one comes. */
  hide() {
    this.broken = false;
    this.simulator = null;
    this.#summary = null;
  }

  /** Its simulator is gone with the instance of the engine: A is taken anew with the next state. */
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
    // A may lack what is plotted or measured of B.
    for (const wanted of [state, withView(state, PARTS)]) {
      if (this.broken) return;
      const simulator = this.#newSimulator();
      try {
        this.#summary = /** @type {Summary} */ (simulator.set(wanted));
        this.#names = simulator.readoutNames();
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
   * Notes that its simulator broke, if it did.
   * @param {unknown} thrown problems, or by a trap
   */
  #noteBreak(thrown) {
    if (Array.isArray(thrown)) return;
    console.error(thrown);
    this.hide();
    this.broken = true;
  }

  #drop() {
    if (this.simulator) discard(this.simulator);
    this.simulator = null;
    this.#summary = null;
  }
}
