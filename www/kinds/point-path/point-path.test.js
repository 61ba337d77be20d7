// Tests of paths: summary, drags and searches by the engine, sentences in every language, the file of linkages, the pen.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { closes, thinned } from "assur/kinds/point-path/pen.js";
import { another } from "assur/kinds/point-path/task.js";
import { FILTERS, csvOf, missedBy, saidOf, typeOf, verdictOf } from "assur/kinds/point-path/verdict.js";
import { NinePointSearch, NinePointWorker, PathSearch } from "assur/pkg/assur_web.js";
import { initialState } from "assur/state/state.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { LANGUAGES, wordsOf } from "assur/tests/words.js";

const engine = newEngine();
const ALL = LANGUAGES.map((lang) => wordsOf(lang));
const [english] = ALL;
const START = readFileSync(new URL("../../data/nine-points.bin", import.meta.url));

/**
 * @param {readonly (readonly number[])[]} points
 * @param {object} [more]
 */
function asked(points, more = {}) {
  const state = initialState("point-path", { path: points, ...more }, { playing: false });
  return { state, summary: engine.set(state) };
}

const USUAL = { squares: false, four_bars: true, slider_cranks: false, swinging: false };
const FIVE = [[0, 0], [1, 0.4], [1.6, 1.2], [1.2, 2.1], [0.2, 2.2]];

test("a path without a linkage is traced by one of a short search, which is in the summary", () => {
  const { summary } = asked(FIVE);
  const { traced, met, distances, cognates, geared, linkage, moves } = summary;
  assert.equal(moves, "angle");
  assert.equal(met.length, 5);
  assert.equal(distances.length, 5);
  assert.ok(traced.greatest >= Math.max(...distances) - 1e-12);
  assert.equal(cognates.length, 2);
  assert.equal(geared.length, 3);
  assert.equal(linkage.kind, "linkage");
  for (const input of met) assert.ok(engine.at(input).readouts);
});

test("cognates and geared five-bars trace the same curve", () => {
  const { summary } = asked(FIVE);
  for (const cognate of summary.cognates) {
    const other = asked(FIVE, { linkage: cognate }).summary;
    assert.ok(Math.abs(other.traced.greatest - summary.traced.greatest) < 1e-7, `${other.traced.greatest}, not ${summary.traced.greatest}`);
  }
  for (const { kind, document } of summary.geared) assert.equal(engine.set(initialState(kind, document, {})).moves, "angle");
});

test("a point is dragged, the linkage stays", () => {
  asked(FIVE);
  const { document } = engine.simulator.drag("point2", 0, 1.23456, 0.5);
  assert.deepEqual(document.path[1], [1.235, 0.5]);
  assert.deepEqual(document.path[0], [0, 0]);
  assert.equal("linkage" in document, false);
  assert.throws(() => engine.simulator.drag("point9", 0, 0, 0));
});

test("points in line and on a circle are traced exactly, and it is said in every language", () => {
  for (const points of [[[0, 0], [1, 1], [3, 3]], [[1, 0], [0, 1], [-1, 0], [0, -1]]]) {
    const { summary } = asked(points);
    assert.ok(summary.traced.greatest < 1e-9);
    assert.equal(missedBy(summary.traced, summary.size, english), "exact");
    const said = ALL.map((words) => saidOf({ summary, words }).join(" "));
    assert.equal(new Set(said).size, LANGUAGES.length);
  }
});

test("a search finds better linkages step by step, of the wanted kind", () => {
  for (const wishes of [USUAL, { ...USUAL, four_bars: false, slider_cranks: true }]) {
    const search = new PathSearch(stateOf(engine, "path-drawn"), wishes);
    let best = Infinity;
    for (let k = 0; k < 8; k++) {
      const { candidates, found } = search.step(1000);
      assert.equal(candidates, 1000 * (k + 1));
      if (!found) continue;
      assert.ok(found.length > 0 && found.every((one) => ("four_bar" in one.linkage) === wishes.four_bars));
      assert.ok(found[0].greatest <= best);
      best = found[0].greatest;
    }
    assert.ok(best < 0.3, `${best}`);
    search.free();
  }
});

