// Moving the driver: by time, by hand, by steps.
import { attempt } from "assur/core/problem.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/model.js").Model} Model
 */

/** Time moves the driver. Where it has to turn back it does so by itself: the direction that a reader has chosen stays theirs. */
export class Player {
  /** 1 while it goes as the reader has said, −1 on the way back. */
  #sense = 1;

  /** Another mechanism goes as the reader has said. */
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
    // Where nothing can be assembled there is no motion to go on with: it starts at home.
    const { coordinate } = model;
    const from = model.placed ? coordinate.input(coordinate.of(state)) : model.home;
    const moved = attempt(() => engine.advance(from, this.#sense * view.direction * coordinate.pace(view) * dt));
    if (!moved.value) return withView(state, { playing: false });
    if (moved.value.sign < 0) this.#sense = -this.#sense;
    return coordinate.put(state, coordinate.place(moved.value.input));
  }
}

/**
 * The driver put to a place by hand; it stays there.
 * @param {State} state
 * @param {number} place as readers count
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
