import assert from "node:assert/strict";
import test from "node:test";
import { change, inputNow, take } from "assur/state/change.js";
import { Drafts, INPUT } from "assur/state/drafts.js";
import { Model } from "assur/state/model.js";
import { Player, stoppedAt, turned } from "assur/state/player.js";
import { Store } from "assur/state/store.js";
import { withDocument, withExtras, withMechanism, withView } from "assur/state/state.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { often } from "assur/tests/random.js";
import { wordsOf } from "assur/tests/words.js";

const words = wordsOf("en");

/** @param {string} id of a mechanism of the catalogue */
function begin(id, view = {}) {
  const engine = newEngine();
  const drafts = new Drafts(() => {});
  const store = new Store(stateOf(engine, id, { phi_deg: 75, ...view }));
  const model = new Model(engine, drafts, store.get());
  const now = () => {
    model.follow(store.get());
    return model.snapshot(store.get(), words, true);
  };
  const update = (change) => {
    store.update(change);
    return now();
  };
  return { engine, drafts, store, model, now, update };
}

test("a length that cannot be assembled leaves the last good drawing, with a message of its name and excess", () => {
  const { now, update, model } = begin("mixer-a");
  const last = now();
  const bad = update((state) => withDocument(state, { l4: 2 }));
  assert.deepEqual([bad.stale, bad.faded, model.accepted], [true, true, false]);
  assert.ok(bad.problems.length === 1 && Math.abs(bad.problems[0].by - 0.23) < 1e-9, JSON.stringify(bad.problems));
  for (const part of ["summary", "scene", "revision", "kind"]) assert.equal(bad[part], last[part], part);
  for (const part of ["frame", "readouts"]) assert.deepEqual(bad[part], last[part], part);
  assert.equal(model.lastAccepted.document.l4, 0.85);
  const back = update((state) => withDocument(state, { l4: 0.85 }));
  assert.deepEqual([back.stale, back.faded, back.problems], [false, false, []]);
  assert.deepEqual(back.frame, last.frame);
});

test("every bad number of a mixer is a problem of its field, and good ones recover", () => {
  const { now, update } = begin("mixer-a");
  const frame = [...now().frame];
  for (const [field, back, bad] of [
    ["l1", 0.37, [0, -0.37, 1e300]], ["l3", 0.55, [1e-300, -1]], ["z4", 36, [0, -3, 1.5, 1e9]], ["module", 0.0165, [0, -1]],
    ["wheels", [{ z: 18, centre_line_deg: -40 }], [[{ z: 0, centre_line_deg: 0 }], [{ z: 1.5, centre_line_deg: 0 }], [{ z: 2, centre_line_deg: 0 }], []]],
  ]) {
    for (const value of bad) {
      const { problems, stale } = update((state) => withDocument(state, { [field]: value }));
      assert.ok(stale && problems.length > 0, `${field} ${JSON.stringify(value)}`);
    }
    const { problems } = update((state) => withDocument(state, { [field]: back }));
    assert.deepEqual(problems, [], field);
    assert.deepEqual([...now().frame], frame, field);
  }
});

test("an angle without a pose leaves the last drawing, with the angle in the problem, and plots stay", () => {
  const { now, update, model } = begin("mixer-a", { phi_deg: 10 });
  for (const lengths of [{ l1: 0.8 }, { l2: 0.4 }]) update((state) => withDocument(state, lengths));
  const last = now();
  assert.deepEqual(last.problems, []);
  const bad = update((state) => withView(state, { phi_deg: 170 }));
  assert.deepEqual([bad.stale, bad.faded, model.hasPose], [false, true, false]);
  assert.ok(bad.problems.some(({ phi }) => Math.abs(phi - (170 / 180) * Math.PI) < 1e-9), JSON.stringify(bad.problems));
  assert.equal(bad.frame, last.frame);
  assert.equal(bad.frameInput, last.frameInput);
  assert.equal(bad.readouts, null);
  assert.deepEqual(update((state) => withView(state, { phi_deg: 10 })).problems, []);
});

test("what is typed and not taken stands before what the state has", () => {
  const { drafts, now, update } = begin("mixer-a");
  drafts.keep("l2");
  const typed = now();
  assert.deepEqual([typed.problems, typed.stale], [[{ code: "not_a_number", field: "l2" }], true]);
  drafts.drop("l2");
  drafts.keep(INPUT);
  assert.deepEqual([now().problems.length, now().stale], [1, false]);
  drafts.drop(INPUT);
  update((state) => withDocument(state, { l4: 9 }));
  assert.ok(now().problems.length >= 1);
});

