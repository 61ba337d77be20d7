// The input in the reader's unit (degrees, travel of a slide, seconds) and in the engine's (radians, length, seconds).
import { degrees, radians } from "assur/core/angles.js";
import { subscript } from "assur/core/symbols.js";
import { measured } from "assur/core/units.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").State} State
 */

/** Kinds of input. `rates`: symbols of velocity and acceleration. The link's number follows all symbols but s and t. */
const SORTS = Object.freeze({
  angle: Object.freeze({ viewKey: /** @type {const} */ ("phi_deg"), symbol: "φ", rates: Object.freeze(["ω", "ε"]) }),
  length: Object.freeze({ viewKey: /** @type {const} */ ("s"), symbol: "s", rates: Object.freeze(["v", "a"]) }),
  time: Object.freeze({ viewKey: /** @type {const} */ ("t"), symbol: "t", rates: Object.freeze(["", ""]) }),
});

/** Time of a turn of a crank, or of a slide's travel forth and back, at speed 1, in seconds. */
const PERIOD = 6;

/** Number of small steps in the travel of a slide or in a span of time. */
const STEPS = 100;

/** Longest time that the engine accepts, in seconds. */
const MAX_TIME = 1e6;

/** Fraction of a span of time that is too small to see. */
const INVISIBLE_SHARE = 1e-9;

/** Fields of the view that hold an input of any kind. */
export const VIEW_KEYS = Object.freeze(Object.values(SORTS).map(({ viewKey }) => viewKey));

export class Coordinate {
  #turns;
  #cycle;
  #sort;
  #number;

  /**
   * @param {"angle" | "length" | "time"} moves
   * @param {import("assur/types/web.js").CycleSummary} cycle range of the input, in the engine's unit
   * @param {string} [number] number of the link in the symbol
   */
  constructor(moves, cycle, number = "1") {
    this.moves = moves;
    this.#turns = moves === "angle";
    this.#cycle = cycle;
    this.#sort = SORTS[moves];
    this.#number = subscript(number);
  }

  /** Field of the view that holds the input. */
  get viewKey() {
    return this.#sort.viewKey;
  }

  get symbol() {
    return this.#sort.symbol + (this.#turns ? this.#number : "");
  }

  /** Symbols of the velocity and the acceleration of the input. */
  get rates() {
    return this.#sort.rates.map((letter) => letter + this.#number);
  }

