// Computations of the engine for a lecturer's lesson: the mechanism of a step with the reader's own numbers, and the answers.
import { degrees } from "assur/core/angles.js";
import { attempt } from "assur/core/problem.js";
import { idOf, readingOf } from "assur/core/quantity.js";
import { ownNumbers, valueIn } from "assur/lesson/chance.js";
import { withNumber } from "assur/lesson/field.js";
import { W, isAngle } from "assur/lesson/quantity.js";
import { Coordinate } from "assur/state/coordinate.js";
import { outputsOf } from "assur/state/details.js";
import { Names, Readouts } from "assur/state/readouts.js";
import { initialState, withDocument, withoutExtras } from "assur/state/state.js";

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/state/details.js").Summary} Summary
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/state.js").View} View
 * @typedef {import("assur/state/state.js").Written} Written
 * @typedef {Written["steps"][number]} Step
 * @typedef {NonNullable<Step["shows"]>} Shows
 * @typedef {Readonly<{ state: State, own: readonly Readonly<{ field: string, value: number }>[] }>} Task
 * `state`: the mechanism of a step, with the reader's own numbers. `own`: these numbers, with their fields.
 */

/** Defaults for the view of a step: the motion is stopped, with the driver at zero. */
export const RESTING = Object.freeze({ phi_deg: 0, playing: false });

/** Number of attempts to find random numbers that give a valid mechanism. */
const TRIES = 64;

/** Properties of a whole motion that can be asked for, by the suffix of the quantity. */
const PROPERTIES = Object.freeze(["swing", "time_ratio", "worst"]);

/**
 * @param {Written} lesson
 * @param {number} index of a step
 * @returns {{ shows: Shows, index: number } | null} null if the step shows no document. `shows`: the document that it shows. `index`: the step
 * that has this document: the step itself or an earlier one.
 */
export function shownBy({ steps }, index) {
  const at = steps.findLastIndex(({ shows }, i) => i <= index && shows);
  const shows = steps[at]?.shows;
  return shows ? { shows, index: at } : null;
}

/**
 * @param {Written} lesson
 * @param {number} index of a step
 * @param {string} name of the reader; if it is empty, the lecturer's numbers are used
 * @param {Engine} engine
 * @returns {Task | null} null if the step shows nothing, or if no numbers were found that give a valid mechanism
 */
export function taskOf(lesson, index, name, engine) {
  const found = shownBy(lesson, index);
  if (!found) return null;
  const { shows: { kind, document, view, vary = [] }, index: at } = found;
  const state = initialState(kind, document, { ...RESTING, ...view });
  if (vary.length === 0 || name.trim() === "") return { state, own: [] };
  const next = ownNumbers(name, at);
  const followed = new Set((attempt(() => engine.functions.numbersOf(withoutExtras(state))).value ?? []).filter((one) => one.followed).map(({ field }) => field));
  return engine.withScratchSimulator((other) => {
    for (let tries = 0; tries < TRIES; tries++) {
      const own = vary.map((range) => ({ field: range.field, value: valueIn(range, next()) }));
      const fit = attempt(() => withOwn(state, own, followed, other)).value;
      if (fit) return { state: fit, own };
    }
    return null;
  });
}

/**
 * @param {State} state
 * @param {Task["own"]} own
 * @param {ReadonlySet<string>} followed fields to be set by the engine
 * @param {import("assur/pkg/assur_web.js").Simulator} other
 * @returns {State | null} the state with these numbers; null if they make a full cycle a limited motion or vice versa
 */
function withOwn(state, own, followed, other) {
  const first = other.set(state);
  // Numbers that the engine only stores are set together, so that the mechanism is built once for all of them.
  const written = own.filter(({ field }) => !followed.has(field));
  let now = withDocument(state, written.reduce((document, { field, value }) => withNumber(document, field, value), state.document));
  let summary = now === state ? first : other.set(now);
  for (const { field, value } of own) {
    if (!followed.has(field)) continue;
    const { document } = other.setDimension(field, value, summary.moves === null ? 0 : summary.home);
    now = withDocument(now, document ?? {});
    summary = other.set(now);
  }
  if (summary.moves === null || first.moves === null) return now;
  if (summary.cycle.full !== first.cycle.full) return null;
  const coordinate = coordinateOf(summary);
  other.at(coordinate.input(coordinate.of(now)));
  return now;
}

