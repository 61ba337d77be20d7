import assert from "node:assert/strict";
import test from "node:test";
import { Places } from "assur/canvas/places.js";
import { often } from "assur/tests/random.js";

const SHEET = { width: 400, height: 300 };
const [WIDTH, HEIGHT] = [30, 15];

const boxOf = ({ x, y }) => ({ left: x - WIDTH / 2, right: x + WIDTH / 2, top: y - HEIGHT / 2, bottom: y + HEIGHT / 2 });
const apart = (one, other) => one.right <= other.left || other.right <= one.left || one.bottom <= other.top || other.bottom <= one.top;
const at = (x, y) => ({ x, y, dx: 14, dy: -12 });

/**
 * @param {Places} places
 * @param {Record<string, ReturnType<typeof at>>} labels
 */
function spotsOf(places, labels) {
  places.begin(SHEET);
  return Object.fromEntries(Object.entries(labels).map(([name, wanted]) => [name, places.take(name, wanted, WIDTH, HEIGHT)]));
}

test("a label alone stands where it is wanted", () => {
  assert.deepEqual(spotsOf(new Places(), { A: at(100, 100) }).A, { x: 114, y: 88, free: true });
});

test("a label whose place is taken goes to the opposite side of its point", () => {
  const { B } = spotsOf(new Places(), { A: at(100, 100), B: at(100, 100) });
  assert.deepEqual(B, { x: 86, y: 112, free: true });
});

test("labels that are placed are not over each other, and stay on the sheet", () => {
  often(30, (dice) => {
    const places = new Places();
    let points = Array.from({ length: 14 }, () => at(dice.between(0, SHEET.width), dice.between(0, SHEET.height)));
    for (let frame = 0; frame < 20; frame++) {
      points = points.map(({ x, y }) => at(x + dice.between(-9, 9), y + dice.between(-9, 9)));
      const boxes = Object.values(spotsOf(places, points)).filter(({ free }) => free).map(boxOf);
      for (const [i, box] of boxes.entries()) {
        for (const other of boxes.slice(0, i)) assert.ok(apart(box, other), JSON.stringify([box, other]));
      }
      for (const [i, box] of Object.values(spotsOf(places, points)).map(boxOf).entries()) {
        const on = points[i].x >= 0 && points[i].x <= SHEET.width && points[i].y >= 0 && points[i].y <= SHEET.height;
        const within = box.left >= 0 && box.right <= SHEET.width && box.top >= 0 && box.bottom <= SHEET.height;
        if (on) assert.ok(within, JSON.stringify(box));
      }
    }
  });
});

test("a label is moved only where the wanted place is taken", () => {
  often(200, (dice) => {
    const points = Array.from({ length: 10 }, () => at(dice.between(30, 370), dice.between(30, 270)));
    const found = Object.values(spotsOf(new Places(), points));
    for (const [i, { x, y, free }] of found.entries()) {
      const wanted = { x: points[i].x + points[i].dx, y: points[i].y + points[i].dy };
      if (!free || (x === wanted.x && y === wanted.y)) continue;
      const before = found.slice(0, i).filter((one) => one.free).map(boxOf);
      const kept = boxOf({ x: Math.min(Math.max(wanted.x, WIDTH / 2), SHEET.width - WIDTH / 2), y: Math.min(Math.max(wanted.y, HEIGHT / 2), SHEET.height - HEIGHT / 2) });
      const clamped = kept.left !== boxOf(wanted).left || kept.top !== boxOf(wanted).top;
      assert.ok(clamped || before.some((box) => !apart(box, kept)), JSON.stringify({ x, y, wanted }));
    }
  });
});

test("a label that has moved goes back with room to spare only, and does not flicker", () => {
  const places = new Places();
  const frame = (off) => spotsOf(places, { A: at(100, 100), B: at(100 + off, 100) }).B.x - (100 + off);
  assert.equal(frame(0), -14);
  // With a clearance of one pixel the label does not go back. It does with three quarters of its height on both sides.
  assert.equal(frame(WIDTH + 1), -14);
  assert.equal(frame(WIDTH + 0.75 * HEIGHT - 1), -14);
  assert.equal(frame(WIDTH + 0.75 * HEIGHT + 1), 14);
  // Back in its wanted place, the label stays there while the place is free.
  assert.equal(frame(WIDTH + 1), 14);
  assert.equal(frame(WIDTH - 1), -14);
});

test("a label to and fro about the end of its room changes its side once", () => {
  const places = new Places();
  const sides = Array.from({ length: 40 }, (_, i) => spotsOf(places, { A: at(100, 100), B: at(129 + (i % 2) * 2, 100) }).B.x > 129 + (i % 2) * 2);
  assert.ok(new Set(sides.slice(1)).size === 1, String(sides));
});

test("where no side is free a label is where it is wanted, and takes no room", () => {
  const places = new Places();
  places.begin(SHEET);
  // Each of the eight places of a label overlaps the label that was placed first.
  const all = Array.from({ length: 10 }, (_, i) => places.take(`L${i}`, { x: 200, y: 150, dx: 4, dy: 4 }, 200, 100));
  assert.equal(all.filter(({ free }) => free).length, 1);
  assert.deepEqual(all[9], { x: 204, y: 154, free: false });
});

test("a label of a point that is off the sheet is not drawn in", () => {
  const { A, B } = spotsOf(new Places(), { A: at(-200, 100), B: at(395, 5) });
  assert.deepEqual([A.x, A.y], [-186, 88]);
  assert.deepEqual([B.x, B.y], [SHEET.width - WIDTH / 2, HEIGHT / 2]);
});

test("a label does not stand nearer to the point of another one, unless there is no other place", () => {
  const places = new Places();
  const own = { x: 100, y: 100, dx: 12, dy: -12 };
  const tip = { x: 112, y: 86 };
  places.begin({ width: 300, height: 300 }, [own, tip]);
  const { x, y, free } = places.take("B", own, 10, 14);
  assert.ok(free);
  assert.ok(Math.hypot(x - own.x, y - own.y) < Math.hypot(x - tip.x, y - tip.y), `${x} ${y}`);
  // Without another point near it, the label has its wanted place. A second point in the same place does not count.
  places.begin({ width: 300, height: 300 }, [own, { x: 100, y: 100 }]);
  assert.deepEqual(places.take("B", own, 10, 14), { x: 112, y: 88, free: true });
  const around = [1, -1].flatMap((dx) => [1, -1].map((dy) => ({ x: 100 + 12 * dx, y: 100 + 12 * dy })));
  places.begin({ width: 300, height: 300 }, [own, ...around, ...around.map(({ x, y }) => ({ x: 2 * x - 100, y: 2 * y - 100 }))]);
  assert.deepEqual(places.take("B", own, 10, 14), { x: 112, y: 88, free: true });
});