  /**
   * Returns the ends of the input's axis, in the reader's unit. Unlimited time is divided into spans with an axis each.
   * @param {number} inputShown input in the reader's unit
   */
  axis(inputShown) {
    const [start, end] = [this.#cycle.start, this.#cycle.end].map((input) => this.inputShown(input));
    if (!this.#goesOn) return { start, end };
    const before = Math.max(0, Math.floor(inputShown / end)) * end;
    return { start: before, end: before + end };
  }

  /**
   * Returns the last input on an axis. The end of a span of unlimited time belongs to the next span.
   * @param {number} inputShown input on this axis, in the reader's unit
   */
  last(inputShown) {
    const { end } = this.axis(inputShown);
    return this.#goesOn ? end * (1 - INVISIBLE_SHARE) : end;
  }

  /** Small step in which the input is moved by hand, in the reader's unit. */
  get step() {
    return this.#turns ? 1 : 10 ** Math.round(Math.log10(this.#way / STEPS));
  }

  /**
   * Returns the speed of the input in playback, in the engine's unit per second. With `true_time` it is the constant ω₁,
   * because ε₁ is the acceleration at the current instant only.
   * @param {State["view"]} view
   */
  pace({ true_time: trueTime, omega, speed }) {
    if (this.moves === "time") return speed;
    if (trueTime) return omega;
    return speed * (this.#turns ? (2 * Math.PI) / PERIOD : (2 * this.#way) / PERIOD);
  }

  get #goesOn() {
    return this.moves === "time" && this.#cycle.full;
  }

  get #way() {
    return this.#cycle.end - this.#cycle.start;
  }

  /**
   * @param {number} input in the engine's unit
   * @returns {number} the input in the reader's unit
   */
  inputShown(input) {
    return this.#turns ? degrees(input) : input;
  }

  /**
   * @param {number} inputShown input in the reader's unit
   * @returns {number} the input in the engine's unit
   */
  input(inputShown) {
    return this.#turns ? radians(inputShown) : inputShown;
  }

  /**
   * @param {State} state
   * @returns {number} the input on its axis, in the reader's unit; an input at either end of the axis stays there
   */
  of({ view }) {
    return this.onto(view[this.viewKey]);
  }

  /**
   * @param {State} state
   * @param {number} inputShown input in the reader's unit
   * @returns {State} the state with this input; a slide stops at the ends of its travel, time at 0 and at the end of a run
   */
  put(state, inputShown) {
    const wanted = this.moves === "time" ? Math.min(inputShown, MAX_TIME) : inputShown;
    const { start, end } = this.axis(wanted);
    const reached = this.#turns ? this.onto(wanted) : Math.min(Math.max(wanted, start), end);
    return withView(state, { [this.viewKey]: reached });
  }

  /**
   * @param {number} input in the engine's unit
   * @param {Words} words
   * @param {number} decimals for an angle, a time, and a slide with a travel from 1 to 10; a slide with a
   * longer travel gets fewer, one with a shorter travel more
   */
  text(input, words, decimals) {
    return this.written(this.inputShown(input), words, decimals);
  }

  /**
   * @param {number} inputShown input in the reader's unit
   * @param {Words} words
   * @param {number} decimals
   */
  written(inputShown, words, decimals) {
    return this.#withUnit(words.numbers.fixed(inputShown, this.#decimals(decimals)), words);
  }

  /**
   * Writes the input as {@link written} does, but without trailing zeros.
   * @param {number} input in the engine's unit
   * @param {Words} words
   * @param {number} decimals
   */
  short(input, words, decimals) {
    return this.#withUnit(words.numbers.upTo(this.inputShown(input), this.#decimals(decimals)), words);
  }

  /**
   * @param {number} inputShown input in the reader's unit
   * @param {Words} words
   * @returns {string} the input with all its digits, for editing
   */
  exact(inputShown, { numbers }) {
    return numbers.exact(inputShown) + (this.#turns ? "°" : "");
  }

  /**
   * @param {number} count
   * @param {Words} words
   * @returns {string} a turn, the travel of a slide or a span of time, divided by the count
   */
  share(count, words) {
    const part = this.#turns ? words.numbers.upTo(360 / count, 1) : words.numbers.upTo(this.#way / count, this.moves === "time" ? 5 : this.#decimals(5));
    return this.#withUnit(part, words);
  }

  /**
   * @param {number} one
   * @param {number} other input to compare with `one`, both in the engine's unit
   * @returns {boolean} whether the difference is invisible: less than half a degree, or half a small step of the travel or span
   */
  near(one, other) {
    if (!this.#turns) return Math.abs(one - other) < this.#way / (2 * STEPS);
    return Math.abs(Math.sin((one - other) / 2)) < radians(0.5) / 2;
  }

  /**
   * @param {string} number
   * @param {Words} words
   */
  #withUnit(number, words) {
    if (this.moves === "length") return words.length(number);
    return measured(number, this.#turns ? "°" : words.text("unit.s"));
  }

  /** @param {number} decimals */
  #decimals(decimals) {
    return this.moves === "length" ? Math.max(0, decimals - Math.floor(Math.log10(this.#way))) : decimals;
  }

  /**
   * @param {number} inputShown input in the reader's unit
   * @returns {number} the input on its axis: an angle is moved by whole periods, a time outside the axis to the nearer end
   */
  onto(inputShown) {
    const { start, end } = this.axis(inputShown);
    if (this.moves === "time") return Math.min(Math.max(inputShown, start), end);
    if (!this.#turns || (inputShown >= start && inputShown <= end)) return inputShown;
    const period = end - start;
    return inputShown - period * Math.floor((inputShown - start) / period);
  }
}
