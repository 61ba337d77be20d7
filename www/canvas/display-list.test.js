import assert from "node:assert/strict";
import test from "node:test";
import { readDisplayList } from "assur/canvas/display-list.js";
import { textWidth } from "assur/canvas/text-width.js";

/** Path that records the calls of its methods. */
class Path {
  drawn = [];
  moveTo(...at) { this.drawn.push(["move", ...at]); }
  lineTo(...at) { this.drawn.push(["line", ...at]); }
  arc(...at) { this.drawn.push(["arc", ...at]); }
  closePath() { this.drawn.push(["close"]); }
}

const ROLES = ["frame", "crank"];
const LABELS = ["A", "B"];
const [POLYGONS, POLYLINE, CIRCLE] = [
  [1, 1, 3, 2, 3, 0, 0, 1, 0, 0, 1, 2, 5, 5, 6, 6],
  [2, 0, 0, 2, 0, 0, 4, 4],
  [3, 1, 2, 7, 8, 0.5],
];
const read = (list, before) => readDisplayList(Float32Array.from(list), 0, ROLES, LABELS, () => new Path(), before);

test("records become shapes and labels of their bodies, in their order", () => {
  const layers = read([...POLYLINE, 0, 3, ...POLYGONS, ...CIRCLE, 4, 1, 1, 1, 2, 3, -4]);
  assert.deepEqual(layers.map(({ body }) => body), [0, 3]);
  assert.deepEqual(layers[0].shapes[0].path.drawn, [["move", 0, 0], ["line", 4, 4]]);
  const [polygons, circle] = layers[1].shapes;
  assert.deepEqual([polygons.role, polygons.look, circle.role, circle.look], ["crank", 3, "crank", 2]);
  assert.deepEqual(polygons.path.drawn, [["move", 0, 0], ["line", 1, 0], ["line", 0, 1], ["close"], ["move", 5, 5], ["line", 6, 6], ["close"]]);
  assert.deepEqual(polygons.loops.map((loop) => [...loop]), [[0, 0, 1, 0, 0, 1], [5, 5, 6, 6]]);
  assert.deepEqual(circle.path.drawn, [["arc", 7, 8, 0.5, 0, 2 * Math.PI], ["close"]]);
  assert.deepEqual(layers[1].labels, [{ role: "crank", label: "B", x: 1, y: 2, dx: 3, dy: -4 }]);
});

test("a list begins where it is said to", () => {
  const [layer] = readDisplayList(Float64Array.from([9, 9, 9, ...POLYLINE]), 3, ROLES, LABELS, () => new Path());
  assert.equal(layer.shapes.length, 1);
});

test("shapes that are as they were are taken over, others are made anew", () => {
  const [first] = read([...POLYLINE, ...CIRCLE]);
  const [again] = read([...POLYLINE, ...CIRCLE], [first]);
  assert.equal(again.shapes[0], first.shapes[0]);
  assert.equal(again.shapes[1], first.shapes[1]);
  const [other] = read([...POLYLINE, 3, 1, 2, 7, 8, 0.75], [first]);
  assert.equal(other.shapes[0], first.shapes[0]);
  assert.equal(other.shapes[1].path.drawn[0][3], 0.75);
});

test("a record that nobody knows is a fault", () => {
  assert.throws(() => read([7, 0, 0]), /no record 7/);
});

test("a text is measured once for each form of number and each font", () => {
  let measured = 0;
  const context = { measureText: (text) => ({ width: ++measured && text.length }) };
  assert.equal(textWidth(context, "a", "12.5°"), 5);
  assert.equal(textWidth(context, "a", "99.9°"), 5);
  assert.equal(measured, 1);
  assert.equal(textWidth(context, "a", "100°"), 4);
  assert.equal(textWidth(context, "b", "12.5°"), 5);
  assert.equal(measured, 3);
});
