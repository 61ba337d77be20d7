import assert from "node:assert/strict";
import test from "node:test";
import { happen } from "assur/tests/window.js";
import { often } from "assur/tests/random.js";
import { Drafts } from "assur/state/drafts.js";
import { History } from "assur/state/history.js";
import { Store } from "assur/state/store.js";
import { UNDOABLE_VIEW, extrasOf, initialState, withDocument, withExtras, withMechanism, withView } from "assur/state/state.js";

/** Store with its drafts and its history, without a page. */
function begin() {
  const store = new Store(initialState("mixer", { l1: 0, l2: 0 }, { phi_deg: 0 }));
  const drafts = new Drafts(() => {});
  const history = new History(store, drafts);
  const set = (change) => store.update((state) => withDocument(state, change));
  return { store, drafts, history, set };
}

/** The parts of a state that undo restores, as text for comparisons. */
function undone(state) {
  return JSON.stringify([state.kind, state.document, extrasOf(state), UNDOABLE_VIEW.map((name) => state.view[name])]);
}

const slider = () => Object.assign(new HTMLInputElement(), { type: "range" });

test("a step is what changes until an event ends it: a typed number is one", () => {
  for (const end of ["change", "focusout", "click", "pointerdown"]) {
    const { store, history, set } = begin();
    for (const l1 of [0.9, 0.91, 0.912]) set({ l1 });
    happen(end);
    set({ l2: 1 });
    history.undo();
    assert.deepEqual(store.get().document, { l1: 0.912, l2: 0 }, end);
    history.undo();
    assert.deepEqual(store.get().document, { l1: 0, l2: 0 }, end);
    assert.equal(history.canUndo, false);
  }
});

test("a slider that is dragged is one step, also where the focus leaves another field after the press", () => {
  const { store, history, set } = begin();
  const target = slider();
  set({ l2: 5 });
  happen("change");
  happen("pointerdown", { target });
  set({ l1: 1 });
  happen("focusout", { target: new HTMLInputElement() });
  set({ l1: 2 });
  happen("pointerup", { target });
  set({ l1: 3 });
  history.undo();
  assert.deepEqual(store.get().document, { l1: 0, l2: 5 });
  history.undo();
  assert.equal(history.canUndo, false);
});

test("a held key is one step, and each press of a key another", () => {
  const { store, history, set } = begin();
  const target = slider();
  let l1 = 0;
  const press = (times) => {
    for (let i = 0; i < times; i++) {
      happen("keydown", { target, repeat: i > 0 });
      set({ l1: ++l1 });
      happen("change", { target });
    }
    happen("keyup", { target });
  };
  for (const times of [30, 1, 1]) press(times);
  for (const before of [31, 30, 0]) {
    history.undo();
    assert.equal(store.get().document.l1, before);
  }
  assert.equal(history.canUndo, false);
});

test("keys after a drag are a step of their own, keys during a drag are not", () => {
  const { store, history, set } = begin();
  const target = slider();
  happen("pointerdown", { target });
  set({ l1: 1 });
  happen("keydown", { target });
  set({ l1: 2 });
  happen("keyup", { target });
  set({ l1: 3 });
  happen("pointerup", { target });
  happen("keydown", { target });
  set({ l1: 4 });
  history.undo();
  assert.equal(store.get().document.l1, 3);
  history.undo();
  assert.equal(store.get().document.l1, 0);
});

test("a typed field is one step from its first key until it is left, also if the release of a key before was lost", () => {
  for (const target of [new HTMLInputElement(), new HTMLTextAreaElement()]) {
    const { store, history, set } = begin();
    happen("keydown", { target: slider() });
    set({ l2: 1 });
    happen("keydown", { target });
    happen("focusout");
    for (const l1 of [1, 12, 123]) {
      happen("keydown", { target });
      set({ l1 });
      happen("keyup", { target });
    }
    happen("change", { target });
    set({ l2: 2 });
    for (const before of [{ l1: 123, l2: 1 }, { l1: 0, l2: 1 }]) {
      history.undo();
      assert.deepEqual(store.get().document, before);
    }
  }
});

