// Tests of traps: each exported call in turn runs out of stack, which is reported, and the engine works on afterwards.
import assert from "node:assert/strict";
import test from "node:test";
import { Engine } from "assur/engine.js";
import * as module from "assur/pkg/assur_web.js";
import { withExtras } from "assur/state/state.js";
import { Context, themeOf } from "assur/tests/canvas.js";
import { stateOf } from "assur/tests/engine.js";
import { begin, exhaust } from "assur/tests/stack.js";

begin();
const engine = new Engine();
const state = stateOf(engine, "crank-rocker");
const shared = withExtras(state, { compared: { kind: state.kind, document: engine.catalogue.preset("class4-dwell").document } });
const INPUT = 0.5;
const { palette, scale } = themeOf(engine.roles);
const REQUEST = { width: 400, height: 300, palette, scale, ratio: 1, whole: false, only: "all", around: 0 };
const EDIT = { edit: "place", point: "B", at: [1, 1] };

const ENDS = { x: [1, 2], input_deg: [90, 150], output_deg: [210, 270] };
const FUNCTION = { ...state, kind: "synthesis", document: { frame: 1, positions: [], function: { of: "log10", ...ENDS } } };

const PATH = { ...state, kind: "point-path", document: { path: [[0, 0], [1, 0], [1, 1]] } };
const PAGE = { third: "frame", ratio: 3, point: [0.5, 0.5] };

/** Arguments of each method of a simulator. */
const METHODS = {
  set: [state], lengths: [], choosesLengths: [], labelNames: [], scene: [], at: [INPUT], plotted: [INPUT], why: [INPUT], readouts: [], drag: ["B", INPUT, 1, 1],
  press: ["B"], edit: [EDIT, INPUT], part: [["A"], [], INPUT], linkAt: [INPUT, 1, 1], asKind: ["mixer", INPUT], trace: [INPUT, 1, 1], setDimension: ["links[0].length", 2, INPUT],
  drive: ["rocker", INPUT], assemblies: [INPUT], assemble: [1, INPUT], advance: [INPUT, 0.1], chart: [new Context(), REQUEST], sweep: [12], equations: [INPUT, 2], curvature: [INPUT],
  polygons: [INPUT, 3], forces: [INPUT], forcePlan: [INPUT, 3], forceLever: [INPUT], freeBody: [INPUT, 0], equilibrium: [INPUT, { link: 0, about: 0, reversed: [], answers: [] }], plotsForces: [], greatestForces: [], masses: [], startRun: [INPUT, 1], advanceRun: [0.1, 1], cycle: [1, 0.1], relations: [INPUT], outputs: [], transmissions: [], profile: [], constraints: [],
};

/** Arguments of each function of the module. */
const FUNCTIONS = {
  blank: [], catalogue: [], checkKeys: ["{}"], functionPositions: [FUNCTION, 3, false], isImport: ["{}"], numbersOf: [state], pathAtlas: [PATH, PAGE], pathOfCell: [PATH, PAGE, 3], qrCode: ["text"], readImport: ["{}"], readLesson: [{}], readState: [state], roleNames: [],
  shelves: [], task: [1], defaultView: [], mixers: [],
};

/** Methods that are not in `METHODS`: those with two simulators have a test of their own, `setSymbol` needs no memory, the others belong to wasm-bindgen. */
const ELSEWHERE = ["setSymbol", "constructor", "free", "__destroy_into_raw", "chartCompared", "sweepCompared"];

test("every exported call is here", () => {
  const methods = Object.getOwnPropertyNames(module.Simulator.prototype).filter((name) => !ELSEWHERE.includes(name));
  assert.deepEqual(methods.sort(), Object.keys(METHODS).sort());
  const functions = Object.keys(module).filter((name) => !["AllMotions", "Design", "NinePointSearch", "NinePointWorker", "PathSearch", "Simulator", "default", "initSync", "second", "__wbg_reset_state"].includes(name));
  assert.deepEqual(functions.sort(), Object.keys(FUNCTIONS).sort());
});

/**
 * Makes a call trap ten times in a row, and tests each time that the engine works on.
 * @param {string} name
 * @param {(simulator: module.Simulator) => unknown} call
 * @returns {number} how often it trapped
 */
function trapped(name, call) {
  let count = 0;
  for (let times = 0; times < 10; times++) {
    engine.set(state);
    const before = engine.at(INPUT);
    exhaust();
    try {
      call(engine.simulator);
    } catch (refusal) {
      assert.deepEqual([refusal.problems, engine.trapped], [[{ code: "trapped" }], true], name);
      count++;
    }
    assert.deepEqual(engine.at(INPUT), before, name);
    assert.deepEqual(engine.set(state).counts.mobility, 1, name);
    assert.equal(engine.trapped, false);
  }
  return count;
}

const quiet = (t) => t.mock.method(console, "error", () => {});

for (const [name, given] of Object.entries(METHODS)) {
  test(`${name} overflows ten times, and the engine works on`, (t) => {
    quiet(t);
    assert.equal(trapped(name, (simulator) => simulator[name](...given)), 10);
  });
}

for (const [name, given] of Object.entries(FUNCTIONS)) {
  test(`${name} overflows ten times, and the engine works on`, (t) => {
    quiet(t);
    assert.equal(trapped(name, () => engine.functions[name](...given)), 10);
  });
}

test("what is compared overflows: it is shown no more, and the mechanism works on without a word of it", (t) => {
  quiet(t);
  for (let times = 0; times < 10; times++) {
    engine.set(state);
    engine.set(shared);
    assert.ok(engine.compared(INPUT));
    const before = engine.at(INPUT);
    exhaust();
    assert.equal(engine.compared(INPUT), null);
    assert.equal(engine.trapped, false);
    assert.deepEqual(engine.at(INPUT), before);
    assert.equal(engine.compares, false);
  }
});

for (const [name, call] of Object.entries({ chart: () => engine.chart(new Context(), REQUEST), sweep: () => engine.sweep(12) })) {
  test(`${name} with what is compared overflows ten times, and the engine works on`, (t) => {
    quiet(t);
    for (let times = 0; times < 10; times++) {
      engine.set(state);
      engine.set(shared);
      assert.ok(engine.compares);
      exhaust();
      assert.throws(call, ({ problems }) => problems[0].code === "trapped");
      engine.set(shared);
      assert.ok(engine.compares);
      call();
    }
  });
}

test("a scratch simulator overflows, and what is compared comes again with the next state", (t) => {
  quiet(t);
  engine.set(shared);
  assert.throws(() => engine.withScratchSimulator((other) => {
    other.set(state);
    exhaust();
    return other.at(INPUT);
  }), ({ problems }) => problems[0].code === "trapped");
  assert.equal(engine.compared(INPUT), null);
  engine.set(shared);
  assert.ok(engine.compared(INPUT));
});
