// Moving the crank: by time, by hand, by steps.
import { degrees, ontoAxis, radians } from "assur/core/angles.js";
import { attempt } from "assur/core/problem.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/state/model.js").Model} Model
 */

/** At speed 1 the crank turns once in six seconds, in radians per second. */
const CRANK_SPEED = (2 * Math.PI) / 6;

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
  const from = model.placed ? radians(view.phi_deg) : model.summary.home;
  // In real time the driver turns with ω₁ alone: ε₁ is what it has at the instant, it does not hasten.
  const speed = view.true_time ? view.omega : view.speed * CRANK_SPEED;
  const moved = attempt(() => engine.advance(from, view.direction * speed * dt));
  if (!moved.value) return withView(state, { playing: false });
  const direction = moved.value.sign < 0 ? turned(view.direction) : view.direction;
  return withView(state, { phi_deg: degrees(moved.value.input), direction });
}

/**
 * The crank put to an angle by hand; it stays there.
 * @param {State} state
 * @param {number} phiDeg
 * @param {Model} model
 * @returns {State}
 */
export function placed(state, phiDeg, model) {
  return withView(state, { phi_deg: ontoAxis(phiDeg, model.summary.cycle), playing: false });
}

/**
 * @param {1 | -1} direction
 * @returns {1 | -1}
 */
export function turned(direction) {
  return direction === 1 ? -1 : 1;
}