test("presses of a button are a step each, held down by Enter they are one", () => {
  const { store, history, set } = begin();
  for (const l1 of [1, 2]) {
    for (const event of ["pointerdown", "pointerup", "click"]) happen(event);
    set({ l1 });
  }
  for (const l1 of [3, 4, 5]) {
    happen("keydown", { repeat: l1 > 3 });
    happen("click");
    set({ l1 });
  }
  happen("keyup");
  for (const before of [2, 1, 0]) {
    history.undo();
    assert.equal(store.get().document.l1, before);
  }
});

test("where the driver stands, playing, speed and language make no step and are not undone", () => {
  const { store, history, set } = begin();
  store.update((state) => withView(state, { phi_deg: 40, playing: true, speed: 2, lang: "ru", direction: -1, plot: "C", axes: "physical" }));
  assert.equal(history.canUndo, false);
  set({ l1: 1 });
  happen("change");
  store.update((state) => withView(state, { phi_deg: 50, lang: "kk" }));
  history.undo();
  const { document, view } = store.get();
  assert.deepEqual([document.l1, view.phi_deg, view.lang, view.speed], [0, 50, "kk", 2]);
});

test("what is laid over the drawing, a lesson, a picture and what is compared are undone", () => {
  const { store, history } = begin();
  const changes = [
    (state) => withView(state, { traces: false }),
    (state) => withView(state, { measures: ["A-B.distance"] }),
    (state) => withView(state, { against: { x: "input", y: "C.y" } }),
    (state) => withExtras(state, { lesson: { title: "", steps: [] } }),
    (state) => withExtras(state, { compared: { kind: "mixer", document: { l1: 9, l2: 9 } } }),
    (state) => withExtras(state, { picture: { image: "x" } }),
    (state) => withMechanism(state, "linkage", { points: [] }),
  ];
  const states = [store.get()];
  for (const change of changes) {
    history.step(() => store.update(change));
    states.push(store.get());
  }
  for (const state of states.slice(0, -1).reverse()) {
    history.undo();
    assert.equal(undone(store.get()), undone(state));
  }
  for (const state of states.slice(1)) {
    history.redo();
    assert.equal(undone(store.get()), undone(state));
  }
});

test("another future takes the place of what was undone", () => {
  const { store, history, set } = begin();
  history.step(() => set({ l1: 1 }));
  history.undo();
  assert.deepEqual([history.canUndo, history.canRedo], [false, true]);
  history.step(() => set({ l1: 2 }));
  assert.deepEqual([history.canUndo, history.canRedo], [true, false]);
  history.redo();
  assert.equal(store.get().document.l1, 2);
});

test("a step of its own ends what was being typed and drops what was not taken", () => {
  const { store, drafts, history, set } = begin();
  set({ l1: 1 });
  drafts.keep("l2");
  history.step(() => set({ l1: 2 }));
  set({ l1: 3 });
  assert.deepEqual(drafts.fields(), []);
  for (const l1 of [2, 1, 0]) {
    history.undo();
    assert.equal(store.get().document.l1, l1);
  }
});

test("what joins a step is undone with it", () => {
  const { store, history, set } = begin();
  history.step(() => set({ l1: 1 }));
  history.join();
  set({ l2: 1 });
  history.undo();
  assert.deepEqual(store.get().document, { l1: 0, l2: 0 });
});

test("undo drops what was typed into fields of the document", () => {
  const { drafts, history, set } = begin();
  history.step(() => set({ l1: 1 }));
  for (const field of ["l1", "l2[1].z", "input"]) drafts.keep(field);
  history.undo();
  assert.deepEqual(drafts.fields(), ["input"]);
});

