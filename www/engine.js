// The engine as the page sees it: one Simulator, problems instead of exceptions of all kinds, recovery after a trap.
import { Refusal } from "assur/core/problem.js";
import { contains } from "assur/state/state.js";
import init, * as module from "assur/pkg/assur_web.js";

/**
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/state/state.js").Kind} Kind
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/state.js").Frozen<import("assur/types/file.js").Preset>} Preset of the catalogue
 * @typedef {{ min: number, max: number, stroke: number }} Swing
 * @typedef {{ start: number, end: number, full: boolean, arcs: [number, number][] }} Cycle
 * @typedef {{ role: string, kind: "max" | "min" | "zero", phi: number, value: number }} Mark
 * @typedef {{ name: string, what: "angle" | "x" | "y" | "transmission", of: string[], number: string | null, role: string }} Listed
 * A read-out beside the drawing: of an angle the link and those fixed to it, of a coordinate the point, of a transmission angle the joint.
 * @typedef {{ name: string, swing: (Swing | null)[], turns: number[], limits: { input: number, value: number }[], time_ratio: number | null }} Output
 * What an output of the document does over the motion: a swing for every arc of it, null where it turns on and on; turns there and back.
 * @typedef {{
 *   bounds: [number, number, number, number], handles: { name: string, role: string }[], roles: Record<string, string>,
 *   counts: { links: number, lower: number, higher: number, mobility: number },
 *   class: string, order: number, formula: string, groups: { term: string, role: string }[],
 * }} Structure what the engine says of a drawing and its structure, whether it moves or not
 * @typedef {Structure & { moves: null }} StillSummary
 * @typedef {Structure & {
 *   moves: "angle" | "length", cycle: Cycle, home: number, assembly: number, assemblies: number, equations: import("assur/kinds/linkage/equations.js").Equation[],
 *   dead_points: { input: number, kind: string, links: string[] }[], change_points: number[],
 *   four_bars: { links: string[], grashof: string }[],
 *   transmissions: { joint: string, links: [string, string], min: number, input: number }[],
 *   outputs: Output[],
 *   numbers: Record<string, string>, points: string[], listed: Listed[], plotted: string[],
 *   profile: Profile | null,
 * }} MotionSummary
 * What the engine says of a motion as a whole; inputs are radians, or of a driven slide in the unit of the lengths.
 * @typedef {MotionSummary & { ratios: number[], overlaps: [number, number][], free_direction: number }} MixerSummary
 * @typedef {{ mixer: MixerSummary, linkage: MotionSummary, scheme: StillSummary }} Summaries
 * @typedef {Summaries[Kind]} Summary
 * @typedef {{
 *   width: number, stroke: number | null,
 *   dwell: { arc: [number, number], band: [number, number] } | null,
 *   phases: { kind: "rise" | "dwell" | "return", arc: [number, number] }[],
 * }} Profile
 * What the first plotted output does: its stroke; the longest arc on which it stays within a band, `width` (degrees, or in the
 * unit of lengths) wide, with the values it has there; its phases.
 * @typedef {{ frame: Float64Array, handles: Float64Array, readouts: Readouts | null, plotted: Float64Array | null }} Here
 * A place of the motion: where the bodies are with a display list of what is not rigid, x and y of the handles, values by name,
 * of each series of the plots the value and both derivatives; the last two are null where derivatives are unbounded.
 * @typedef {{
 *   order: 0 | 1 | 2, kind: "angle" | "length", physical: boolean, differenced: boolean,
 *   left: number, top: number, width: number, height: number,
 *   x0: number, x1: number, y0: number, y1: number,
 *   xticks: { value: number }[], yticks: { value: number }[],
 *   series: { name: string, number: string | null, role: string }[], marks: Mark[], points: number[],
 * }} Panel
 * @typedef {{ width: number, height: number, palette: [number, number, number][], scale: number, ratio: number, whole: boolean }} ChartRequest
 * @typedef {Readonly<Record<string, number>>} Readouts
 * @typedef {{ columns: string[], rows: { input: number, values: (number | null)[], reason: Problem | null }[] }} SweepTable
 */

/** How many lists a place of the motion has. */
const LISTS = 4;

/**
 * @param {Float64Array} flat how many numbers each of the lists has, then the lists
 * @returns {Float64Array[]}
 */
function lists(flat) {
  let end = LISTS;
  return [...flat.subarray(0, LISTS)].map((length) => flat.subarray(end, (end += length)));
}

