// Tests of the proxy by which one function makes all calls of an object's functions.
import assert from "node:assert/strict";
import test from "node:test";
import { guarded } from "assur/core/guarded.js";

class Counter {
  count = 0;
  add(/** @type {number} */ by) {
    return (this.count += by);
  }
}

test("a call is made by the guard, on the owner of the moment", () => {
  let owner = new Counter();
  let calls = 0;
  const counter = guarded(() => owner, (call) => {
    calls += 1;
    return call();
  });
  assert.deepEqual([counter.add(2), counter.add(3), calls], [2, 5, 2]);
  owner = new Counter();
  assert.deepEqual([counter.add(1), calls], [1, 3]);
});

test("all but functions is undefined, and nothing can be set", async () => {
  const counter = guarded(() => new Counter(), () => assert.fail("no call"));
  assert.equal(counter.count, undefined);
  assert.equal(counter.ad, undefined);
  assert.equal(await counter, counter);
  assert.throws(() => {
    counter.add = () => 0;
  }, TypeError);
});
