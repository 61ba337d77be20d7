// Two links on the same two points are one body: a four-bar with one of its links doubled is the same four-bar, with one redundant constraint.
import assert from "node:assert/strict";
import test from "node:test";
import { initialState } from "assur/state/state.js";
import { newEngine } from "assur/tests/engine.js";

const PLACES = Object.freeze({
  "crank-rocker": { A: [0, 0], B: [0.5, 0.8], C: [3, 2], D: [3, 0] },
  parallelogram: { A: [0, 0], B: [0.6, 0.8], C: [2.6, 0.8], D: [2, 0] },
});
const LINKS = Object.freeze({ crank: "AB", coupler: "BC", rocker: "DC" });

/**
 * @param {Record<string, number[]>} places
 * @param {Record<string, string>} links their points, by name
 */
function four({ ...places }, links) {
  const points = Object.entries(places).map(([name, at]) => ({ name, at }));
  const all = Object.entries(links).map(([name, ends]) => ({ name, points: [...ends] }));
  return { points, frame: ["A", "D"], links: all, drivers: [{ crank: "crank" }] };
}

for (const [type, places] of Object.entries(PLACES)) {
  for (const ends of ["AB", "BC", "DC", "AD"]) {
    test(`a ${type} whose link ${ends} is doubled`, () => {
      const engine = newEngine();
      const plain = engine.set(initialState("linkage", four(places, LINKS), {}));
      const alone = { ...plain, assembled: plain.assembled };
      const doubled = engine.set(initialState("linkage", four(places, { ...LINKS, double: ends }), {}));
      const { counts: { by_count: count, mobility }, redundant } = doubled;
      assert.deepEqual([count, mobility, redundant.length], [0, 1, 1]);
      assert.ok(ends.includes(redundant[0]), redundant[0]);
      assert.deepEqual(doubled.assembled, alone.assembled);
      assert.equal(engine.trapped, false);
      for (const key of ["change_points", "dead_points", "cycle", "four_bars", "transmissions"]) assert.deepEqual(doubled[key], alone[key], key);
    });
  }
}
