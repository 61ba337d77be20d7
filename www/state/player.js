// Motion of the driver: in time, by hand, in steps.
import { attempt } from "assur/core/problem.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/model.js").Model} Model
 */

/** Motion of the driver in time. The driver turns back by itself where it must; the direction chosen by the reader is kept. */
export class Player {
  /** 1 in the direction chosen by the reader, −1 on the way back. */
  #sense = 1;

  /** Starts another mechanism in the direction chosen by the reader. */
  begin() {
    this.#sense = 1;
  }

  /**
   * The state dt seconds later.
   * @param {State} state
   * @param {number} dt
   * @param {import("assur/engine.js").Engine} engine
   * @param {Model} model
   * @returns {State}
   */
  played(state, dt, engine, model) {
    const { view } = state;
    if (!view.playing) return state;
    // A pose that cannot be assembled has no motion to continue: it starts at the drawn input.
    const { coordinate } = model;
    const from = model.placed ? coordinate.input(coordinate.of(state)) : model.home;
    const moved = attempt(() => engine.advance(from, this.#sense * view.direction * coordinate.pace(view) * dt));
    if (!moved.value) return withView(state, { playing: false });
    if (moved.value.sign < 0) this.#sense = -this.#sense;
    return coordinate.put(state, coordinate.place(moved.value.input));
  }
}

/**
 * The state with the driver put to a place by hand, where it stays.
 * @param {State} state
 * @param {number} place in the reader's unit
 * @param {Model} model
 * @returns {State}
 */
export function placed(state, place, model) {
  return withView(model.coordinate.put(state, place), { playing: false });
}

/**
 * @param {1 | -1} direction
 * @returns {1 | -1}
 */
export function turned(direction) {
  return direction === 1 ? -1 : 1;
}
