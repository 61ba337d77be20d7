// The assemblies of a linkage: no edit waits for them.
import assert from "node:assert/strict";
import test from "node:test";
import { Simulator } from "assur/pkg/assur_web.js";
import { newEngine, stateOf } from "assur/tests/engine.js";

test("assemblies are found when they are first read, and only then", (t) => {
  const engine = newEngine();
  let asked = 0;
  const { assemblies } = Simulator.prototype;
  t.mock.method(Simulator.prototype, "assemblies", function (input) {
    asked += 1;
    return assemblies.call(this, input);
  });
  const first = engine.set(stateOf(engine, "class4-dwell"));
  const second = engine.set(stateOf(engine, "class4-dwell"));
  assert.equal(asked, 0);
  assert.deepEqual(second.assembled, { number: 3, count: 6, complete: true });
  assert.deepEqual(second.assembled, { number: 3, count: 6, complete: true });
  assert.equal(asked, 1);
  // Those of a mechanism that is gone are not those of the one that is there.
  assert.equal(first.assembled, null);
  assert.equal(asked, 1);
});

test("a mechanism without assemblies has none to read", () => {
  const engine = newEngine();
  assert.ok(!("assembled" in engine.set(stateOf(engine, "train-gears"))));
});
