// What a step of a lesson shows: the document that it opens, and how that is looked at.
import { Coordinate } from "assur/state/coordinate.js";
import { SWITCHES } from "assur/state/state.js";

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/engine.js").Summary} Summary
 * @typedef {import("assur/lesson/panel.js").OwnPresets} OwnPresets
 * @typedef {import("assur/lesson/panel.js").Show} Show
 * @typedef {import("assur/state/state.js").View} View
 */

/**
 * @param {Show} show
 * @param {OwnPresets} presets of the lesson
 * @param {Engine} engine
 * @returns {import("assur/lesson/panel.js").Whole | undefined} what it opens
 */
export function opens({ preset, change = (document) => document }, presets, engine) {
  const whole = presets[preset] ?? engine.preset(preset);
  return whole && /** @type {import("assur/lesson/panel.js").Whole} */ ({ kind: whole.kind, document: change(whole.document) });
}

/**
 * @param {Show} show
 * @param {Summary | null} summary of what it opens, where the engine takes it
 * @returns {Partial<View>} how that is looked at
 */
export function looked({ play = false, overlays = ["traces"], at }, summary) {
  const shown = Object.fromEntries(SWITCHES.map((name) => [name, overlays.includes(name)]));
  const input = summary ? at?.(summary) : undefined;
  const coordinate = summary?.moves ? new Coordinate(summary.moves, summary.cycle) : null;
  const place = input === undefined || !coordinate ? {} : { [coordinate.field]: coordinate.place(input) };
  // The plots are those that the words are about.
  return { ...shown, plot: "angles", axes: "analogues", ...place, playing: play };
}
