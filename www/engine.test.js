// Tests that details of a summary, such as the assemblies of a linkage, are computed only when they are read.
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
  // After its document has been replaced, a summary still gives the assemblies of that document.
  engine.set(stateOf(engine, "crank-rocker"));
  assert.deepEqual(first.assembled, { number: 3, count: 6, complete: true });
  assert.equal(asked, 2);
});

test("details are those of the document whether it is still open or not", () => {
  const engine = newEngine();
  const read = ({ outputs, transmissions, profile, equations }) => ({ outputs, transmissions, profile, equations });
  for (const name of ["crank-rocker", "class4-dwell", "whitworth"]) {
    const state = stateOf(engine, name);
    const open = read(engine.set(state));
    const replaced = engine.set(state);
    engine.set(stateOf(engine, "train-gears"));
    assert.deepEqual(read(replaced), open);
    assert.ok(open.outputs.length > 0 && open.equations.length > 0, name);
  }
});

test("a mechanism without assemblies has none to read", () => {
  const engine = newEngine();
  assert.ok(!("assembled" in engine.set(stateOf(engine, "train-gears"))));
});
