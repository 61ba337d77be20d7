import assert from "node:assert/strict";
import test from "node:test";
import { Coordinate, VIEW_KEYS } from "assur/state/coordinate.js";
import { initialState } from "assur/state/state.js";
import { often } from "assur/tests/random.js";
import { wordsOf } from "assur/tests/words.js";

const TURN = 2 * Math.PI;
const [en, ru] = ["en", "ru"].map((lang) => wordsOf(lang));
const full = (start, end) => ({ start, end, full: true, arcs: [[start, end]] });
const crank = new Coordinate("angle", full(0, TURN), "1");
const slide = new Coordinate("length", { start: -2, end: 3, full: false, arcs: [[-2, 3]] }, "4");
const endless = new Coordinate("time", full(0, 10));
const run = new Coordinate("time", { start: 0, end: 10, full: false, arcs: [[0, 10]] });
const state = initialState("linkage", { points: [] }, { phi_deg: 400, s: 1.5, t: 37 });
const near = (found, expected) => assert.ok(Math.abs(found - expected) <= 1e-9 * Math.max(1, Math.abs(expected)), `${found} ${expected}`);

test("each input has its field, its symbol and those of its rates", () => {
  assert.deepEqual(VIEW_KEYS, ["phi_deg", "s", "t"]);
  assert.deepEqual([crank, slide, run].map(({ viewKey }) => viewKey), VIEW_KEYS);
  assert.deepEqual([crank, slide, run, new Coordinate("angle", full(0, TURN), "12")].map(({ symbol }) => symbol), ["φ₁", "s", "t", "φ₁₂"]);
  assert.deepEqual(crank.rates, ["ω₁", "ε₁"]);
});

test("an angle is brought onto its axis by whole periods, and both ends stay", () => {
  often(1000, (dice) => {
    const [start, turns] = [dice.between(-10, 10), 1 + dice.below(3)];
    const coordinate = new Coordinate("angle", full(start, start + turns * TURN));
    const { start: from, end: to } = coordinate.axis(0);
    const inputShown = dice.between(-3000, 3000);
    const found = coordinate.onto(inputShown);
    assert.ok(found >= from - 1e-9 && found <= to + 1e-9, `${found} ${from} ${to}`);
    const periods = (inputShown - found) / (to - from);
    assert.ok(Math.abs(periods - Math.round(periods)) < 1e-9, String(periods));
    assert.equal(coordinate.onto(found), found);
    for (const end of [from, to]) assert.equal(coordinate.onto(end), end);
  });
  assert.equal(crank.of(state), 40);
  assert.equal(crank.onto(-1), 359);
  assert.equal(crank.onto(360), 360);
});

test("a slide and the time of a run stop at their ends", () => {
  for (const [coordinate, wanted, reached] of [[slide, 9, 3], [slide, -9, -2], [slide, 1, 1], [run, 11, 10], [run, -1, 0], [endless, -1, 0], [endless, 1e9, 1e6]]) {
    assert.equal(coordinate.put(state, wanted).view[coordinate.viewKey], reached);
  }
  assert.equal(crank.put(state, 361.5).view.phi_deg, 1.5);
  assert.equal(crank.put(state, 360).view.phi_deg, 360);
});

test("time that goes on has one span after the other", () => {
  assert.deepEqual(endless.axis(37), { start: 30, end: 40 });
  assert.deepEqual(endless.axis(0), { start: 0, end: 10 });
  assert.deepEqual(run.axis(37), { start: 0, end: 10 });
  // The end of a span is the start of the next one, so the last input of a span lies just before its end.
  const last = endless.last(37);
  assert.ok(last < 40 && last > 39.999);
  assert.deepEqual(endless.axis(last), { start: 30, end: 40 });
  assert.equal(run.last(37), 10);
  assert.equal(crank.last(7), 360);
});

test("readers have degrees, the engine radians; a length and a time are the same for both", () => {
  often(300, (dice) => {
    const inputShown = dice.between(-720, 720);
    near(crank.inputShown(crank.input(inputShown)), inputShown);
    near(crank.input(inputShown), (inputShown / 180) * Math.PI);
    assert.equal(slide.input(inputShown), inputShown);
    assert.equal(run.inputShown(inputShown), inputShown);
  });
});

test("a driver goes by speed, or with ω₁ alone; ε₁ does not hasten it", () => {
  const view = { true_time: false, omega: 7, epsilon: 3, speed: 2 };
  near(crank.pace(view), (2 * TURN) / 6);
  near(slide.pace(view), (2 * 2 * 5) / 6);
  assert.equal(run.pace(view), 2);
  assert.deepEqual([crank, slide, run].map((one) => one.pace({ ...view, true_time: true })), [7, 7, 2]);
});

test("a small step is a degree, or a power of ten of a slide's way", () => {
  assert.equal(crank.step, 1);
  for (const [way, step] of [[5, 0.1], [1, 0.01], [1000, 10], [0.002, 0.00001]]) {
    near(new Coordinate("length", { start: 0, end: way, full: false, arcs: [] }).step, step);
  }
});

test("an input is written in its unit and with the decimals of its size", () => {
  assert.equal(crank.text(Math.PI, en, 1), "180.0°");
  assert.equal(crank.written(12.345, ru, 2), "12,35°".replace("35", String(ru.numbers.fixed(12.345, 2)).slice(-2)));
  assert.equal(crank.short(Math.PI / 2, en, 1), "90°");
  assert.equal(crank.exact(12.5, ru), "12,5°");
  assert.equal(run.text(2, en, 1), `2.0\u00a0${en.text("unit.s")}`);
  assert.equal(slide.text(1.5, en.measured("mm"), 1), "1.5\u00a0mm");
  const short = new Coordinate("length", { start: 0, end: 0.05, full: false, arcs: [] });
  assert.equal(short.text(0.0123, en, 1), "0.012");
  assert.equal(slide.exact(0.1, en.measured("mm")), "0.1");
});

test("a share of a motion is a part of a turn or of a way", () => {
  assert.deepEqual([72, 360, 3600].map((count) => crank.share(count, en)), ["5°", "1°", "0.1°"]);
  assert.equal(slide.share(100, en.measured("m")), "0.05\u00a0m");
});

test("inputs are near where nobody sees a difference, over the turn of a crank", () => {
  for (const [one, other, expected] of [[0, TURN, true], [0, 0.008, true], [0, 0.01, false], [TURN - 0.004, 0.004, true], [0, Math.PI, false]]) assert.equal(crank.near(one, other), expected, `${one} ${other}`);
  assert.deepEqual([slide.near(0, 0.02), slide.near(0, 0.03)], [true, false]);
});