export class Engine {
  #simulator = new module.Simulator();
  /** @type {State | null} the last state the simulator took */
  #good = null;

  /** Whether it broke down since it last took a state. */
  trapped = false;
  /** @type {readonly string[]} */
  roles = module.roleNames();
  /** @type {readonly string[]} of the display lists */
  labels = [];
  /** @type {readonly Preset[]} */
  catalogue = module.catalogue();
  /** @type {readonly string[]} */
  #names = [];
  /** @type {readonly string[]} the points whose coordinates can be plotted */
  points = [];
  /** @type {readonly string[]} the links whose angles are read */
  links = [];

  /**
   * @param {string} id
   * @returns {Preset | undefined} the mechanism of the catalogue
   */
  preset(id) {
    return this.catalogue.find((preset) => preset.id === id);
  }

  /**
   * @param {Pick<State, "kind" | "document">} state
   * @returns {Preset | undefined} what its document came from: by the origin it has, else by its dimensions, whatever is traced of it
   */
  presetOf({ kind, document }) {
    if ("origin" in document) return this.preset(document.origin ?? "");
    return this.catalogue.find((preset) => {
      const { tracers, ...dimensions } = preset.document;
      return preset.kind === kind && contains(document, dimensions);
    });
  }

  /** @returns {Promise<Engine>} */
  static async load() {
    await init({ module_or_path: fetch(import.meta.resolve("assur/pkg/assur_web_bg.wasm")) });
    return new Engine();
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
    return this.ask(() => module.readState(value));
  }

  /**
   * @param {State} state another than the one that is set, which stays
   * @returns {{ bounds: readonly number[], scene: Float32Array, frame: Float64Array }} its drawing as it is drawn in the document
   */
  sketch(state) {
    return this.ask(() => {
      const other = new module.Simulator();
      try {
        const { bounds, home = 0 } = other.set(state);
        return { bounds, scene: other.scene(), frame: lists(other.at(home))[0] };
      } finally {
        other.free();
      }
    });
  }

  /** @returns {Float32Array} display list of all that is rigid */
  scene() {
    return this.ask((simulator) => simulator.scene());
  }

  /**
   * Everything at a place of the motion, from one pose.
   * @param {number} input
   * @returns {Here}
   */
  at(input) {
    const [frame, handles, readouts, plotted] = lists(this.ask((simulator) => simulator.at(input)));
    const read = readouts.length > 0;
    return { frame, handles, readouts: read ? this.#named(readouts) : null, plotted: read ? plotted : null };
  }

  /**
   * @param {number} input
   * @returns {readonly Problem[]} why there is no pose, or none of its derivatives
   */
  why(input) {
    return this.ask((simulator) => simulator.why(input));
  }

  /**
   * @param {number} input
   * @returns {Float64Array} of each series of the plots the value and both derivatives
   */
  plotted(input) {
    return this.ask((simulator) => simulator.plotted(input));
  }

  /**
   * What dragging a joint or a traced point to a place changes.
   * @param {string} point
   * @param {number} input where it is
   * @param {number} x
   * @param {number} y
   * @returns {{ input: number, document?: undefined } | { input?: undefined, document: import("assur/state/state.js").Change }}
   */
  drag(point, input, x, y) {
    return this.ask((simulator) => simulator.drag(point, input, x, y));
  }

  /**
   * What tracing the point at a place changes.
   * @param {number} input where it is
   * @param {number} x
   * @param {number} y
   * @returns {{ document: { tracers: { name?: string, link: string }[] } & import("assur/state/state.js").Change }}
   */
  trace(input, x, y) {
    return this.ask((simulator) => simulator.trace(input, x, y));
  }

  /**
   * @param {number} input
   * @param {number} delta
   * @returns {{ input: number, sign: number }} sign −1: it turned back at the end of the range
   */
  advance(input, delta) {
    const [next, sign] = this.ask((simulator) => simulator.advance(input, delta));
    return { input: next, sign };
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
   * @param {(simulator: module.Simulator) => T} question
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

  /**
   * @param {Float64Array} values
   * @returns {Readouts} ′ and ″ are derivatives of the axes
   */
  #named(values) {
    /** @type {Record<string, number>} */
    const named = {};
    for (let i = 0; i < this.#names.length; i++) named[this.#names[i]] = values[i];
    return named;
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
    this.#simulator = new module.Simulator();
    if (this.#good) this.#simulator.set(this.#good);
  }
}
