// Tests of edits of a drawing: random edits with undo, redo and addresses, and the selection.
import assert from "node:assert/strict";
import test from "node:test";
import "assur/tests/canvas.js";
import { readDisplayList } from "assur/canvas/display-list.js";
import { edit, refuse, step, unsay } from "assur/drawing/edit.js";
import { Selection } from "assur/drawing/selection.js";
import { fromAddress, toAddress } from "assur/state/codec.js";
import { withView } from "assur/state/state.js";
import { often } from "assur/tests/random.js";
import { Page } from "assur/tests/page.js";

/** A page with an empty sheet. */
function begin() {
  const page = new Page("mixer-a");
  const { kind, document } = page.engine.functions.blank();
  page.choose(kind, document);
  return page;
}

/** A four-bar on two points of the frame, driven by its first bar. */
function fourBar(page) {
  const [a, d] = [[0, 0], [4, 0]].map((at) => step(page, { edit: "point", at, fixed: true }).point);
  const { point: b, link } = step(page, { edit: "bar", ends: [{ point: a }, { at: [0, 1] }] });
  const { point: c } = step(page, { edit: "bar", ends: [{ point: b }, { at: [3, 3] }] });
  step(page, { edit: "bar", ends: [{ point: c }, { point: d }] });
  return { points: [a, b, c, d], crank: link };
}

/**
 * @param {import("assur/tests/random.js").Dice} dice
 * @param {Page} page
 * @returns {object} a random edit of the drawing
 */
function chance(dice, page) {
  const { document: { points, links, frame } } = page.store.get();
  const at = () => [dice.below(2000) / 100 - 10, dice.below(2000) / 100 - 10];
  const point = () => dice.one(points).name;
  const link = () => (dice.below(8) ? dice.one(links).name : "0");
  const end = () => dice.one([{ at: at() }, ...(points.length > 0 ? [{ point: point() }, { point: point() }] : []), ...(links.length > 0 ? [{ on: [link(), at()] }] : [])]);
  const anywhere = [
    () => ({ edit: "point", at: at(), fixed: dice.below(2) === 0 }), () => ({ edit: "bar", ends: [end(), end()] }), () => ({ edit: "bar", ends: [end(), end()] }),
    () => ({ edit: "wheel", end: end() }), () => ({ edit: "triad", ends: [end(), end(), end()] }), () => ({ edit: "dyad", outer: [{ hinge: end() }, { hinge: end() }], inner: dice.one(["hinge", "slide"]) }),
    () => ({ edit: "block", end: end(), along: { toward: at() } }),
  ];
  const ofPoints = [
    () => ({ edit: "fix", point: point() }), () => ({ edit: "move", points: [point(), point()], by: at() }), () => ({ edit: "place", point: point(), at: at() }), () => ({ edit: "join", points: [point(), point()] }),
    () => ({ edit: "part", point: point() }), () => ({ edit: "rename", name: point(), to: dice.one(["A", "Q", "Ж1", "x", "a b"]) }), () => ({ edit: "mirror", points: [point(), point()] }), () => ({ edit: "lock", points: [point(), point()] }),
  ];
  const ofLinks = [
    () => ({ edit: "drive", link: link() }), () => ({ edit: "stretch", link: link(), length: dice.between(0.1, 9) }), () => ({ edit: "turn", link: link(), angle_deg: dice.below(360) }), () => ({ edit: "corner", link: link(), end: end() }),
    () => ({ edit: "trace", link: link(), at: at() }), () => ({ edit: "mass", link: link(), at: at() }), () => ({ edit: "weld", links: [link(), link()] }), () => ({ edit: "mesh", links: [link(), link()], teeth: [20, 30], internal: false }),
    () => ({ edit: "rename", name: link(), to: dice.one(["arm", "M", "Ж"]) }),
  ];
  const removing = () => ({ edit: "remove", points: [point()], links: links.length > 0 && dice.below(2) ? [dice.one(links).name] : [] });
  if (points.length > 14) return removing();
  const all = [...anywhere, ...(points.length > 0 ? [...ofPoints, removing] : []), ...(links.length > 0 ? ofLinks : [])];
  assert.ok(frame);
  return dice.one(all)();
}

test("symbols keep their size while a drawing grows and begins to move", () => {
  const page = begin();
  const hinge = () => {
    const { scene, frame } = page.now();
    const poses = 1 + 3 * frame[0];
    const read = (list, from) => readDisplayList(list, from, page.engine.roles, page.engine.labels, () => new Path2D());
    const records = [...read(scene, 0), ...read(frame, poses)].flatMap(({ shapes }) => shapes).map(({ record }) => record);
    return Math.max(...records.filter(([kind, role]) => kind === 3 && page.engine.roles[role] === "ink").map((record) => record[5]));
  };
  assert.equal(page.model.scaleSymbols(0.05), true);
  assert.equal(page.model.scaleSymbols(0.05), false);
  const { crank } = fourBar(page);
  const near = hinge();
  step(page, { edit: "bar", ends: [{ at: [40, 30] }, { at: [45, 30] }] });
  assert.equal(hinge(), near);
  step(page, { edit: "remove", points: ["E", "F"], links: [] });
  step(page, { edit: "drive", link: crank });
  assert.equal(page.store.get().kind, "linkage");
  assert.equal(hinge(), near);
  page.model.scaleSymbols(0);
  assert.notEqual(hinge(), near);
});

