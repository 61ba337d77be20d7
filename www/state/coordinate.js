// The input of the motion as readers meet it: the angle of a crank in degrees, how far a slide has come, or time in seconds. The
// engine has radians, the unit of the lengths, seconds.
import { degrees, radians } from "assur/core/angles.js";
import { subscript } from "assur/core/symbols.js";
import { measured } from "assur/core/units.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").State} State
 */

/** What moves: the place of its input in the view and its letter with those of its rates. An angle has the number of its link. */
const SORTS = Object.freeze({
  angle: Object.freeze({ field: /** @type {const} */ ("phi_deg"), symbol: "φ", rates: Object.freeze(["ω", "ε"]) }),
  length: Object.freeze({ field: /** @type {const} */ ("s"), symbol: "s", rates: Object.freeze(["v", "a"]) }),
  time: Object.freeze({ field: /** @type {const} */ ("t"), symbol: "t", rates: Object.freeze(["", ""]) }),
});

/** At speed 1 a crank turns once, and a slide goes there and back, in so many seconds. */
const PERIOD = 6;

/** A slide's way, and a span of time, is gone in about so many small steps. */
const STEPS = 100;

/** The longest time, in seconds, as the engine takes it. */
const LONGEST = 1e6;

/** So small a part of a time nobody sees. */
const HAIR = 1e-9;

/** The fields of the view that hold an input, whatever moves. */
export const FIELDS = Object.freeze(Object.values(SORTS).map(({ field }) => field));

export class Coordinate {
  #turns;
  #cycle;
  #sort;
  #number;

  /**
   * @param {"angle" | "length" | "time"} moves
   * @param {import("assur/engine.js").Cycle} cycle where the input goes, in the engine's unit
   * @param {string} [number] by which it is called
   */
  constructor(moves, cycle, number = "1") {
    this.moves = moves;
    this.#turns = moves === "angle";
    this.#cycle = cycle;
    this.#sort = SORTS[moves];
    this.#number = subscript(number);
  }

  /** The field of the view that holds it. */
  get field() {
    return this.#sort.field;
  }

  get symbol() {
    return this.#sort.symbol + (this.#turns ? this.#number : "");
  }

  /** The symbols of its velocity and its acceleration. */
  get rates() {
    return this.#sort.rates.map((letter) => letter + this.#number);
  }

  /**
   * The ends of its axis, as readers count. Time that goes on and on has one span after the other.
   * @param {number} place as readers count
   */
  axis(place) {
    const [start, end] = [this.#cycle.start, this.#cycle.end].map((input) => this.place(input));
    if (!this.#goesOn) return { start, end };
    const before = Math.max(0, Math.floor(place / end)) * end;
    return { start: before, end: before + end };
  }

  /**
   * The last place of the axis that shows a place: where time goes on, the next span begins at the end of the axis.
   * @param {number} place as readers count
   */
  last(place) {
    const { end } = this.axis(place);
    return this.#goesOn ? end * (1 - HAIR) : end;
  }

  /** A small step by hand, as readers count. */
  get step() {
    return this.#turns ? 1 : 10 ** Math.round(Math.log10(this.#way / STEPS));
  }

  /**
   * How fast it goes, in the engine's unit per second. In real time the driver moves with ω₁ alone: ε₁ is what it has at the
   * instant, it does not hasten.
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
   * @returns {number} as readers count
   */
  place(input) {
    return this.#turns ? degrees(input) : input;
  }

  /**
   * @param {number} place as readers count
   * @returns {number} for the engine
   */
  input(place) {
    return this.#turns ? radians(place) : place;
  }

  /**
   * @param {State} state
   * @returns {number} where its input is on the axis, as readers count. Both ends of the axis stay as they are.
   */
  of({ view }) {
    return this.onto(view[this.field]);
  }

  /**
   * @param {State} state
   * @param {number} place as readers count
   * @returns {State} with the input there; a slide stops at the ends of its way, time at 0 and at the end of a run
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
   * @param {number} decimals of an angle; of a length as many of its way
   */
  text(input, words, decimals) {
    return this.written(this.place(input), words, decimals);
  }

  /**
   * @param {number} place as readers count
   * @param {Words} words
   * @param {number} decimals
   */
  written(place, words, decimals) {
    return this.#withUnit(words.numbers.fixed(place, this.#decimals(decimals)), words);
  }

  /**
   * As {@link written}, without zeros at the end.
   * @param {number} input of the engine
   * @param {Words} words
   * @param {number} decimals
   */
  short(input, words, decimals) {
    return this.#withUnit(words.numbers.upTo(this.place(input), this.#decimals(decimals)), words);
  }

  /**
   * @param {number} place as readers count
   * @param {Words} words
   * @returns {string} with all its digits, to be typed over
   */
  exact(place, { numbers }) {
    return numbers.exact(place) + (this.#turns ? "°" : "");
  }

  /**
   * @param {number} count
   * @param {Words} words
   * @returns {string} a turn, or a slide's way, divided into so many parts
   */
  share(count, words) {
    const part = this.#turns ? words.numbers.upTo(360 / count, 1) : words.numbers.upTo(this.#way / count, this.moves === "time" ? 5 : this.#decimals(5));
    return this.#withUnit(part, words);
  }

  /**
   * @param {number} one
   * @param {number} other input of the engine
   * @returns {boolean} whether nobody sees a difference: half a degree, or a part of a slide's way or of a span of time
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
   * @param {number} place as readers count
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
