// The engine of the built page, in Node.
import { readFileSync } from "node:fs";
import { Engine } from "assur/engine.js";
import { initSync } from "assur/pkg/assur_web.js";
import { initialState } from "assur/state/state.js";

/** The whole module, which the page loads in two parts. */
export const WASM = new URL("../../engine/assur_web_bg.wasm", import.meta.resolve("assur/pkg/assur_web.js"));

let begun = false;

/** @returns {Engine} a new engine; all engines share one instance of the module */
export function newEngine() {
  if (!begun) initSync({ module: readFileSync(WASM) });
  begun = true;
  return new Engine();
}

/**
 * @param {Engine} engine
 * @param {string} id of a mechanism of the catalogue
 * @param {object} [view]
 */
export function stateOf(engine, id, view = {}) {
  const { kind, document } = engine.catalogue.preset(id);
  return initialState(kind, document, { playing: false, ...view });
}
