// Data for everything that the page shows, derived from the state. The engine is asked only for what a change requires.
import { attempt } from "assur/core/problem.js";
import { Coordinate, VIEW_KEYS } from "assur/state/coordinate.js";
import { partOf } from "assur/state/drafts.js";
import { DRAWN, PARTS } from "assur/state/state.js";

/**
 * @template {import("assur/state/state.js").Kind} [K=import("assur/state/state.js").Kind]
 * @typedef {import("assur/state/state.js").State<K>} State
 */

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/state/readouts.js").Readouts} Readouts
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").Kind} Kind
 *
 * @typedef {{
 *   state: State,
 *   coordinate: Coordinate,
 *   inputShown: number,
 *   input: number,
 *   words: Words,
 *   scene: Float32Array,
 *   revision: number,
 *   frame: Float32Array,
 *   handles: Float64Array,
 *   frameInput: number,
 *   readouts: Readouts | null,
 *   plotted: Float64Array | null,
 *   compared: import("assur/state/compared.js").Comparison | null,
 *   compares: boolean,
 *   problems: readonly Problem[],
 *   stale: boolean,
 *   faded: boolean,
 *   numbersDue: boolean,
 *   withheld: ReadonlySet<string>,
 * }} Shown
 * What the views draw. `inputShown`: the input on its axis, in the reader's unit; `input`: the same in the engine's unit. `revision`: number of
 * mechanisms taken so far. `handles`: x and y of the summary's handles in the last drawing; `frameInput`: input of this drawing. `readouts`,
 * `plotted`: null if there are none at the input. `compared`: mechanism A at the input, null if A is not shown or cannot be assembled;
 * `compares`: whether A is shown. `stale`: whether the mechanism and plots are not those of the state, which has problems. `faded`: whether
 * the drawing is stale or at another input. `numbersDue`: whether numbers are to be written now; in motion they are not written in every frame.
 * `withheld`: what is hidden because a lesson asks for it: quantities as lessons name them, and names of read-outs.
 */

/**
 * Kinds of documents that have an input, at least some of them.
 * @typedef {{ [K in Kind]: import("assur/state/details.js").Summaries[K] extends { moves: null } ? never : K }[Kind]} Moving
 */

/**
 * The drawn mechanism: its kind and the engine's summary.
 * @template {Kind} K
 * @typedef {K extends Kind ? { kind: K, summary: import("assur/state/details.js").Summaries[K] } : never} Drawn
 */

/** @typedef {{ [K in Moving]: { kind: K, summary: Exclude<import("assur/state/details.js").Summaries[K], { moves: null }> } }[Moving]} InMotion drawn mechanism with an input */

/**
 * Snapshot of a document of kind K or, by default, of any document with an input.
 * @template {Kind} [K=never]
 * @typedef {Shown & ([K] extends [never] ? InMotion : Drawn<K>)} Snapshot
 */

/** @typedef {Snapshot<Kind>} AnySnapshot snapshot of any document, also of one without an input */

/**
 * Snapshot in which the drawn mechanism is of the state's own kind.
 * @template {Kind} K
 * @typedef {Snapshot<K> & { state: State<K> }} OwnSnapshot
 */

/** Stand-in for the input of a document that has none. */
const STILL = Object.freeze({ moves: /** @type {const} */ ("angle"), input: "1", cycle: { start: 0, end: 2 * Math.PI, full: true, arcs: [] }, home: 0 });

const TRAPPED = Object.freeze({ code: "trapped" });

/** @param {Problem} problem */
function notTrapped(problem) {
  return problem.code !== TRAPPED.code;
}

export class Model {
  /** @type {ReadonlySet<string>} quantities and read-outs that are hidden because a lesson asks for them */
  withheld = new Set();
  #engine;
  #drafts;
  /** @type {State | null} the state that the engine was asked about last */
  #asked = null;
  /** @type {State} */
  #lastAccepted;
  #revision = 0;
  /** Revision of the mechanism that was drawn last. */
  #poseRevision = 0;
  /** @type {Drawn<Kind>} */
  #drawn;
  /** @type {Float32Array} */
  #scene;
  /** @type {import("assur/engine.js").PoseData} the mechanism at the last input at which it could be assembled */
  #here;
  #frameInput;
  /** Unit and range of the input. */
  #coordinate;
  /** Opening of a scheme at its last cut pair, from 0 to 1; used as the input of a document that has none. */
  #opened = 1;
  /** @type {Readouts | null} */
  #readouts = null;
  /** @type {Float64Array | null} */
  #plotted = null;
  /** @type {import("assur/state/compared.js").Comparison | null} */
  #compared = null;
  /** @type {readonly Problem[]} */
  #refused = [];
  /** @type {readonly Problem[]} */
  #poseProblems = [];
  /** @type {readonly Problem[]} */
  #unread = [];

  /**
   * @param {Engine} engine
   * @param {import("assur/state/drafts.js").Drafts} drafts
   * @param {State} state state that the engine takes
   */
  constructor(engine, drafts, state) {
    this.#engine = engine;
    this.#drafts = drafts;
    this.#drawn = drawn(engine, state);
    this.#scene = engine.simulator.scene();
    this.#coordinate = this.#counted();
    this.#here = engine.at(this.home);
    this.#frameInput = this.home;
    this.#revision = 1;
    this.#asked = state;
    this.#lastAccepted = state;
    this.#updatePose(state);
  }

  /** @returns {import("assur/state/details.js").Summary} */
  get summary() {
    return this.#drawn.summary;
  }

  /** @returns {Kind} kind of the drawn document; it may differ from the kind of a refused state */
  get kind() {
    return this.#drawn.kind;
  }

