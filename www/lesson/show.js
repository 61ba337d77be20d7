// Documents that a step of a lesson opens, and the view in which each is opened.
import { attempt } from "assur/core/problem.js";
import { fieldOf } from "assur/lesson/field.js";
import { Coordinate } from "assur/state/coordinate.js";
import { SWITCHES, contains, initialState } from "assur/state/state.js";

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/state/details.js").Summary} Summary
 * @typedef {import("assur/lesson/folder.js").OwnPresets} OwnPresets
 * @typedef {import("assur/lesson/folder.js").Show} Show
 * @typedef {import("assur/lesson/folder.js").TypedDocument} TypedDocument
 * @typedef {import("assur/state/state.js").View} View
 */

/**
 * @param {Show} show
 * @param {OwnPresets} presets of the lesson
 * @param {Engine} engine
 * @returns {import("assur/lesson/folder.js").TypedDocument | undefined} the preset that the button opens, undefined if there is none of this name
 */
export function opens({ preset }, presets, engine) {
  const opened = presets[preset] ?? engine.catalogue.preset(preset);
  return opened && /** @type {TypedDocument} */ ({ kind: opened.kind, document: opened.document });
}

/**
 * Opens a step's document, in one undo step.
 * @param {Show} show
 * @param {OwnPresets} presets of the lesson
 * @param {import("assur/app/page.js").Page} page
 * @param {Partial<View>} [view] further fields of the view
 * @returns {boolean} whether the preset of `show` exists
 */
export function open(show, presets, page, view = {}) {
  const opened = opens(show, presets, page.engine);
  if (opened) page.choose(opened.kind, opened.document, edits(show, opened.document, page.engine.simulator), (summary) => ({ ...looked(show, summary), ...view }));
  return opened !== undefined;
}

/**
 * @param {Show} show
 * @param {OwnPresets} presets of the lesson
 * @param {Engine} engine
 * @returns {(state: import("assur/state/state.js").State) => boolean} tests whether a state contains the document that
 * `show` opens
 */
export function holds(show, presets, engine) {
  return (state) => {
    const opened = opens(show, presets, engine);
    if (!opened || opened.kind !== state.kind) return false;
    if (!show.set && !show.drive) return contains(state, opened);
    // The preset gets the same edits here as in `open`.
    const document = attempt(() => engine.withScratchSimulator((other) => edits(show, opened.document, other).reduce((now, { asked }) => {
      const summary = other.set(initialState(opened.kind, now, {}));
      return /** @type {TypedDocument["document"]} */ ({ ...now, ...asked(summary.moves === null ? 0 : summary.home).document });
    }, opened.document))).value;
    return document !== null && contains(/** @type {object} */ (state.document), document);
  };
}

/**
 * @param {Show} show
 * @param {TypedDocument["document"]} document document of the preset
 * @param {Pick<import("assur/pkg/assur_web.js").Simulator, "setDimension" | "drive">} simulator
 * @returns {import("assur/state/change.js").Edit[]} edits that turn the preset into the document to open
 */
function edits({ set = {}, drive }, document, simulator) {
  /** @type {import("assur/state/change.js").Edit[]} */
  const all = Object.entries(set).map(([name, value]) => {
    const field = fieldOf(name, document);
    return { asked: (home) => simulator.setDimension(field, value, home), field };
  });
  if (drive !== undefined) all.push({ asked: (home) => simulator.drive(drive, home), field: "drivers" });
  return all;
}

/**
 * @param {Show} show
 * @param {Summary | null} summary summary of the document, or null if the engine refuses it
 * @returns {Partial<View>} fields of the view in which the document is opened
 */
function looked({ play = false, overlays = ["traces"], plot = "angles", omega, at }, summary) {
  const shown = Object.fromEntries(SWITCHES.map((name) => [name, overlays.includes(name)]));
  const input = summary ? at?.(summary) : undefined;
  const coordinate = summary?.moves ? new Coordinate(summary.moves, summary.cycle, summary.input) : null;
  const driven = input === undefined || !coordinate ? {} : { [coordinate.viewKey]: coordinate.inputShown(input) };
  // The texts of steps describe plots of analogues, whatever the reader chose before.
  const rate = omega === undefined ? {} : { omega, epsilon: 0 };
  return { ...shown, ...rate, plot, axes: "analogues", ...driven, playing: play };
}
