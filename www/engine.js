// The engine for the page: one Simulator, mechanism A for comparison, and recovery after a trap in the wasm.
import { guarded } from "assur/core/guarded.js";
import { NotLoaded } from "assur/core/parts.js";
import { Refusal, problemsOf } from "assur/core/problem.js";
import { startEngine } from "assur/core/wasm.js";
import { Catalogue } from "assur/state/catalogue.js";
import { Compared, discard } from "assur/state/compared.js";
import { withDetails } from "assur/state/details.js";
import { Names, Readouts } from "assur/state/readouts.js";
import { withoutExtras } from "assur/state/state.js";
import * as module from "assur/pkg/assur_web.js";

/**
 * @typedef {import("assur/state/state.js").Kind} Kind
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/details.js").Summaries} Summaries
 * @typedef {Omit<import("assur/types/web.js").Here, "readouts" | "plotted"> & { readouts: Readouts | null, plotted: Float64Array | null }} PoseData
 * The mechanism at an input. `readouts` and `plotted` are null if derivatives are unbounded.
 */

export class Engine {
  /** @type {Omit<module.Simulator, "free">} simulator of the page */
  simulator = guarded(() => this.#simulator, (call) => this.ask(call));
  /** @type {Omit<typeof module, "default" | "initSync" | "AllMotions" | "Design" | "NinePointSearch" | "NinePointWorker" | "PathSearch" | "Simulator" | "second" | "__wbg_reset_state">} functions that need no simulator */
  functions = guarded(() => module, (call) => this.ask(call));
  #simulator = new module.Simulator();
  /** @type {State | null} the last state that the simulator accepted */
  #lastAccepted = null;
  #compared = new Compared(() => new module.Simulator());
  /** Number of earlier instances of the module. */
  #instances = 0;
  /** Whether the engine's last failure was a trap. False once the engine accepts a state. */
  trapped = false;
  /** @type {readonly string[]} */
  roles = module.roleNames();
  /** @type {readonly string[]} labels of the display lists */
  labels = [];
  /** @type {import("assur/types/file.js").LengthUnit} unit of lengths in the document */
  lengths = "none";
  /** Symbol unit of linkages, in the unit of lengths; 0 for a hundredth of the drawing's size. */
  symbol = 0;
  /** Whether the document may choose the unit of lengths. */
  choosesLengths = false;
  catalogue = new Catalogue(module.mixers(), () => this.functions.catalogue());
  /** Quantities and orders of the read-outs. */
  names = new Names([]);

  /** @type {Engine} engine of the page, never collected as garbage: the code that frees a simulator may not have loaded */
  static #loaded;

  /** @returns {Promise<Engine>} */
  static async load() {
    await startEngine();
    Engine.#loaded = new Engine();
    return Engine.#loaded;
  }

  /**
   * @template {Kind} K
   * @param {import("assur/state/state.js").State<K>} state
   * @returns {Summaries[K]}
   */
  set(state) {
    const summary = this.ask(() => {
      const simulator = this.#simulator;
      simulator.setSymbol(this.symbol);
      const taken = simulator.set(withoutExtras(state));
      this.names = this.names.updated(simulator.readouts());
      this.labels = simulator.labelNames();
      this.lengths = simulator.lengths();
      this.choosesLengths = simulator.choosesLengths();
      return this.detailed(this.#compared.follow(state, taken), state);
    });
    this.#lastAccepted = state;
    this.trapped = false;
    this.#outliveCompared();
    return /** @type {Summaries[K]} */ (summary);
  }

  /**
   * @template {object} S
   * @param {S} summary of the engine, without details
   * @param {State} state of which it is the summary
   * @returns {import("assur/state/details.js").Detailed<S>} the summary with details, which the engine gives when they are first read, even if it has taken another state since
   */
  detailed(summary, state) {
    return withDetails(summary, (question) => {
      if (this.#lastAccepted === state) return question(this.simulator);
      return this.withScratchSimulator((other) => {
        other.set(withoutExtras(state));
        return question(other);
      });
    });
  }

  /** Whether mechanism A is shown. */
  get compares() {
    return this.#compared.shown !== null;
  }

  /**
   * @param {number} input
   * @returns {import("assur/state/compared.js").Comparison | null} mechanism A at the input; null if it is hidden or cannot be assembled
   */
  compared(input) {
    const compared = this.#compared.at(input);
    this.#outliveCompared();
    return compared;
  }

  /** Starts a new instance of the module if mechanism A broke the present one. */
  #outliveCompared() {
    if (!this.#compared.broken) return;
    this.#compared.hide();
    this.#renew();
  }

  /**
   * Calls a function with a separate simulator. The simulator of the page stays as it is.
   * @template T
   * @param {(other: module.Simulator) => T} questions
   * @returns {T}
   */
  withScratchSimulator(questions) {
    return this.ask(() => {
      const other = new module.Simulator();
      const instance = this.#instances;
      try {
        return questions(other);
      } finally {
        // If a new instance has replaced this one, its simulators are already gone.
        if (instance === this.#instances) discard(other);
      }
    });
  }

  /**
   * Drawing, handles, read-outs and plotted values at an input, computed from one pose.
   * @param {number} input
   * @returns {PoseData}
   */
  at(input) {
    const { frame, handles, readouts, plotted } = this.simulator.at(input);
    const read = Readouts.of(this.names, readouts);
    return { frame, handles, readouts: read, plotted: read && plotted };
  }

  /**
   * Paints the curves of the plots, with those of mechanism A if it is shown.
   * @param {import("assur/canvas/painter.js").Context} context
   * @param {import("assur/types/web.js").ChartRequest} request
   * @returns {import("assur/types/web.js").ChartLayout} layout of the plots, by which the page adds their text
   */
  chart(context, request) {
    const on = /** @type {CanvasRenderingContext2D} */ (context);
    const { shown } = this.#compared;
    return shown ? this.simulator.chartCompared(on, request, shown) : this.simulator.chart(on, request);
  }

  /**
   * @param {number} steps number of steps in a turn, or in the range of a driven slide
   * @returns {import("assur/types/web.js").SweepTable} the motion as a table, with that of mechanism A if it is shown
   */
  sweep(steps) {
    const { shown } = this.#compared;
    return shown ? this.simulator.sweepCompared(steps, shown) : this.simulator.sweep(steps);
  }

  /**
   * Makes a call of the engine. An error without `problems` means that the instance is broken: a new one replaces it, and the caller gets a
   * refusal. The same applies if the second part did not load: the exception left the first part in the middle of a call.
   * @template T
   * @param {() => T} call
   * @returns {T}
   */
  ask(call) {
    try {
      return call();
    } catch (thrown) {
      if (problemsOf(thrown)) throw thrown;
      console.error(thrown);
      this.trapped = !(thrown instanceof NotLoaded);
      this.#compared.takeAnew();
      this.#renew();
      throw new Refusal([{ code: this.trapped ? "trapped" : "not_arrived" }]);
    }
  }

  /**
   * Starts a new instance of the module with the last accepted state, or without a state if that state breaks the new instance, too. After a
   * trap, the old instance is unusable: its stack stays full and its objects stay borrowed. All simulators of the old instance are lost.
   */
  #renew() {
    module.__wbg_reset_state();
    this.#instances += 1;
    this.#simulator = new module.Simulator();
    const state = this.#lastAccepted;
    if (!state) return;
    try {
      this.#simulator.set(withoutExtras(state));
    } catch (thrown) {
      console.error(thrown);
      this.#lastAccepted = null;
      this.#renew();
    }
  }
}