  /** The drawn input of the mechanism, in the engine's unit. */
  get home() {
    return (this.summary.moves ? this.summary : STILL).home;
  }

  /** Unit and range of the input of the drawn mechanism. */
  get coordinate() {
    return this.#coordinate;
  }

  /** @returns {State} the last state that the engine took */
  get lastAccepted() {
    return this.#lastAccepted;
  }

  /** Whether the engine took the state that it was asked about last. */
  get accepted() {
    return this.#refused.length === 0;
  }

  /**
   * Tests whether the engine takes a state, which may be newer than the drawn one.
   * @param {State} state
   */
  takes(state) {
    this.follow(state);
    return this.accepted;
  }

  /** Whether the state refers to a quantity or a part that the mechanism lacks. */
  get hasDanglingReference() {
    return this.#refused.some(({ code, field }) => code === "unknown_choice" && field !== undefined && Object.hasOwn(PARTS, field));
  }

  /** Whether the mechanism can be assembled at the current input. */
  get hasPose() {
    return this.#poseProblems.length === 0;
  }

  /**
   * Draws symbols in another size from the next state on.
   * @param {number} unit symbol unit in the unit of lengths; 0 for a hundredth of the drawing's size
   * @returns {boolean} whether the size changes
   */
  scaleSymbols(unit) {
    if (unit === this.#engine.symbol) return false;
    this.#engine.symbol = unit;
    this.#asked = null;
    return true;
  }

  /**
   * Opens the chain of a scheme at its last cut pair.
   * @param {number} share of the full opening, from 0 to 1
   */
  fallOpen(share) {
    this.#opened = share;
    if (this.#asked) this.#updatePose(this.#asked);
  }

  /**
   * Updates the mechanism and its pose to a state, as far as the state has changed.
   * @param {State} state
   */
  follow(state) {
    const asked = this.#asked;
    const other = !asked || asked.document !== state.document || asked.compared !== state.compared || DRAWN.some((name) => asked.view[name] !== state.view[name]);
    const moved = !asked || VIEW_KEYS.some((name) => asked.view[name] !== state.view[name]);
    if (other) this.#take(state);
    if (other || moved) this.#updatePose(state);
    this.#asked = state;
    if (this.accepted) this.#lastAccepted = state;
  }

  /**
   * @param {State} state
   * @param {Words} words
   * @param {boolean} numbersDue
   * @returns {AnySnapshot}
   */
  snapshot(state, words, numbersDue) {
    // A typed value hides the problem of the value that the state still has.
    const refused = this.#refused.filter(({ field }) => field === undefined || !this.#drafts.has(field));
    const drafted = this.#drafts.problems;
    const stale = this.#refused.length > 0 || this.#drafts.fields().some((field) => partOf(field) in state.document);
    // In motion a dead point is passed within one frame, and nobody could read a sentence on it in this time.
    const unread = state.view.playing ? [] : this.#unread;
    const poseProblems = stale ? [] : this.#poseProblems.length > 0 ? this.#poseProblems : unread;
    const trapped = this.#engine.trapped ? [TRAPPED] : [];
    const inputShown = this.#coordinate.of(state);
    return {
      ...this.#drawn,
      state,
      coordinate: this.#coordinate,
      inputShown,
      input: this.#coordinate.input(inputShown),
      words,
      scene: this.#scene,
      revision: this.#revision,
      frame: this.#here.frame,
      handles: this.#here.handles,
      frameInput: this.#frameInput,
      readouts: this.#readouts,
      plotted: this.#plotted,
      compared: this.#compared,
      compares: this.#engine.compares,
      problems: [...trapped, ...drafted, ...refused.filter(notTrapped), ...poseProblems.filter(notTrapped)],
      stale,
      faded: stale || this.#poseProblems.length > 0,
      numbersDue,
      withheld: this.withheld,
    };
  }

  #counted() {
    const { moves, cycle, input } = this.summary.moves ? this.summary : STILL;
    return new Coordinate(moves, cycle, input);
  }

  /** @param {State} state */
  #take(state) {
    const taken = attempt(() => ({ drawn: drawn(this.#engine, state), scene: this.#engine.simulator.scene() }));
    this.#refused = taken.problems;
    if (!taken.value) return;
    this.#drawn = taken.value.drawn;
    this.#coordinate = this.#counted();
    this.#scene = taken.value.scene;
    this.#revision += 1;
  }

  /** @param {State} state */
  #updatePose(state) {
    const input = this.summary.moves ? this.#coordinate.input(this.#coordinate.of(state)) : this.#opened;
    const { value: here, problems } = attempt(() => this.#engine.at(input));
    this.#poseProblems = problems;
    this.#unread = here && !here.readouts ? this.#engine.simulator.why(input) : [];
    this.#readouts = here?.readouts ?? null;
    this.#plotted = here?.plotted ?? null;
    this.#compared = this.#engine.compared(input);
    // If the mechanism cannot be assembled at this input, its last drawing stays, but not that of another mechanism.
    if (!here && this.#poseRevision === this.#revision) return;
    this.#here = here ?? this.#engine.at(this.home);
    this.#frameInput = here ? input : this.home;
    this.#poseRevision = this.#revision;
  }
}

/**
 * @param {AnySnapshot} snapshot
 * @returns {snapshot is Snapshot}
 */
export function moves(snapshot) {
  return snapshot.summary.moves !== null;
}

/**
 * @param {Engine} engine
 * @param {State} state
 * @returns {Drawn<Kind>}
 */
function drawn(engine, state) {
  return /** @type {Drawn<Kind>} */ ({ kind: state.kind, summary: engine.set(state) });
}