test("only what a change makes necessary is asked of the engine", (t) => {
  const { engine, update } = begin("jansen");
  const [set, at] = ["set", "at"].map((name) => t.mock.method(engine, name));
  const asked = () => [set.mock.callCount(), at.mock.callCount()];
  update((state) => withView(state, { speed: 2, lang: "ru", projector: true }));
  assert.deepEqual(asked(), [0, 0]);
  update((state) => withView(state, { phi_deg: 76 }));
  assert.deepEqual(asked(), [0, 1]);
  update((state) => withView(state, { groups: true }));
  assert.deepEqual(asked(), [1, 2]);
});

test("a mechanism of another kind has another count of its input, and an input of its own", () => {
  const { engine, update, now } = begin("mixer-a");
  const before = now().revision;
  const { kind, document } = engine.catalogue.preset("train-gears");
  const shown = update((state) => withMechanism(state, kind, document));
  assert.deepEqual([shown.kind, shown.coordinate.moves, shown.inputShown, shown.revision], ["gear-train", "time", 0, before + 1]);
});

test("all mechanisms of the catalogue have drawings, read-outs and handles at every input they reach", () => {
  const { engine, store, update } = begin("mixer-a");
  for (const { id, kind, document } of engine.catalogue.presets) {
    store.put(stateOf(engine, id));
    const { summary, coordinate } = update((state) => withMechanism(state, kind, document));
    if (summary.moves === null) continue;
    const { arcs, start, end } = summary.cycle;
    for (const [from, to] of arcs.length > 0 ? arcs : [[start, end]]) {
      for (let k = 1; k < 8; k++) {
        const here = update((state) => coordinate.put(state, coordinate.inputShown(from + ((to - from) * k) / 8)));
        assert.deepEqual(here.problems.filter(({ code }) => code !== "change_point"), [], `${id} ${k}`);
        for (const list of [here.frame, here.handles, here.readouts?.values ?? []]) assert.ok([...list].every(Number.isFinite), `${id} ${k}`);
        assert.equal(here.handles.length, 2 * summary.handles.length, id);
        assert.ok(here.readouts !== null, `${id} ${k}`);
      }
    }
  }
});

test("a driver that is played turns back at the ends of its way by itself, and the reader's direction stays", () => {
  const { engine, store, model, update } = begin("chebyshev", { playing: true, speed: 4 });
  const player = new Player();
  const inputs = [];
  for (let i = 0; i < 200; i++) {
    const { inputShown } = update((state) => player.played(state, 0.05, engine, model));
    inputs.push(inputShown);
  }
  const back = inputs.some((inputShown, i) => i > 0 && inputShown < inputs[i - 1]);
  const forth = inputs.some((inputShown, i) => i > 0 && inputShown > inputs[i - 1]);
  assert.ok(back && forth, String(inputs));
  assert.deepEqual([store.get().view.direction, store.get().view.playing], [1, true]);
});

test("a crank that is played turns by its speed and its direction, and stands still at rest", () => {
  const { engine, store, model, update } = begin("jansen", { playing: true, phi_deg: 10 });
  const player = new Player();
  update((state) => player.played(state, 0.5, engine, model));
  assert.ok(Math.abs(store.get().view.phi_deg - 40) < 1e-9, String(store.get().view.phi_deg));
  update((state) => player.played(withView(state, { direction: turned(1), speed: 2 }), 0.5, engine, model));
  assert.ok(Math.abs(store.get().view.phi_deg - 340) < 1e-9, String(store.get().view.phi_deg));
  const rest = withView(store.get(), { playing: false });
  assert.equal(player.played(rest, 1, engine, model), rest);
  assert.deepEqual([turned(1), turned(-1)], [-1, 1]);
  const { view } = stoppedAt(store.get(), 725, model);
  assert.deepEqual([view.phi_deg, view.playing], [5, false]);
});

test("where nothing can be assembled a motion goes on from home", () => {
  const { engine, store, model, update } = begin("mixer-a", { phi_deg: 10 });
  for (const lengths of [{ l1: 0.8 }, { l2: 0.4 }]) update((state) => withDocument(state, lengths));
  update((state) => withView(state, { phi_deg: 170, playing: true }));
  const next = new Player().played(store.get(), 0.01, engine, model);
  model.follow(next);
  assert.ok(model.hasPose, String(next.view.phi_deg));
});

