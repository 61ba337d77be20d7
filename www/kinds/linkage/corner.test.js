// Tests of the angles of links with three points, set by the call that the rail makes.
import assert from "node:assert/strict";
import test from "node:test";
import { initialState } from "assur/state/state.js";
import { newEngine } from "assur/tests/engine.js";

const PLACES = Object.freeze({ A: [0, 0], D: [4, 0], B: [0.6, 0.8], C: [3.5, 2.5], E: [2, 3], F: [4, 5], G: [5, 3] });
const LINKS = Object.freeze({ crank: "AB", coupler: "BCE", rocker: "CD", rod: "EF", arm: "FG" });

test("an angle that is set the shorter way round is refused by the way that it went", () => {
  const engine = newEngine();
  const points = Object.entries(PLACES).map(([name, at]) => ({ name, at }));
  const links = Object.entries(LINKS).map(([name, ends]) => ({ name, points: [...ends] }));
  const document = { points, frame: ["A", "D", "G"], links, drivers: [{ crank: "crank" }] };
  const { home } = engine.set(initialState("linkage", document, {}));
  // As the present angle is 27°, 250° is reached as −110°, and −200° as 160°.
  for (const [angle, refused, wound] of [[250, "too_small", -110], [-200, "too_large", 160], [-110, "too_small", -110], [160, "too_large", 160]]) {
    assert.throws(() => engine.simulator.setDimension("links[1].corner_deg[2]", angle, home), ({ problems: [{ code, by, last }] }) => {
      assert.equal(code, refused, String(angle));
      assert.ok(Math.abs(Math.abs(wound - last) - by) < 1e-9, `${wound} ${last} ${by}`);
      return true;
    });
  }
});
