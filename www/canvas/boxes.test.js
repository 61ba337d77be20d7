import assert from "node:assert/strict";
import test from "node:test";
import { cheapest, covered, isFree } from "assur/canvas/boxes.js";
import { often } from "assur/tests/random.js";

const box = (left, top, width = 10, height = 4) => ({ left, top, right: left + width, bottom: top + height });

test("boxes are free of each other where they have no point of their insides in common", () => {
  assert.ok(isFree(box(0, 0), []));
  // Edges may touch.
  assert.ok(isFree(box(0, 0), [box(10, 0), box(0, 4), box(-10, 0), box(0, -4)]));
  for (const [left, top] of [[9, 3], [-9, -3], [9, -3], [0, 0]]) assert.ok(!isFree(box(0, 0), [box(50, 50), box(left, top)]), `${left} ${top}`);
  often(300, (dice) => {
    const [one, other] = [0, 1].map(() => box(dice.between(0, 20), dice.between(0, 20), dice.between(1, 9), dice.between(1, 9)));
    const wide = Math.min(one.right, other.right) - Math.max(one.left, other.left);
    const tall = Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top);
    assert.equal(isFree(one, [other]), wide <= 0 || tall <= 0);
    assert.equal(isFree(other, [one]), isFree(one, [other]));
  });
});

test("points are counted in a box and within a pixel of it, whatever else a point has", () => {
  const points = [[5, 2], [-0.5, 2], [-1.5, 2], [5, 4.5], [5, 5.5], [10.5, -0.5]];
  assert.equal(covered(points.flat(), 2, box(0, 0)), 4);
  // The third number of a point is not a coordinate. Read as x or y, it would be in the box.
  assert.equal(covered(points.flatMap((point) => [...point, 3]), 3, box(0, 0)), 4);
});

test("of equally cheap choices the first is taken", () => {
  assert.equal(cheapest(["abc", "de", "fg", "hij"], ({ length }) => length), "de");
});
