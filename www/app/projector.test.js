// Tests of projector mode, which the browser stores apart from the state.
import assert from "node:assert/strict";
import test, { beforeEach } from "node:test";
import { open, takeAddress } from "assur/app/opening.js";
import { keptProjector, toggleProjector } from "assur/app/projector.js";
import { toAddress } from "assur/state/codec.js";
import { Page } from "assur/tests/page.js";

const HOME = "https://assur.test/";
const kept = new Map();
globalThis.localStorage = { getItem: (key) => kept.get(key) ?? null, setItem: (key, text) => kept.set(key, text), removeItem: (key) => kept.delete(key) };

beforeEach(() => kept.clear());

test("the mode is known on the next visit until it is turned off, but not from a frame", () => {
  const page = new Page("mixer-a");
  toggleProjector(page);
  assert.deepEqual([page.store.get().view.projector, keptProjector()], [true, true]);
  toggleProjector(page);
  assert.deepEqual([page.store.get().view.projector, keptProjector()], [false, false]);
  toggleProjector(Object.assign(page, { habits: { embedding: {} } }));
  assert.deepEqual([page.store.get().view.projector, keptProjector()], [true, false]);
});

test("a link opened in class stays in the mode, whatever it says", async () => {
  const { engine, store } = new Page("klann");
  const habits = { calm: true, lang: "en", projector: true };
  const whole = toAddress(store.get(), null);
  assert.match(whole, /projector=false/);
  for (const hash of ["klann", whole]) {
    assert.equal((await takeAddress(`${HOME}#${hash}`, engine, habits)).state.view.projector, true, hash);
    assert.equal((await takeAddress(`${HOME}#${hash}`, engine, { ...habits, projector: false })).state.view.projector, false, hash);
  }
  globalThis.location = { href: HOME };
  assert.equal((await open(engine, habits)).state.view.projector, true);
});
