// Tests of the search for all motions, with its worker.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test, { afterEach } from "node:test";
import { Motions } from "assur/assemblies/motions.js";
import { withDocument, withoutExtras } from "assur/state/state.js";
import { WASM, newEngine, stateOf } from "assur/tests/engine.js";
import { withoutStack } from "assur/tests/stack.js";
import { Worker, endWorkers, fetchFile } from "assur/tests/worker.js";

const engine = newEngine();
const [rocker, class4] = ["crank-rocker", "class4-dwell"].map((id) => withoutExtras(stateOf(engine, id)));

/** Time limit for the answers of a worker, in milliseconds. */
const PATIENCE = Object.freeze({ timeout: 60_000 });

globalThis.Worker = Worker;
globalThis.fetch = fetchFile;
afterEach(endWorkers);

/** All motions, and a function that waits for answers of the worker until a condition holds. */
function begin() {
  const waiting = [];
  const motions = new Motions(() => waiting.splice(0).forEach((done) => done()));
  const until = async (holds) => {
    while (!holds()) await new Promise((done) => waiting.push(done));
  };
  return { motions, until };
}

// This test must be the first: once the engine has loaded, it is not requested again.
test("where the engine does not arrive the map is lost, and the next linkage gets another worker", PATIENCE, async (t) => {
  const { motions, until } = begin();
  const down = t.mock.method(globalThis, "fetch", async () => {
    throw new TypeError("no net");
  });
  motions.of(1, rocker);
  await until(() => motions.lost);
  assert.equal(Worker.running.size, 0);
  down.mock.restore();
  motions.of(2, rocker);
  await until(() => motions.current);
  assert.deepEqual([motions.map.branches.length, motions.lost], [2, false]);
});

test("the engine is compiled once for all workers", PATIENCE, async (t) => {
  const asked = t.mock.method(globalThis, "fetch");
  const sent = t.mock.method(Worker.prototype, "postMessage");
  for (let times = 0; times < 2; times++) {
    const { motions, until } = begin();
    motions.of(1, rocker);
    await until(() => motions.current);
  }
  assert.equal(asked.mock.callCount(), 0);
  const [one, other] = sent.mock.calls.map(({ arguments: [data] }) => data.wasm);
  for (const part of ["first", "second"]) assert.ok(one[part] instanceof WebAssembly.Module && one[part] === other[part], part);
});

test("the map of a linkage is found, and where its assemblies belong", PATIENCE, async () => {
  const { motions, until } = begin();
  motions.of(1, rocker);
  assert.deepEqual([motions.map, motions.current, motions.lost], [null, false, false]);
  await until(() => motions.current);
  assert.deepEqual([motions.map.whole, motions.map.branches.length, motions.map.circuits], [true, 2, 2]);
  motions.at(1, 0);
  await until(() => motions.branch !== null);
  assert.ok([0, 1].includes(motions.branch), String(motions.branch));
  // Assemblies on the same branch are reached without a fold; those of another circuit are never reached.
  assert.deepEqual(motions.reached(1, 0), [[], null]);
  // At another input the assemblies may have other numbers, so nothing is known about them.
  assert.deepEqual([motions.reached(1.1, 0), motions.reached(1, 1)], [null, null]);
});

test("where assemblies belong is asked only once the map is there, and once for each place", PATIENCE, async () => {
  const { motions, until } = begin();
  motions.at(1, 0);
  motions.of(1, rocker);
  motions.at(1, 0);
  assert.equal(motions.branch, null);
  await until(() => motions.current);
  motions.at(1, 0);
  await until(() => motions.branch !== null);
  const reached = motions.reached(1, 0);
  motions.at(1, 0);
  assert.equal(motions.reached(1, 0), reached);
  motions.at(2, 1);
  assert.equal(motions.branch, null);
  await until(() => motions.branch !== null);
  assert.deepEqual(motions.reached(2, 1), [null, []]);
});

test("of linkages that follow each other quickly the newest is found in the end, by one worker", PATIENCE, async () => {
  const { motions, until } = begin();
  motions.of(1, rocker);
  for (let revision = 2; revision < 9; revision++) motions.of(revision, withDocument(rocker, { title: String(revision) }));
  motions.of(9, class4);
  await until(() => motions.current);
  assert.ok(motions.map.branches.length > 2, String(motions.map.branches.length));
  assert.equal(Worker.running.size, 1);
});

test("the same linkage is asked for once", PATIENCE, async () => {
  const { motions, until } = begin();
  motions.of(1, rocker);
  await until(() => motions.current);
  const { map } = motions;
  motions.of(1, rocker);
  assert.equal(motions.map, map);
  assert.equal(motions.current, true);
});

test("a linkage that the engine refuses has no map, and the next one has", PATIENCE, async () => {
  const { motions, until } = begin();
  motions.of(1, rocker);
  await until(() => motions.current);
  motions.of(2, withDocument(rocker, { links: [] }));
  await until(() => motions.lost);
  assert.deepEqual([motions.map, motions.current], [null, false]);
  motions.of(3, class4);
  await until(() => motions.current);
  assert.equal(motions.lost, false);
});

test("after a break at an input the next one is answered, by a worker of its own", PATIENCE, async () => {
  const { motions, until } = begin();
  motions.of(1, rocker);
  await until(() => motions.current);
  // A BigInt is not an input of the engine: the call throws, as it does after a trap.
  motions.at(2n, 0);
  await until(() => motions.lost);
  assert.equal(Worker.running.size, 0);
  motions.at(1, 0);
  await until(() => motions.branch !== null);
  assert.deepEqual([motions.lost, motions.current, Worker.running.size], [false, true, 1]);
  assert.deepEqual(motions.reached(1, 0), [[], null]);
});

test("a worker whose stack overflows is lost, ten in a row, and the next one answers", PATIENCE, async (t) => {
  const { motions, until } = begin();
  const broken = new WebAssembly.Module(withoutStack(readFileSync(WASM)));
  const { postMessage } = Worker.prototype;
  const small = t.mock.method(Worker.prototype, "postMessage", function (data) {
    postMessage.call(this, { ...data, ...(data.wasm && { wasm: { first: broken, second: null } }) });
  });
  for (let times = 0; times < 10; times++) {
    motions.of(times + 1, times % 2 ? rocker : class4);
    await until(() => motions.lost);
    assert.equal(Worker.running.size, 0);
  }
  small.mock.restore();
  motions.of(11, rocker);
  await until(() => motions.current);
  assert.deepEqual([motions.map.branches.length, motions.lost], [2, false]);
});

test("once nobody looks the worker is ended, and another one answers who looks again", PATIENCE, async () => {
  const { motions, until } = begin();
  motions.of(1, rocker);
  motions.close();
  assert.equal(Worker.running.size, 0);
  motions.of(1, rocker);
  await until(() => motions.current);
  motions.close();
  assert.deepEqual([motions.map, motions.current, Worker.running.size], [null, false, 0]);
  motions.close();
  motions.of(1, rocker);
  await until(() => motions.current);
  assert.equal(Worker.running.size, 1);
});
