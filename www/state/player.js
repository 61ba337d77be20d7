// Motion of the driver: in time and by hand.
import { attempt } from "assur/core/problem.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/model.js").Model} Model
 * @typedef {(dt: number) => number | null} Course gives the input after a time in seconds, in the engine's unit; null at its end
 */

/** Motion of the driver in time. The driver reverses at the ends of its range; the state keeps the chosen direction. */
export class Player {
  /** 1 in the direction chosen by the reader, −1 in the opposite direction. */
  #sense = 1;
  /** @type {Course | null} motion that the input follows instead of moving at its pace */
  course = null;

  /** Resets the direction to the one chosen by the reader, because another mechanism is shown. */
  begin() {
    this.#sense = 1;
    this.course = null;
  }

  /**
   * Returns the state `dt` seconds later.
   * @param {State} state
   * @param {number} dt
   * @param {import("assur/engine.js").Engine} engine
   * @param {Model} model
   * @returns {State}
   */
  played(state, dt, engine, model) {
    const { view } = state;
    if (!view.playing) return state;
    // If the mechanism cannot be assembled at this input, the motion starts at the drawn input.
    const { coordinate } = model;
    if (this.course) {
      const input = this.course(dt);
      return input === null ? withView(state, { playing: false }) : coordinate.put(state, coordinate.inputShown(input));
    }
    const from = model.hasPose ? coordinate.input(coordinate.of(state)) : model.home;
    const { value: moved } = attempt(() => engine.simulator.advance(from, this.#sense * view.direction * coordinate.pace(view) * dt));
    if (!moved) return withView(state, { playing: false });
    const [input, sense] = moved;
    if (sense < 0) this.#sense = -this.#sense;
    return coordinate.put(state, coordinate.inputShown(input));
  }
}

/**
 * Returns the state with the driver moved by hand and the motion stopped.
 * @param {State} state
 * @param {number} inputShown input in the reader's unit
 * @param {Model} model
 * @returns {State}
 */
export function stoppedAt(state, inputShown, model) {
  return withView(model.coordinate.put(state, inputShown), { playing: false });
}

/**
 * @param {1 | -1} direction
 * @returns {1 | -1}
 */
export function turned(direction) {
  return direction === 1 ? -1 : 1;
}