test("what a search says of its linkages is what the page says of them, also of those without a link that turns fully", () => {
  const state = stateOf(engine, "path-drawn");
  for (const swinging of [false, true]) {
    const search = new PathSearch(state, { ...USUAL, swinging });
    for (const one of search.step(6000).found) {
      const { traced } = asked(state.document.path, { course: "closed", linkage: one.linkage }).summary;
      assert.ok(Math.abs(traced.greatest - one.greatest) < 3e-2 * one.greatest, `${traced.greatest}, not ${one.greatest}`);
      assert.equal(traced.verdict?.grashof, one.verdict?.grashof);
    }
    search.free();
  }
});

test("nine points: workers find all 1,442 curves, and each real four-bar passes through them", () => {
  const state = stateOf(engine, "path-nine");
  const search = new NinePointSearch(state);
  const workers = [1, 2].map(() => new NinePointWorker(new Uint8Array(START), state));
  for (let work = search.work(); work; work = search.work()) {
    const { paths } = work;
    const half = Math.ceil(paths.length / 2);
    for (const [k, worker] of workers.entries()) search.add(worker.track({ ...work, paths: paths.slice(k * half, (k + 1) * half) }));
  }
  assert.deepEqual(search.progress(), { curves: 1442, all: 1442, unproved: 0, left: 0, complete: true });
  const found = search.found();
  assert.equal(found.length, 63);
  assert.equal(new Set(found.map(({ curve }) => curve)).size, 21);
  assert.ok(found.filter(FILTERS.sound).every(FILTERS.works) && found.every(FILTERS.all));
  for (const { linkage, verdict } of found) {
    const { traced, distances, met, size } = asked(state.document.path, { linkage }).summary;
    assert.ok(Math.max(...distances) < 1e-7 * size, `${Math.max(...distances)}: ${verdictOf(traced, english)}`);
    assert.equal(traced.verdict?.passage, verdict?.passage);
    // A point of the other assembly is not reached.
    assert.equal(met.every((input) => input !== null), verdict?.passage === "continuous", verdictOf(traced, english));
  }
  assert.match(typeOf(found[0], english), /^four-bar, /);
  const lines = csvOf(found).trim().split("\n");
  assert.equal(lines.length, 64);
  assert.ok(lines.every((line) => line.split(",").length === 20));
});

test("points that are not nine, or leave a family, are refused with a sentence", () => {
  const code = (/** @type {readonly (readonly number[])[]} */ points) => {
    try {
      new NinePointSearch(initialState("point-path", { path: points }, {}));
      return "";
    } catch (thrown) {
      const [problem] = thrown.problems;
      for (const words of ALL) assert.doesNotMatch(words.text(`problem.${problem.code}`, problem), /problem\./);
      return problem.code;
    }
  };
  const on = (/** @type {(k: number) => readonly number[]} */ place) => Array.from({ length: 9 }, (_, k) => place(k));
  assert.equal(code(FIVE), "not_nine_points");
  assert.equal(code(on((k) => [k, 2 * k])), "points_in_line");
  assert.equal(code(on((k) => [Math.cos(k), Math.sin(k)])), "points_on_circle");
  assert.equal(code(on((k) => [k === 8 ? 0 : k, k === 8 ? 0 : k * k])), "coincident_points");
  assert.throws(() => new NinePointWorker(new Uint8Array(START).fill(0, 900, 910), stateOf(engine, "path-nine")));
});

