import assert from "node:assert/strict";
import test from "node:test";
import { happen } from "assur/tests/window.js";

// Frames come when they are asked for, at a time that the test says.
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
  // A pause is no leap.
  frame(7);
  assert.equal(steps.at(-1), 0.1);
  moving = false;
  frame(0.016);
  assert.equal(due, null);
  // After a rest time begins anew.
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
 * A pace whose writing takes so many milliseconds.
 * @param {import("node:test").TestContext} t
 */
function begin(t) {
  let [clock, writes] = [1e6, 0];
  t.mock.timers.enable({ apis: ["setTimeout"] });
  t.mock.method(performance, "now", () => clock);
  const pace = new Pace();
  const keep = (revision, took = 0) => pace.run(revision, () => {
    clock += took;
    writes += 1;
  });
  return { keep, rest: (ms) => (clock += ms), written: () => writes, end: () => t.mock.timers.tick(1) };
}

test("what is brief is written at once, also under a pressed pointer", (t) => {
  const { keep, written } = begin(t);
  happen("pointerdown");
  for (let revision = 1; revision < 6; revision++) assert.equal(keep(revision, 2), true);
  assert.equal(written(), 5);
  happen("pointerup");
});

test("what takes long rests twelve times as long while a pointer drags, and is written when the frame is over", (t) => {
  const { keep, rest, written, end } = begin(t);
  happen("pointerdown");
  keep(1, 10);
  assert.equal(keep(2, 10), false);
  rest(119);
  assert.equal(keep(2, 10), false);
  rest(1);
  assert.equal(keep(2, 10), true);
  // Only the newest is written.
  assert.equal(keep(3, 10), true);
  assert.equal(written(), 1);
  end();
  assert.equal(written(), 2);
  // The same mechanism is written at once, and so is another once the pointer is up.
  assert.equal(keep(3, 10), true);
  happen("pointerup");
  assert.equal(keep(4, 10), true);
  assert.equal(written(), 4);
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