test("a rejected number is undone first, by itself", () => {
  const { store, drafts, history, set } = begin();
  set({ l1: 2.2 });
  happen("change");
  drafts.keep("l1");
  happen("change");
  history.undo();
  assert.deepEqual([store.get().document.l1, drafts.fields(), history.canRedo], [2.2, [], false]);
  history.undo();
  assert.deepEqual([store.get().document.l1, history.canUndo], [0, false]);
  // The same if there is no earlier step.
  drafts.keep("l2");
  assert.equal(history.canUndo, true);
  history.undo();
  assert.deepEqual([drafts.fields(), history.canUndo, history.canRedo], [[], false, true]);
});

test("a rejected number is undone with what was taken while it was typed", () => {
  const { store, drafts, history, set } = begin();
  set({ l1: 3 });
  drafts.keep("l1");
  for (const end of ["change", "focusout", "pointerdown", "click"]) happen(end);
  history.undo();
  assert.deepEqual([store.get().document.l1, drafts.fields()], [0, []]);
});

test("undo and redo where there is nothing change nothing", () => {
  const { store, history } = begin();
  const before = store.get();
  history.undo();
  history.redo();
  assert.equal(store.get(), before);
});

test("random edits: undone one by one they are the states before, redone the states after", () => {
  often(60, (dice) => {
    const { store, history } = begin();
    const lessons = [undefined, ...["one", "two"].map((title) => ({ title, steps: [] }))];
    const edits = [
      (state) => withDocument(state, { l1: dice.below(4) }),
      (state) => withDocument(state, { l2: dice.below(4) }),
      (state) => withView(state, { traces: !state.view.traces }),
      (state) => withView(state, { phi_deg: dice.below(360) }),
      (state) => withView(state, { measures: [`${dice.below(3)}-B.distance`] }),
      (state) => withExtras(state, { lesson: dice.one(lessons) }),
    ];
    // Reference model of the history: all entries, and the index of the shown one.
    const entries = [undone(store.get())];
    let at = 0;
    for (let step = 0; step < 80; step++) {
      const choice = dice.below(10);
      if (choice < 2) {
        history.undo();
        at = Math.max(at - 1, 0);
      } else if (choice < 4) {
        history.redo();
        at = Math.min(at + 1, entries.length - 1);
      } else {
        history.step(() => store.update(dice.one(edits)));
        const now = undone(store.get());
        // A change without effect is no step, and keeps the undone steps.
        if (now !== entries[at]) entries.splice(++at, Infinity, now);
      }
      assert.equal(undone(store.get()), entries[at]);
      assert.deepEqual([history.canUndo, history.canRedo], [at > 0, at < entries.length - 1]);
    }
  });
});

test("of many steps the last thousand are undone, and there undo ends", () => {
  const { store, history, set } = begin();
  for (let l1 = 1; l1 <= 1200; l1++) history.step(() => set({ l1 }));
  let steps = 0;
  for (; history.canUndo && steps < 2000; steps++) history.undo();
  assert.deepEqual([steps, store.get().document.l1], [1000, 200]);
  for (; history.canRedo; steps--) history.redo();
  assert.deepEqual([steps, store.get().document.l1], [0, 1200]);
});

test("pictures that were replaced are kept up to twenty million characters, however many steps each has", () => {
  const { store, history, set } = begin();
  const put = (n) => store.update((state) => withExtras(state, { picture: { image: String(n).padEnd(2_000_000, "A"), at: [0, 0], width: 1, turn_deg: 0, opacity: 1 } }));
  for (let n = 1; n <= 15; n++) {
    history.step(() => put(n));
    for (const l1 of [n, n + 0.5]) history.step(() => set({ l1 }));
  }
  let steps = 0;
  for (; history.canUndo; steps++) history.undo();
  // Ten pictures are kept: two steps of the newest are undone, and three of each other one.
  assert.deepEqual([Number.parseInt(store.get().picture.image, 10), steps], [6, 29]);
});
