import assert from "node:assert/strict";
import test from "node:test";
import { Drafts, partOf } from "assur/state/drafts.js";

test("refused input is kept until it is accepted, and each change is reported", () => {
  let changes = 0;
  const drafts = new Drafts(() => (changes += 1));
  drafts.keep("l1");
  drafts.keep("l2", [{ code: "refused", by: 1 }]);
  assert.deepEqual(drafts.problems, [{ code: "not_a_number", field: "l1" }, { code: "refused", by: 1 }]);
  assert.deepEqual([drafts.has("l1"), drafts.has("l3"), changes], [true, false, 2]);
  drafts.drop("l1");
  drafts.drop("l1");
  assert.deepEqual([drafts.fields(), changes], [["l2"], 3]);
});

test("a list is dropped with all that is in it, and nothing else", () => {
  const drafts = new Drafts(() => {});
  for (const field of ["wheels[0].z", "wheels[12].z", "wheelsize", "l1"]) drafts.keep(field);
  drafts.dropAll(["wheels"]);
  assert.deepEqual(drafts.fields(), ["wheelsize", "l1"]);
  assert.deepEqual(["wheels[2].z", "l1", "bodies.inertia[0]"].map(partOf), ["wheels", "l1", "bodies.inertia"]);
});
