import assert from "node:assert/strict";
import test from "node:test";
import { Refusal, attempt } from "assur/core/problem.js";
import { Seen } from "assur/core/seen.js";

test("what is refused comes back as problems, what is done as a value", () => {
  const problems = [{ code: "dead_point", phi: 1 }, { code: "bad_state" }];
  assert.deepEqual(attempt(() => 0), { value: 0, problems: [] });
  assert.deepEqual(attempt(() => { throw new Refusal(problems); }), { value: null, problems });
  assert.equal(new Refusal(problems).message, "dead_point, bad_state");
});

test("a fault that is no refusal goes on up", () => {
  assert.throws(() => attempt(() => { throw new TypeError("a fault"); }), TypeError);
});

test("what was shown is the same only where all its parts are", () => {
  const [seen, part] = [new Seen(), {}];
  assert.equal(seen.same(part, NaN), false);
  assert.equal(seen.same(part, 1), false);
  assert.equal(seen.same(part, 1), true);
  assert.equal(seen.same({}, 1), false);
  assert.equal(seen.same(part), false);
  assert.equal(seen.same(part, undefined), false);
});