test("what the engine changes of a document is taken, with the place of the input that goes with it", () => {
  const { engine, store, model, drafts, now } = begin("jansen");
  const page = { store, model, drafts };
  const [field] = now().summary.dimensions.filter(({ kind }) => kind === "length").map((one) => one.field);
  drafts.keep(field);
  change(() => engine.simulator.setDimension(field, 16, inputNow(page)), field, page);
  assert.equal(drafts.has(field), false);
  const { summary, problems } = now();
  assert.deepEqual(problems, []);
  assert.ok(Math.abs(summary.dimensions.find((one) => one.field === field).value - 16) < 1e-9);
  // The problem of a refused value is kept for its field.
  change(() => engine.simulator.setDimension(field, 1e6, inputNow(page)), field, page);
  assert.ok(drafts.has(field));
  assert.ok(drafts.problems[0].code !== "not_a_number");
  // A change of a drawing is not taken if the state is of another kind.
  const before = store.get();
  store.put({ ...before, kind: "mixer" });
  assert.equal(take({ document: { l1: 1 } }, page), false);
});

test("any drag of any handle gives a mechanism that the engine takes, or is refused", () => {
  often(8, (dice) => {
    const { engine, store, model, drafts, now } = begin(dice.one(["mixer-a", "jansen", "whitworth", "class4-dwell", "crank-rocker"]), { phi_deg: dice.below(360) });
    const page = { store, model, drafts };
    for (let i = 0; i < 4; i++) {
      const { summary, handles, bounds = summary.bounds } = now();
      const at = dice.below(summary.handles.length);
      const [x, y] = [handles[2 * at] + dice.between(-0.1, 0.1) * (bounds[2] - bounds[0]), handles[2 * at + 1] + dice.between(-0.1, 0.1) * (bounds[3] - bounds[1])];
      change(() => engine.simulator.drag(summary.handles[at].name, inputNow(page), x, y), "drag", page);
      model.follow(store.get());
      assert.ok(model.accepted, JSON.stringify(now().problems));
      drafts.drop("drag");
    }
  });
});

test("what is compared is read at the same input, and only where it changes it is opened anew", () => {
  const { engine, update, now } = begin("mixer-a");
  const { document } = now().state;
  const compared = { kind: "mixer", document };
  const both = update((state) => withExtras(state, { compared }));
  assert.equal(both.compares, true);
  assert.deepEqual(both.compared.readouts, both.readouts);
  // A has the axes, input rate and measures of B.
  const byTime = update((state) => withView(state, { axes: "physical", omega: 2, epsilon: 3, measures: ["A-C.distance"] }));
  assert.deepEqual(byTime.compared.readouts, byTime.readouts);
  assert.notEqual(byTime.readouts.value("A-C.distance", 2), undefined);
  const { revision } = byTime.compared;
  const other = update((state) => withDocument(state, { l2: 0.9 }));
  assert.equal(other.compared.revision, revision);
  assert.notEqual(other.readouts.value("rocker.angle"), other.compared.readouts.value("rocker.angle"));
  const turned = update((state) => withView(state, { phi_deg: 100 }));
  assert.notEqual(turned.compared.readouts.value("rocker.angle"), other.compared.readouts.value("rocker.angle"));
  // The bounds contain both mechanisms.
  const { kind, document: jansen } = engine.catalogue.preset("jansen");
  const large = update((state) => withExtras(state, { compared: { kind, document: jansen } }));
  assert.ok(large.summary.bounds[2] - large.summary.bounds[0] > 10);
  // A mechanism with another kind of input is not compared.
  const train = engine.catalogue.preset("train-gears");
  const none = update((state) => withExtras(state, { compared: { kind: train.kind, document: train.document } }));
  assert.deepEqual([none.compares, none.compared], [false, null]);
  assert.equal(update((state) => withExtras(state, { compared: undefined })).compared, null);
});

test("a plot of a quantity that the new mechanism lacks is a dangling reference", () => {
  const { update, model } = begin("jansen", { plot: "F" });
  assert.equal(model.hasDanglingReference, false);
  update((state) => withView(state, { plot: "nothing" }));
  assert.deepEqual([model.hasDanglingReference, model.accepted], [true, false]);
  update((state) => withView(state, { plot: "angles" }));
  assert.equal(model.accepted, true);
});

test("an engine that broke is replaced by one with the last accepted state, and says so until it takes another", (t) => {
  t.mock.method(console, "error", () => {});
  const { engine, now, update } = begin("jansen");
  const frame = [...now().frame];
  assert.throws(() => engine.ask(() => {
    throw new WebAssembly.RuntimeError("unreachable");
  }), /trapped/);
  assert.equal(engine.trapped, true);
  assert.deepEqual(now().problems, [{ code: "trapped" }]);
  assert.deepEqual([...engine.at(now().input).frame], frame);
  assert.deepEqual(update((state) => withDocument(state, { title: "x" })).problems, []);
  assert.equal(engine.trapped, false);
});
