// The input of the motion in the reader's unit: the angle of a crank in degrees, the travel of a slide, or time in seconds. The
// engine's units are radians, the unit of lengths, and seconds.
import { degrees, radians } from "assur/core/angles.js";
import { subscript } from "assur/core/symbols.js";
import { measured } from "assur/core/units.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").State} State
 */

/** Kinds of input: the field of the view, the symbol and the symbols of the rates. An angle also has the number of its link. */
const SORTS = Object.freeze({
  angle: Object.freeze({ field: /** @type {const} */ ("phi_deg"), symbol: "φ", rates: Object.freeze(["ω", "ε"]) }),
  length: Object.freeze({ field: /** @type {const} */ ("s"), symbol: "s", rates: Object.freeze(["v", "a"]) }),
  time: Object.freeze({ field: /** @type {const} */ ("t"), symbol: "t", rates: Object.freeze(["", ""]) }),
});

/** Seconds in which, at speed 1, a crank turns once and a slide goes there and back. */
const PERIOD = 6;

/** Number of small steps in the travel of a slide or in a span of time. */
const STEPS = 100;

/** The longest time that the engine takes, in seconds. */
const LONGEST = 1e6;

/** Invisible fraction of a span of time. */
const HAIR = 1e-9;

/** Fields of the view that hold an input of any kind. */
export const FIELDS = Object.freeze(Object.values(SORTS).map(({ field }) => field));

export class Coordinate {
  #turns;
  #cycle;
  #sort;
  #number;

  /**
   * @param {"angle" | "length" | "time"} moves
   * @param {import("assur/engine.js").Cycle} cycle range of the input, in the engine's unit
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
  get field() {
    return this.#sort.field;
  }

  get symbol() {
    return this.#sort.symbol + (this.#turns ? this.#number : "");
  }

  /** Symbols of the velocity and the acceleration of the input. */
  get rates() {
    return this.#sort.rates.map((letter) => letter + this.#number);
  }

  /**
   * Ends of the axis of the input, in the reader's unit. Unlimited time is shown span after span.
   * @param {number} place in the reader's unit
   */
  axis(place) {
    const [start, end] = [this.#cycle.start, this.#cycle.end].map((input) => this.place(input));
    if (!this.#goesOn) return { start, end };
    const before = Math.max(0, Math.floor(place / end)) * end;
    return { start: before, end: before + end };
  }

  /**
   * Last place on the same axis as a place. The end of an axis of unlimited time belongs to the next span.
   * @param {number} place in the reader's unit
   */
  last(place) {
    const { end } = this.axis(place);
    return this.#goesOn ? end * (1 - HAIR) : end;
  }

  /** Small step by hand, in the reader's unit. */
  get step() {
    return this.#turns ? 1 : 10 ** Math.round(Math.log10(this.#way / STEPS));
  }

  /**
   * Speed of the input in playback, in the engine's unit per second. In real time it is the constant ω₁: ε₁ is the
   * acceleration at this instant only.
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
   * @param {number} input of the engine
   * @returns {number} in the reader's unit
   */
  place(input) {
    return this.#turns ? degrees(input) : input;
  }

  /**
   * @param {number} place in the reader's unit
   * @returns {number} in the engine's unit
   */
  input(place) {
    return this.#turns ? radians(place) : place;
  }

  /**
   * @param {State} state
   * @returns {number} place of the input on the axis, in the reader's unit; both ends of the axis are kept
   */
  of({ view }) {
    return this.onto(view[this.field]);
  }

  /**
   * @param {State} state
   * @param {number} place in the reader's unit
   * @returns {State} the state with the input there; a slide stops at the ends of its travel, time at 0 and at the end of a run
   */
  put(state, place) {
    const wanted = this.moves === "time" ? Math.min(place, LONGEST) : place;
    const { start, end } = this.axis(wanted);
    const reached = this.#turns ? this.onto(wanted) : Math.min(Math.max(wanted, start), end);
    return withView(state, { [this.field]: reached });
  }

  /**
   * @param {number} input of the engine
   * @param {Words} words
   * @param {number} decimals of an angle; a length is as precise in proportion to its travel
   */
  text(input, words, decimals) {
    return this.written(this.place(input), words, decimals);
  }

  /**
   * @param {number} place in the reader's unit
   * @param {Words} words
   * @param {number} decimals
   */
  written(place, words, decimals) {
    return this.#withUnit(words.numbers.fixed(place, this.#decimals(decimals)), words);
  }

  /**
   * As {@link written}, without trailing zeros.
   * @param {number} input of the engine
   * @param {Words} words
   * @param {number} decimals
   */
  short(input, words, decimals) {
    return this.#withUnit(words.numbers.upTo(this.place(input), this.#decimals(decimals)), words);
  }

  /**
   * @param {number} place in the reader's unit
   * @param {Words} words
   * @returns {string} the place with all its digits, for editing
   */
  exact(place, { numbers }) {
    return numbers.exact(place) + (this.#turns ? "°" : "");
  }

  /**
   * @param {number} count
   * @param {Words} words
   * @returns {string} a turn, or the travel of a slide, divided by the count
   */
  share(count, words) {
    const part = this.#turns ? words.numbers.upTo(360 / count, 1) : words.numbers.upTo(this.#way / count, this.moves === "time" ? 5 : this.#decimals(5));
    return this.#withUnit(part, words);
  }

  /**
   * @param {number} one
   * @param {number} other input of the engine
   * @returns {boolean} whether the difference is invisible: less than half a degree, or than a small part of the travel or span
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
   * @param {number} place in the reader's unit
   * @returns {number} the same place on the axis
   */
  onto(place) {
    const { start, end } = this.axis(place);
    if (this.moves === "time") return Math.min(Math.max(place, start), end);
    if (!this.#turns || (place >= start && place <= end)) return place;
    const period = end - start;
    return place - period * Math.floor((place - start) / period);
  }
}
