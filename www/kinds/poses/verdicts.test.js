// Tests of poses of a body: summary and drags by the engine, sentences on special poses in every language, the file of pairs.
import assert from "node:assert/strict";
import test from "node:test";
import { another } from "assur/kinds/poses/task.js";
import { FILTERS, csvOf, saidOf, typeOf, verdictOf } from "assur/kinds/poses/verdicts.js";
import { initialState } from "assur/state/state.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { LANGUAGES, wordsOf } from "assur/tests/words.js";

const engine = newEngine();
const ALL = LANGUAGES.map((lang) => wordsOf(lang));
const [english] = ALL;

/**
 * @param {readonly (readonly number[])[]} poses x, y and angle of each
 * @param {object} [more]
 */
function asked(poses, more = {}) {
  const document = { poses: poses.map(([x, y, angle]) => ({ x, y, angle_deg: angle })), ...more };
  const state = initialState("poses", document, { playing: false });
  return { state, summary: engine.set(state) };
}

const THREE = [[0, 0, 0], [1.4, 1.6, 40], [1.5, 3.4, 90]];

test("five poses of a crank-rocker: all its pairs are listed, the best meets every pose", () => {
  const state = stateOf(engine, "poses-five");
  const summary = engine.set(state);
  const { dyads, pairs, ranking, number, met, complete, moves } = summary;
  assert.equal(moves, "angle");
  assert.equal(complete, true);
  assert.ok(dyads.length === 2 || dyads.length === 4, String(dyads.length));
  assert.equal(pairs.length, (dyads.length * (dyads.length - 1)) / 2);
  assert.equal(number, ranking[0]);
  assert.equal(met.length, 5);
  assert.ok(met.every((input) => input !== null), String(met));
  const shown = pairs[number - 1];
  assert.equal(shown.sound, true);
  assert.match(typeOf(shown.verdict, english), /^four-bar, crank-rocker$/);
  assert.match(verdictOf(shown, english), /^all poses in one motion; in order/);
  for (const input of met) assert.ok(engine.at(input).readouts);
  assert.ok(pairs.filter(FILTERS.sound).every(FILTERS.works) && pairs.every(FILTERS.all));
});

test("a pose is dragged and turned; a hinge of three poses is dragged", () => {
  asked(THREE);
  const moved = engine.simulator.drag("pose2", 0, 1.23456, 2);
  assert.deepEqual(moved.document.poses[1], { x: 1.235, y: 2, angle_deg: 40 });
  const turned = engine.simulator.drag("turn3", 0, 0.5, 3.4);
  assert.deepEqual(turned.document.poses[2], { x: 1.5, y: 3.4, angle_deg: 180 });
  const { document } = engine.simulator.drag("frame1", 0, -1, 1.5);
  assert.deepEqual(document.hinges[0], { frame: [-1, 1.5] });
  assert.equal(document.hinges.length, 2);
  const { summary } = asked(THREE, document);
  assert.ok(summary.dyads.some(({ centre }) => centre && Math.hypot(centre[0] + 1, centre[1] - 1.5) < 1e-12));
  assert.throws(() => engine.simulator.drag("pose9", 0, 0, 0));
});

test("four poses: a dragged hinge stays on its curve, and a press on the curve chooses its point", () => {
  const four = [...THREE, [0.6, 4.6, 130]];
  const { summary } = asked(four);
  assert.ok(summary.pairs.length > 10);
  const hinges = engine.simulator.drag("frame1", 0, 0, 1).document.hinges;
  const chosen = asked(four, { hinges });
  assert.equal(chosen.summary.number, chosen.summary.pairs.length);
  for (const k of chosen.summary.pairs[chosen.summary.number - 1].dyads) {
    assert.ok(chosen.summary.dyads[k - 1].residual < 1e-9);
  }
  // The hinge itself is on the curve; far away there is none.
  const [x, y] = hinges[0].frame;
  assert.equal(engine.simulator.drag("curve", 0, x, y).document.hinges.length, 2);
  assert.deepEqual(engine.simulator.drag("curve", 0, 1e6, 1e6), {});
});

test("special poses have a sentence in every language, and stay drawn", () => {
  const turn = (/** @type {number} */ angle) => [2 * Math.cos((angle * Math.PI) / 180), 2 * Math.sin((angle * Math.PI) / 180), angle];
  for (const [poses, code] of /** @type {[number[][], string][]} */ ([
    [[[1, 1, 5], [1, 1, 5], [1, 1, 365]], "still"],
    [[0, 30, 75, 200].map(turn), "rotation"],
    [[[0, 0, 20], [3, 4, 20], [-6, -8, 20]], "line"],
    [[[0, 0, 7], [6, 0, 7], [8, 4, 7], [3, 9, 7]], "parallelogram"],
    [[[0, 0, 7], [6, 0, 7], [8, 4, 7], [3, 5, 7], [1, 1, 7]], "parallel"],
  ])) {
    const { state, summary } = asked(poses);
    assert.equal(summary.special.code, code);
    assert.equal(summary.handles.filter(({ name }) => /^(pose|turn)/.test(name)).length, 2 * poses.length);
    assert.ok(engine.at(0).frame.length > 20 * poses.length);
    for (const words of ALL) {
      const said = saidOf({ state, summary, words }).join(" ");
      assert.doesNotMatch(said, /[{}]|(poses|problem)\.\w/, said);
      assert.ok(said.length > 30);
    }
  }
});

test("five poses without two real pairs are drawn alone", () => {
  const random = (/** @type {number} */ seed) => ((Math.sin(seed) * 43758.5453) % 1 + 1) % 1;
  let alone = 0;
  for (let seed = 1; seed < 60; seed++) {
    const poses = [0, 1, 2, 3, 4].map((k) => [0, 1, 2].map((axis) => (axis === 2 ? 360 : 10) * random(17 * seed + 3 * k + axis)));
    const { state, summary } = asked(poses);
    assert.ok([0, 2, 4].includes(summary.dyads.length), String(summary.dyads.length));
    if (summary.dyads.length > 0) continue;
    alone += 1;
    assert.equal(summary.moves, null);
    assert.equal(summary.handles.length, 10);
    assert.match(saidOf({ state, summary, words: english }).join(" "), /0 of 4 pairs/);
  }
  assert.ok(alone > 0);
});

test("the file has a line for each pair, a new pose goes on from the last", () => {
  const state = stateOf(engine, "poses-five");
  const summary = engine.set(state);
  const lines = csvOf(summary, summary.ranking).trim().split("\n");
  assert.equal(lines.length, 1 + summary.pairs.length);
  assert.ok(lines.every((line) => line.split(",").length === lines[0].split(",").length), lines.join("\n"));
  assert.deepEqual(another({ state: asked(THREE).state }), { x: 1.6, y: 5.2, angle_deg: 140 });
  assert.deepEqual(another({ state: asked([[1, 1, 5], [1, 1, 5]]).state }), { x: 1, y: 1, angle_deg: 25 });
});