test("a drawn line is thinned at equal distances, and closed if its ends are near", () => {
  const circle = Array.from({ length: 400 }, (_, k) => ({ x: 100 * Math.cos(k / 64), y: 100 * Math.sin(k / 64) }));
  const thin = thinned(circle, 50);
  assert.equal(thin.length, 50);
  assert.deepEqual([thin[0], thin[49]], [circle[0], circle[399]]);
  const sides = thin.slice(1).map(({ x, y }, k) => Math.hypot(x - thin[k].x, y - thin[k].y));
  assert.ok(Math.max(...sides) < 1.01 * Math.min(...sides), `${Math.min(...sides)} to ${Math.max(...sides)}`);
  assert.equal(closes(circle), true);
  assert.equal(closes(circle.slice(0, 200)), false);
  assert.equal(closes(circle.slice(0, 3)), false);
  assert.deepEqual(thinned(circle.slice(0, 20), 50), circle.slice(0, 20));
});

test("a linkage with a traced coupler point becomes a path of its own curve, with itself as the linkage", () => {
  let count = 0;
  for (const id of ["chebyshev", "hoeken", "evans", "jansen", "crank-rocker", "pantograph"]) {
    const state = stateOf(engine, id);
    const summary = engine.set(state);
    if (!summary.becomes.includes("point-path")) continue;
    try {
      const made = engine.simulator.asKind("point-path", summary.home);
      const { distances, size } = engine.set(initialState(made.kind, made.document, {}));
      assert.ok(Math.max(...distances) < 1e-8 * size, `${id}: ${Math.max(...distances)}`);
      count += 1;
    } catch (thrown) {
      if (!thrown.problems) throw thrown;
      assert.deepEqual(thrown.problems, [{ code: "no_coupler_point" }], id);
    }
  }
  assert.ok(count >= 2, `${count}`);
});

test("the curve of a cell of the atlas, taken as the path, is like itself, and its linkage is placed on it", () => {
  const page = { third: "frame", ratio: 3, point: [0.5, 0.5] };
  const { count, cells } = engine.functions.pathAtlas(asked(FIVE).state, page);
  assert.equal(cells.length, count * count);
  const index = cells.findIndex(({ grashof }) => grashof === "crank_rocker");
  const { curve } = cells[index];
  const points = Array.from({ length: curve.length / 2 }, (_, k) => [7 + 3 * curve[2 * k], 3 * curve[2 * k + 1]]).slice(0, -1);
  const { state } = asked(points, { course: "closed" });
  const again = engine.functions.pathAtlas(state, page).cells;
  assert.ok(again[index].unlikeness < 0.02, `${again[index].unlikeness}`);
  assert.ok(again.every(({ unlikeness, grashof }) => (grashof === null ? unlikeness === null : unlikeness >= 0 && unlikeness <= 1)));
  const { greatest } = engine.functions.pathOfCell(state, page, index);
  assert.ok(greatest < 0.02 * asked(points, { course: "closed" }).summary.size, `${greatest}`);
  assert.equal(engine.functions.pathOfCell(state, page, cells.findIndex(({ grashof }) => grashof === null)), null);
  assert.throws(() => engine.functions.pathAtlas(state, { ...page, ratio: -1 }));
});

test("two of the three lengths are on the axes of the atlas, and all cells have the third", () => {
  const { state } = asked(FIVE);
  const names = ["coupler", "rocker", "frame"];
  for (const third of names) {
    const { axes, range, count, cells } = engine.functions.pathAtlas(state, { third, ratio: 2.5, point: [0.5, 0.5] });
    assert.deepEqual(axes, names.filter((name) => name !== third));
    for (const [index, { lengths }] of cells.entries()) {
      assert.ok(Math.abs(lengths[names.indexOf(third)] - 2.5) < 1e-12);
      for (const [k, at] of [index % count, Math.floor(index / count)].entries()) {
        const wanted = range[0] * (range[1] / range[0]) ** (at / (count - 1));
        assert.ok(Math.abs(lengths[names.indexOf(axes[k])] - wanted) < 1e-12 * wanted, `${third} ${index}`);
      }
    }
  }
});

test("a new point continues the last two", () => {
  assert.deepEqual(another({ state: { document: { path: [[0, 0], [1, 0.5]] } } }), [2, 1]);
});
