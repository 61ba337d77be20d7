// Tests of the status line of a linkage: it omits what was not searched for, and counts links on the same two points as one body.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import "assur/tests/document.js";
import { initialState } from "assur/state/state.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { shownOf } from "assur/tests/shown.js";

const engine = newEngine();

/**
 * @param {import("assur/state/state.js").State} state
 * @returns {(name: string) => string} gives the text of an entry by its name; empty if there is no such entry
 */
function told(state) {
  shownOf(engine, state);
  return (name) => {
    const output = globalThis.document.querySelector(`#status #out-${name}`);
    return output.parentElement.hidden ? "" : output.textContent;
  };
}

test("of a motion of too many turns nothing is said that was not looked for, and why", () => {
  const document = JSON.parse(readFileSync(new URL("../../../tests/data/drawings/hunting-wheels.json", import.meta.url), "utf8"));
  const said = told(initialState("linkage", document, { lang: "en" }));
  for (const name of ["linkage-swing", "linkage-stroke", "linkage-time-ratio", "linkage-transmission"]) assert.equal(said(name), "", name);
  assert.match(said("linkage-unsearched"), /^not looked for: .*974\D?153 turns/);
  assert.equal(told(stateOf(engine, "crank-rocker", { lang: "en" }))("linkage-unsearched"), "");
});
