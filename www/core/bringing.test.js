// Tests of parts that are loaded on demand while the network fails.
import assert from "node:assert/strict";
import test from "node:test";
import { happen } from "assur/tests/window.js";
import { Bringing } from "assur/core/bringing.js";

function begin() {
  const seen = { changed: 0, failed: 0, asked: 0, now: 0, down: true };
  const bringing = new Bringing(() => (seen.changed += 1), () => (seen.failed += 1), () => seen.now);
  const bring = () => bringing.bring("kind", async () => {
    seen.asked += 1;
    if (seen.down) throw new TypeError("no net");
  });
  return { seen, bring };
}

test("a part that did not arrive is asked for again after a while, and said once each time", async () => {
  const { seen, bring } = begin();
  await bring();
  await bring();
  assert.deepEqual([seen.asked, seen.failed, seen.changed], [1, 1, 0]);
  seen.now = 6000;
  await bring();
  assert.deepEqual([seen.asked, seen.failed], [2, 2]);
  seen.down = false;
  seen.now = 12000;
  await bring();
  await bring();
  assert.deepEqual([seen.asked, seen.failed, seen.changed], [3, 2, 1]);
});

test("as soon as there is a network again it is asked for", async () => {
  const { seen, bring } = begin();
  await bring();
  seen.down = false;
  happen("online");
  assert.equal(seen.changed, 1);
  await bring();
  assert.deepEqual([seen.asked, seen.changed], [2, 2]);
  // A part that has loaded is not loaded again.
  happen("online");
  await bring();
  assert.equal(seen.asked, 2);
});

test("what is on its way is asked for once", async () => {
  const { seen, bring } = begin();
  seen.down = false;
  await Promise.all([bring(), bring()]);
  assert.equal(seen.asked, 1);
});
