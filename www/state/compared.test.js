// Tests of mechanism A if its simulator breaks.
import assert from "node:assert/strict";
import test from "node:test";
import { Compared } from "assur/state/compared.js";
import { initialState, withExtras } from "assur/state/state.js";

/** Simulator whose calls trap. It then stays borrowed and cannot be freed. */
class Trapped {
  set() {
    throw new Error("unreachable");
  }

  free() {
    throw new Error("attempted to take ownership of Rust value while it was borrowed");
  }
}

test("a trap of A leaves B as it is", (t) => {
  const said = t.mock.method(console, "error", () => {});
  const compared = new Compared(() => new Trapped());
  const state = withExtras(initialState("mixer", { l1: 0 }, {}), { compared: { kind: "mixer", document: { l1: 1 } } });
  const summary = { bounds: [0, 0, 1, 1], moves: "angle" };
  assert.equal(compared.follow(state, summary), summary);
  assert.equal(compared.shown, null);
  assert.ok(said.mock.callCount() > 0);
});