test("edits by chance: each is taken or refused with a reason, undone, redone, and read again from its address", () => {
  let [taken, refused] = [0, 0];
  const kinds = new Set();
  often(4, (dice, run) => {
    const page = begin();
    if (run % 2 === 0) step(page, { edit: "drive", link: fourBar(page).crank });
    // The input belongs to no undo step.
    const shown = () => JSON.stringify([page.store.get().kind, page.store.get().document]);
    kinds.add(page.store.get().kind);
    const states = [shown()];
    for (let i = 0; i < 40; i++) {
      const before = page.store.get().document;
      const drawn = step(page, chance(dice, page));
      const { problems, stale } = page.now();
      if (!drawn) {
        refused += 1;
        assert.equal(page.store.get().document, before);
        assert.ok(page.drafts.has("edit") && problems.length > 0);
        continue;
      }
      kinds.add(page.store.get().kind);
      assert.equal(stale, false, JSON.stringify(problems));
      if (page.store.get().document === before) continue;
      taken += 1;
      states.push(shown());
      const state = page.store.get();
      const read = page.engine.functions.readState(fromAddress(toAddress(state, null), () => undefined));
      assert.deepEqual([read.kind, read.document], [state.kind, state.document]);
    }
    for (const one of states.slice(0, -1).reverse()) {
      page.history.undo();
      assert.equal(shown(), one);
      assert.equal(page.now().stale, false);
    }
    for (const one of states.slice(1)) {
      page.history.redo();
      assert.equal(shown(), one);
    }
    assert.deepEqual([page.history.canRedo, page.engine.trapped], [false, false]);
  });
  assert.ok(taken > 50 && refused > 10 && kinds.size === 2, `${taken} ${refused} ${[...kinds]}`);
});

test("a drawing becomes a linkage when it moves, and a drawing again when it does not", () => {
  const page = begin();
  step(page, { edit: "bar", ends: [{ at: [7, 7] }, { at: [8, 8] }] });
  const [loose] = page.store.get().document.links;
  const { crank } = fourBar(page);
  step(page, { edit: "drive", link: crank });
  assert.equal(page.store.get().kind, "draft");
  // Without the loose bar, the drawing moves.
  step(page, { edit: "remove", points: loose.points, links: [loose.name] });
  assert.equal(page.store.get().kind, "linkage");
  const { summary, problems } = page.now();
  assert.deepEqual([summary.moves, problems], ["angle", []]);
  // The input is that of the drawn pose.
  assert.ok(Math.abs(page.store.get().view.phi_deg - 90) < 1e-9);
  step(page, { edit: "remove", points: [], links: [crank] });
  assert.equal(page.store.get().kind, "draft");
  page.history.undo();
  assert.equal(page.store.get().kind, "linkage");
});

test("what was plotted of a point goes with it", () => {
  const page = begin();
  const { crank, points } = fourBar(page);
  step(page, { edit: "drive", link: crank });
  page.store.update((state) => withView(state, { plot: points[2] }));
  assert.equal(page.now().stale, false);
  step(page, { edit: "rename", name: points[2], to: "Q" });
  const { state, stale } = page.now();
  assert.deepEqual([state.view.plot, stale], ["angles", false]);
});

test("what is refused is said until the next edit", () => {
  const page = begin();
  assert.equal(edit(page, { edit: "fix", point: "nobody" }), null);
  assert.ok(page.drafts.has("edit"));
  step(page, { edit: "point", at: [0, 0], fixed: true });
  assert.equal(page.drafts.has("edit"), false);
  refuse(page, "held_by_locks");
  assert.deepEqual(page.now().problems, [{ code: "held_by_locks" }]);
  unsay(page);
  assert.deepEqual(page.now().problems, []);
});

test("points and links are selected, added to what is selected, and taken out of it again", () => {
  const selection = new Selection();
  const of = () => [[...selection.points], [...selection.links]];
  assert.ok(selection.empty);
  selection.choose("A", null, false);
  selection.choose("B", "AB", true);
  assert.deepEqual(of(), [["A", "B"], []]);
  selection.choose(null, "AB", true);
  selection.choose("A", null, true);
  assert.deepEqual(of(), [["B"], ["AB"]]);
  selection.choose("C", null, false);
  assert.deepEqual(of(), [["C"], []]);
  selection.choose(null, null, false);
  assert.ok(selection.empty);
});

test("of what is gone nothing stays selected; with a link all its points are", () => {
  const selection = new Selection();
  selection.set(["A", "Z", "T"], ["BC", "gone"]);
  const parts = { points: [{ name: "A" }, { name: "B" }, { name: "C" }], links: [{ name: "BC", points: ["B", "C"] }], tracers: [{ name: "T", link: "BC" }] };
  selection.keep(parts);
  assert.deepEqual([[...selection.points], [...selection.links]], [["A", "T"], ["BC"]]);
  assert.deepEqual(selection.all(parts).sort(), ["A", "B", "C", "T"]);
});

test("a malformed edit names its fault", () => {
  const { engine } = begin();
  for (const [wanted, path] of [[null, "edit"], [{ edit: 5 }, "edit"], [{ edit: "nonsense" }, "edit"], [{ edit: "fix" }, "."], [{ edit: "fix", point: 5 }, "point"], [{ edit: "bar", ends: [{ at: [0, "x"] }, { at: [1, 1] }] }, "ends[0].at[1]"]]) {
    assert.throws(() => engine.simulator.edit(wanted, 0), ({ problems: [{ code, path: at }] }) => code === "bad_state" && at === path, path);
  }
});
