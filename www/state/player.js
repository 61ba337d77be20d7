// Moving the driver: by time, by hand, by steps.
import { attempt } from "assur/core/problem.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/state/model.js").Model} Model
 */

/**
 * The state dt seconds later.
 * @param {State} state
 * @param {number} dt
 * @param {Engine} engine
 * @param {Model} model
 * @returns {State}
 */
export function played(state, dt, engine, model) {
  const { view } = state;
  if (!view.playing) return state;
  // Where nothing can be assembled there is no motion to go on with: it starts at home.
  const { coordinate } = model;
  const from = model.placed ? coordinate.input(coordinate.of(state)) : model.home;
  const moved = attempt(() => engine.advance(from, view.direction * coordinate.pace(view) * dt));
  if (!moved.value) return withView(state, { playing: false });
  const direction = moved.value.sign < 0 ? turned(view.direction) : view.direction;
  return withView(coordinate.put(state, coordinate.place(moved.value.input)), { direction });
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
