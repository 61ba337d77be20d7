// A run of the motion under load: played in time, with all that was read on its way.
import { attempt } from "assur/core/problem.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/types/web.js").RunHere} Part
 */

/** Numbers of a reading with one driver: time, input, rate, acceleration, kinetic and potential energy, work, loss. */
const READING = 8;
/** Numbers of a reading for each further driver: coordinate, rate, acceleration. */
const FURTHER = 3;
/** Readings of a frame, and the processor time in milliseconds after which the rest of the frame is left to the next one. */
const READINGS = 4;
const BUDGET = 5;

export class LoadRun {
  #page;
  /** @type {State["document"] | null} document of the run; null without a run */
  #document = null;
  /** @type {number[]} all readings, one after another */
  readings = [];
  /** @type {"ended" | "locked" | "rests" | "over" | null} why the run has ended */
  end = null;
  /** @type {Part["at"]} dead point at which the run has ended */
  at = null;
  /** @type {readonly Problem[]} why a run of several drivers has ended */
  problems = [];
  /** Numbers of a reading. */
  width = READING;
  /** Factor of the time in which the run is played, and the time at which it is over, in seconds. */
  pace = 1;
  until = 10;

  /** @typedef {import("assur/state/state.js").State} State */

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
  }

  /**
   * @param {number} driver its index
   * @param {1 | 2 | 3} part coordinate, rate or acceleration
   * @returns {number} place of the number in a reading
   */
  static place(driver, part) {
    return driver === 0 ? part : READING + FURTHER * (driver - 1) + part - 1;
  }

  get exists() {
    return this.#document !== null;
  }

  get time() {
    return this.readings.at(-this.width) ?? 0;
  }

  /**
   * Goes on, or begins at the current input.
   * @param {number} rate at the start
   * @returns {readonly Problem[]} reasons why there is no run
   */
  go(rate) {
    const { store, model, engine } = this.#page;
    if (!this.exists || this.end) {
      const state = store.get();
      const { coordinate } = model;
      const { problems } = attempt(() => engine.simulator.startRun(coordinate.input(coordinate.of(state)), rate));
      if (problems.length > 0) return problems;
      this.forget();
      this.#document = state.document;
      this.width = READING + FURTHER * (state.kind === "linkage" ? state.document.drivers.length - 1 : 0);
      this.#read(0, 1);
    }
    this.#page.follow(this.#course);
    store.update((state) => withView(state, { playing: true }));
    return [];
  }

  stop() {
    this.#page.store.update((state) => withView(state, { playing: false }));
  }

  /** Goes back to the start. */
  rewind() {
    const { store, model } = this.#page;
    const start = this.readings[1];
    this.forget();
    if (start === undefined) return;
    store.update((state) => withView(model.coordinate.put(state, model.coordinate.inputShown(start)), { playing: false }));
  }

  forget() {
    if (this.exists) this.#page.follow(null);
    this.#document = null;
    this.readings = [];
    this.end = this.at = null;
    this.problems = [];
  }

  /**
   * Forgets a run that is not that of the page any more: another document, or an input set by hand.
   * @param {import("assur/state/model.js").Snapshot} snapshot
   */
  keep({ state, inputShown, coordinate }) {
    if (!this.exists) return;
    const input = this.readings.at(1 - this.width) ?? 0;
    const apart = !state.view.playing && !this.end && !coordinate.near(coordinate.input(inputShown), input);
    if (state.document !== this.#document || apart) this.forget();
  }

  /**
   * @param {number} dt seconds
   * @returns {number | null} input after that time; null if the run has ended
   */
  #course = (dt) => {
    if (this.end) {
      this.#page.follow(null);
      return null;
    }
    const now = this.readings.at(1 - this.width) ?? null;
    if (dt <= 0) return now;
    const begun = performance.now();
    const wanted = Math.min(this.time + dt * this.pace, this.until);
    const step = (wanted - this.time) / READINGS;
    for (let k = 1; k <= READINGS && !this.end && performance.now() - begun < BUDGET; k++) {
      this.#read(k === READINGS ? wanted : this.time + step, 1);
    }
    if (!this.end && this.time >= this.until) this.end = "over";
    return this.readings.at(1 - this.width) ?? null;
  };

  /**
   * @param {number} time
   * @param {number} count
   */
  #read(time, count) {
    const { value, problems } = attempt(() => this.#page.engine.simulator.advanceRun(time, count));
    // After a trap the engine has no run any more.
    if (!value || problems.length > 0) {
      this.end = "over";
      return;
    }
    for (const number of value.readings) this.readings.push(number);
    if (value.ends) this.end = value.locks ? "locked" : "ended";
    else if (value.rests) this.end = "rests";
    this.at = value.at;
    this.problems = value.problems;
  }
}
