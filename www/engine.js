// The engine as the page sees it: one Simulator, problems instead of exceptions of all kinds, recovery after a trap.
import { Refusal } from "assur/core/problem.js";
import init, * as mixer from "assur/pkg/assur_web.js";

/**
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/state/state.js").Kind} Kind
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/state.js").LinkageDocument} LinkageDocument
 * @typedef {import("assur/state/state.js").MixerDocument} MixerDocument
 * @typedef {{ min: number, max: number, stroke: number }} Swing
 * @typedef {{ ratio: number, swing: (Swing | null)[], turns: number[] }} WheelSummary
 * @typedef {{ start: number, end: number, full: boolean, arcs: [number, number][] }} Cycle
 * @typedef {{ role: string, kind: "max" | "min" | "zero", phi: number, value: number }} Mark
 * @typedef {{
 *   counts: { links: number, lower: number, higher: number, mobility: number },
 *   grashof: string,
 *   cycle: Cycle,
 *   home: number,
 *   swing: (Swing | null)[],
 *   wheels: WheelSummary[],
 *   overlaps: [number, number][],
 *   free_direction: number,
 *   limits: { phi: number, rocker: number }[],
 *   time_ratio: number | null,
 *   transmission: { min: number, phi: number },
 *   dead_points: number[],
 *   change_points: number[],
 *   bounds: [number, number, number, number],
 * }} MixerSummary
 * @typedef {{
 *   cycle: Cycle, home: number, bounds: [number, number, number, number],
 *   counts: { links: number, pairs: number }, mobility: number, class: string, order: number, formula: string, assembly: number, assemblies: number,
 *   groups: { term: string, role: string }[], equations: import("assur/kinds/linkage/equations.js").Equation[],
 *   dead_points: { phi: number, kind: string, links: string[] }[], change_points: number[],
 *   roles: Record<string, string>, points: string[], plotted: string[], handles: { name: string, role: string }[],
 *   course: Course | null,
 * }} LinkageSummary
 * @typedef {{ mixer: MixerSummary, linkage: LinkageSummary }} Summaries
 * @typedef {Summaries[Kind]} Summary
 * @typedef {{
 *   width: number, stroke: number | null,
 *   dwell: { arc: [number, number], band: [number, number] } | null,
 *   phases: { kind: "rise" | "dwell" | "return", arc: [number, number] }[],
 * }} Course
 * What the first plotted output does: its stroke; the longest arc on which it stays within a band, `width` (degrees, or in the
 * unit of lengths) wide, with the values it has there; its phases.
 * @typedef {{
 *   order: 0 | 1 | 2, kind: "angle" | "length", physical: boolean, differenced: boolean,
 *   left: number, top: number, width: number, height: number,
 *   x0: number, x1: number, y0: number, y1: number,
 *   xticks: { value: number }[], yticks: { value: number }[],
 *   series: { name: string, role: string }[], marks: Mark[], points: number[],
 * }} Panel
 * @typedef {{ width: number, height: number, palette: [number, number, number][], scale: number, ratio: number, whole: boolean }} ChartRequest
 * @typedef {Readonly<Record<string, number>>} Readouts
 * @typedef {{ columns: string[], rows: { phi_deg: number, values: (number | null)[], reason: Problem | null }[] }} SweepTable
 */

export class Engine {
  #module = mixer;
  #simulator = new mixer.Simulator();
  /** @type {State | null} the last state the simulator took */
  #good = null;

  /** Whether it broke down since it last took a state. */
  trapped = false;
  /** @type {readonly string[]} */
  roles = mixer.roleNames();
  /** @type {readonly string[]} of the display lists */
  labels = [];
  /** @type {readonly { id: string, document: import("assur/state/state.js").Presets["mixer"] }[]} */
  presets = mixer.presets().map((/** @type {{ id: string, document: MixerDocument }} */ { id, document: { tracers, ...document } }) => ({ id, document }));
  /** @type {readonly { id: string, document: LinkageDocument }[]} the linkages of the catalogue, once they can be shown */
  gallery = [];
  /** @type {readonly string[]} */
  #names = [];
  /** @type {readonly string[]} the points whose coordinates can be plotted */
  points = [];
  /** @type {readonly string[]} the links whose angles are read */
  links = [];

  /**
   * @param {LinkageDocument} linkage
   * @returns {{ id: string, document: LinkageDocument } | undefined} the one of the catalogue that was changed into it
   */
  original(linkage) {
    return this.gallery.find(({ document }) => document.title === linkage.title);
  }

  /** @returns {readonly string[]} the tables of words for all that it knows */
  get tables() {
    return this.#module === mixer ? ["*"] : ["*", "linkages/*"];
  }

  /** @returns {Promise<Engine>} */
  static async load() {
    await init({ module_or_path: fetch(import.meta.resolve("assur/pkg/assur_web_bg.wasm")) });
    return new Engine();
  }