/** @param {Extract<import("assur/types/web.js").Summary, { moves: "angle" | "length" | "time" }>} summary */
export function coordinateOf({ moves, cycle, input }) {
  return new Coordinate(moves, cycle, input);
}

/**
 * @param {Written} lesson
 * @param {number} index of a step whose answer is a number
 * @param {string} name of the reader
 * @param {Engine} engine
 * @returns {number | null} the lecturer's value or, for a quantity, the engine's; null if the mechanism has no such quantity
 */
export function answerOf(lesson, index, name, engine) {
  const { quantity, at, value } = lesson.steps[index].question?.number ?? {};
  if (value !== undefined && value !== null) return value;
  const task = quantity ? taskOf(lesson, index, name, engine) : null;
  if (!task || !quantity) return null;
  return engine.withScratchSimulator((other) => attempt(() => {
    const summary = engine.detailed(other.set(task.state), task.state);
    if (summary.moves === null) return valueOf(quantity, { summary, inputShown: 0, readouts: null });
    const coordinate = coordinateOf(summary);
    const inputShown = at ?? coordinate.of(task.state);
    return valueOf(quantity, { summary, inputShown, readouts: Readouts.of(new Names(other.readouts()), other.at(coordinate.input(inputShown)).readouts) });
  })).value;
}

/**
 * @param {string} quantity
 * @param {Pick<import("assur/state/model.js").AnySnapshot, "summary" | "inputShown" | "readouts">} here
 * @returns {number | null} the quantity's value in the reader's unit, null if there is none
 */
export function valueOf(quantity, { summary, inputShown, readouts }) {
  if (quantity === W) return summary.moves !== null && "counts" in summary && "lower" in summary.counts ? summary.counts.mobility : null;
  if (quantity === "input") return summary.moves === null ? null : inputShown;
  const [name, property] = quantity.split(":");
  if (property !== undefined) return propertyOf(name, property, summary);
  const reading = readingOf(name);
  const value = readouts?.value(reading.quantity, reading.order);
  return value === undefined ? null : counted(value, name);
}

/**
 * @param {number} value
 * @param {string} quantity
 * @returns {number} the value, in degrees if it is an angle
 */
function counted(value, quantity) {
  return isAngle(quantity) ? degrees(value) : value;
}

/**
 * @param {string} name
 * @param {string} property one of {@link PROPERTIES}
 * @param {Summary} summary
 */
function propertyOf(name, property, summary) {
  if (property === "worst") {
    const worst = "transmissions" in summary ? summary.transmissions.find(({ joint, what }) => `${joint}.${what}` === name)?.worst : undefined;
    return worst === undefined || worst === null ? null : degrees(worst);
  }
  const output = outputsOf(summary).find((one) => one.name === name);
  if (property === "time_ratio") return output?.time_ratio ?? null;
  const stroke = property === "swing" ? output?.swing[0]?.stroke : undefined;
  return stroke === undefined ? null : counted(stroke, name);
}

/**
 * @param {Pick<import("assur/state/model.js").AnySnapshot, "summary" | "readouts" | "inputShown">} here
 * @returns {string[]} all quantities that have a value for the mechanism
 */
export function quantities(here) {
  const { summary, readouts } = here;
  if (summary.moves === null) return [W].filter((name) => valueOf(name, here) !== null);
  const outputs = outputsOf(summary).map(({ name }) => name);
  const joints = "transmissions" in summary ? summary.transmissions.map(({ joint, what }) => `${joint}.${what}`) : [];
  const properties = [...outputs, ...joints].flatMap((name) => PROPERTIES.map((property) => `${name}:${property}`));
  const read = readouts?.names.all.map(({ quantity, order }) => idOf(quantity, order)) ?? [];
  return [...new Set(["input", W, ...properties, ...read])].filter((name) => valueOf(name, here) !== null);
}
