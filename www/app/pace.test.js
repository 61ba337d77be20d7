import assert from "node:assert/strict";
import test from "node:test";
import { happen } from "assur/tests/window.js";

// The test calls the requested frame, at a time that it sets.
let now = 0;
let due = null;
globalThis.document = Object.assign(new EventTarget(), { hidden: false });
globalThis.requestAnimationFrame = (work) => ((due = work), 1);
globalThis.cancelAnimationFrame = () => (due = null);
const { Loop } = await import("assur/app/loop.js");
const { Pace } = await import("assur/app/pace.js");

/** @param {number} seconds since the last frame */
function frame(seconds) {
  now += 1000 * seconds;
  const work = due;
  due = null;
  work(now);
}

test("frames follow as long as there is motion, and time is that between two of them", () => {
  const steps = [];
  let [drawn, moving] = [0, true];
  const loop = new Loop((dt) => (steps.push(dt), moving), () => (drawn += 1));
  loop.request();
  for (const seconds of [1, 0.016, 0.02]) frame(seconds);
  assert.deepEqual([steps.map((dt) => Math.round(dt * 1e3)), drawn], [[0, 16, 20], 3]);
  // After a long pause, the step has its greatest length.
  frame(7);
  assert.equal(steps.at(-1), 0.1);
  moving = false;
  frame(0.016);
  assert.equal(due, null);
  // After a rest, the first step has no length.
  moving = true;
  loop.request();
  frame(5);
  assert.equal(steps.at(-1), 0);
});

test("several requests are one frame", () => {
  let drawn = 0;
  const loop = new Loop(() => false, () => (drawn += 1));
  loop.request();
  const first = due;
  loop.request();
  assert.equal(due, first);
  frame(0.1);
  assert.deepEqual([drawn, due], [1, null]);
});

test("a page that nobody sees asks for no frames, and goes on without a leap", () => {
  const steps = [];
  const loop = new Loop((dt) => (steps.push(dt), true), () => {});
  loop.request();
  frame(0.016);
  document.hidden = true;
  document.dispatchEvent(new Event("visibilitychange"));
  assert.equal(due, null);
  loop.request();
  assert.equal(due, null);
  document.hidden = false;
  document.dispatchEvent(new Event("visibilitychange"));
  frame(60);
  assert.equal(steps.at(-1), 0);
});

/**
 * A pace with a period of 50 ms, and a clock.
 * @param {import("node:test").TestContext} t
 */
function begin(t) {
  let [clock, writes] = [1e6, 0];
  t.mock.method(performance, "now", () => clock);
  const pace = new Pace(50);
  const keep = (revision, took = 0) => pace.run(revision, () => {
    clock += took;
    writes += 1;
  });
  return { keep, rest: (ms) => (clock += ms), written: () => writes };
}

test("without a pointer or a key that is held down, all is written at once", (t) => {
  const { keep, written } = begin(t);
  for (let revision = 1; revision < 6; revision++) assert.equal(keep(revision, 20), true);
  happen("keydown", { repeat: false });
  assert.equal(keep(6), true);
  happen("keyup");
  assert.equal(written(), 6);
});

for (const [down, up, detail] of [["pointerdown", "pointerup", {}], ["keydown", "keyup", { repeat: true }]]) {
  test(`during ${down} a change waits for the end of the period`, (t) => {
    const { keep, rest, written } = begin(t);
    happen(down, detail);
    assert.equal(keep(1), true);
    assert.equal(keep(2), false);
    rest(49);
    assert.equal(keep(3), false);
    rest(1);
    assert.equal(keep(3), true);
    // The same mechanism, at another input, is written at once.
    assert.equal(keep(3), true);
    assert.equal(keep(4), false);
    happen(up);
    assert.equal(keep(4), true);
    assert.equal(written(), 4);
  });
}

test("what takes long rests twelve times as long", (t) => {
  const { keep, rest, written } = begin(t);
  happen("pointerdown");
  keep(1, 10);
  rest(119);
  assert.equal(keep(2, 10), false);
  rest(1);
  assert.equal(keep(2, 10), true);
  assert.equal(written(), 2);
  happen("pointerup");
});

test("a release that goes elsewhere is one", (t) => {
  const { keep, rest, written } = begin(t);
  for (const end of ["pointerup", "pointercancel", "contextmenu", "blur"]) {
    keep(end, 10);
    happen("pointerdown");
    assert.equal(keep(`${end} after`, 10), false, end);
    happen(end);
    assert.equal(keep(`${end} after`, 10), true, end);
    rest(1000);
  }
  assert.equal(written(), 8);
});