  /**
   * Brings what knows any linkage, and writes tables: larger than what the first view needs, it comes when asked for.
   * @returns {Promise<void>} refused where it does not arrive
   */
  async grow() {
    if (this.#module !== mixer) return;
    try {
      const grown = await import("assur/pkg/linkages/assur_web.js");
      await grown.default({ module_or_path: fetch(import.meta.resolve("assur/pkg/linkages/assur_web_bg.wasm")) });
      this.#module = grown;
      this.gallery = grown.gallery();
      this.#recover();
    } catch (thrown) {
      console.error(thrown);
      throw new Refusal([{ code: "not_arrived" }]);
    }
  }

  /**
   * @template {Kind} K
   * @param {import("assur/state/state.js").State<K>} state
   * @returns {Summaries[K]}
   */
  set(state) {
    const summary = this.ask((simulator) => {
      /** @type {Summaries[K]} */
      const taken = simulator.set(state);
      this.#name(simulator.readoutNames());
      this.labels = simulator.labelNames();
      return taken;
    });
    this.#good = state;
    this.trapped = false;
    return summary;
  }

  /**
   * @param {unknown} value from outside
   * @returns {State} the same, read and checked
   */
  read(value) {
    return this.ask(() => this.#module.readState(value));
  }

  /** @returns {Float32Array} display list of all that is rigid */
  scene() {
    return this.ask((simulator) => simulator.scene());
  }

  /**
   * @param {number} phi
   * @returns {Float32Array} where the bodies are, and a display list of what is not rigid
   */
  frame(phi) {
    return this.ask((simulator) => simulator.frame(phi));
  }

  /**
   * @param {number} phi
   * @returns {Float64Array} x and y of the joints A, B, C, D and of the traced points
   */
  joints(phi) {
    return this.ask((simulator) => simulator.joints(phi));
  }

  /**
   * What dragging a joint or a traced point to a place changes.
   * @param {string} joint
   * @param {number} phi where the crank is
   * @param {number} x
   * @param {number} y
   * @returns {{ phi: number, document?: undefined } | { phi?: undefined, document: import("assur/state/state.js").Change }}
   */
  drag(joint, phi, x, y) {
    return this.ask((simulator) => simulator.drag(joint, phi, x, y));
  }

  /**
   * What tracing the point at a place changes.
   * @param {number} phi where the crank is
   * @param {number} x
   * @param {number} y
   * @returns {{ document: { tracers: import("assur/state/state.js").Tracer[] } }}
   */
  trace(phi, x, y) {
    return this.ask((simulator) => simulator.trace(phi, x, y));
  }

  /**
   * @param {number} phi
   * @returns {Readouts} values by name; ′ and ″ are derivatives of the axes
   */
  readouts(phi) {
    const values = this.ask((simulator) => simulator.readouts(phi));
    /** @type {Record<string, number>} */
    const named = {};
    for (let i = 0; i < this.#names.length; i++) named[this.#names[i]] = values[i];
    return named;
  }

  /**
   * @param {number} phi
   * @returns {Float64Array} of each series of the plots the value and both derivatives
   */
  plotted(phi) {
    return this.ask((simulator) => simulator.plotted(phi));
  }

  /**
   * @param {number} phi
   * @param {number} delta
   * @returns {{ phi: number, sign: number }} sign −1: it turned back at the end of the range
   */
  advance(phi, delta) {
    const [next, sign] = this.ask((simulator) => simulator.advance(phi, delta));
    return { phi: next, sign };
  }

  /**
   * @param {import("assur/canvas/painter.js").Context} context
   * @param {ChartRequest} request
   * @returns {{ panels: Panel[] }}
   */
  chart(context, request) {
    return this.ask((simulator) => simulator.chart(/** @type {CanvasRenderingContext2D} */ (context), request));
  }

  /**
   * Puts a question to the simulator: a part that is loaded later puts its own.
   * @template T
   * @param {(simulator: mixer.Simulator) => T} question
   * @returns {T}
   */
  ask(question) {
    try {
      return question(this.#simulator);
    } catch (thrown) {
      if (Array.isArray(thrown)) throw new Refusal(thrown);
      console.error(thrown);
      this.trapped = true;
      this.#recover();
      throw new Refusal([{ code: "trapped" }]);
    }
  }

  /** @param {readonly string[]} names of the read-outs */
  #name(names) {
    if (names.join() === this.#names.join()) return;
    this.#names = names;
    const of = (/** @type {string} */ what) => names.filter((name) => name.endsWith(what)).map((name) => name.slice(0, -what.length));
    this.points = of(".x");
    this.links = of(".angle");
  }

  /** A trap leaves a simulator unusable: a new one takes over with the last good state. */
  #recover() {
    this.#simulator = new this.#module.Simulator();
    if (this.#good) this.#simulator.set(this.#good);
  }
}
