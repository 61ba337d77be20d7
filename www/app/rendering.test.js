import assert from "node:assert/strict";
import test from "node:test";
import { Rendering } from "assur/app/rendering.js";

test("a view that breaks stops no other, is reported once, and is tried again with another mechanism", (t) => {
  const said = t.mock.method(console, "error", () => {});
  const drawn = [];
  let [broke, whole] = [0, false];
  const rendering = new Rendering(() => (broke += 1));
  const breaking = { render: ({ revision }) => {
    if (!whole) throw new Error("no room");
    drawn.push(`mended ${revision}`);
  } };
  const views = [{ render: ({ revision }) => drawn.push(`first ${revision}`) }, breaking, { render: ({ revision }) => drawn.push(`last ${revision}`) }];
  for (let frame = 0; frame < 3; frame++) rendering.all(views, { revision: 1 });
  assert.deepEqual(drawn, ["first 1", "last 1", "first 1", "last 1", "first 1", "last 1"]);
  assert.deepEqual([broke, said.mock.callCount()], [1, 1]);
  rendering.all(views, { revision: 2 });
  assert.equal(broke, 2);
  whole = true;
  rendering.all(views, { revision: 3 });
  assert.deepEqual(drawn.slice(-3), ["first 3", "mended 3", "last 3"]);
});
