// Tests of a polygon at rest: it fills its box, its scale bar has the right length, and its names keep off its lines.
import assert from "node:assert/strict";
import test from "node:test";
import "assur/tests/canvas.js";
import { isFree } from "assur/canvas/boxes.js";
import { readDisplayList } from "assur/canvas/display-list.js";
import { labelledPoints } from "assur/canvas/painter.js";
import { Places } from "assur/canvas/places.js";
import { Transform } from "assur/canvas/transform.js";
import { alongLines, closeUp } from "assur/polygons/close-up.js";
import { Page } from "assur/tests/page.js";

const SIZE = { width: 380, height: 256 };
const MARGIN = 26;
const POSES = [[0, 0, 0]];

test("a polygon at rest is larger than in motion, within its box, and its scale bar is true", () => {
  const page = new Page("crank-rocker", { phi_deg: 62 });
  const { readouts } = page.now();
  const here = page.engine.simulator.polygons(page.now().frameInput, 1e6);
  for (const [order, picture] of here.pictures.entries()) {
    const { view, list, bar } = closeUp(picture, picture, SIZE, MARGIN);
    const usual = Transform.fit(picture.bounds, SIZE.width, SIZE.height, MARGIN);
    assert.ok(view.scale > 1.5 * usual.scale, `${view.scale} ${usual.scale}`);
    const layers = readDisplayList(Float32Array.from(list), 0, page.engine.roles, picture.names, () => new Path2D());
    const points = labelledPoints(layers, view, POSES);
    for (const { x, y } of points) assert.ok(x > 20 && x < SIZE.width - 20 && y > 20 && y < SIZE.height - 20, `${x} ${y}`);
    // The distance of c from the pole is the analogue of velocity or acceleration of C. The bar is a round length to the same scale.
    const labels = layers.flatMap((layer) => layer.labels.map(({ label }) => label));
    const [pole, c] = [labels.findIndex((label) => /^[pπ]$/.test(label)), labels.findIndex((label) => label.startsWith("c"))];
    const off = Math.hypot(points[c].x - points[pole].x, points[c].y - points[pole].y) / view.scale;
    if (order === 0) assert.ok(Math.abs(off - 4.5 * Math.abs(readouts.value("rocker.angle", 1))) < 1e-4, `${off}`);
    assert.ok(bar * view.scale <= 0.4 * SIZE.width && bar * view.scale > 0.1 * SIZE.width && /^[125]0*$/.test(String(bar).replace(/^0\.0*/, "")), String(bar));
    const lines = alongLines(layers, view);
    assert.ok(lines.length > 100);
    const places = new Places();
    places.begin(SIZE, points, lines);
    for (const label of layers.flatMap((layer) => layer.labels)) {
      const [x, y] = view.toScreen(label.x, label.y);
      const at = places.take(label.label, { x, y, dx: 12.75 * label.dx, dy: -12.75 * label.dy }, 10, 12.75);
      assert.ok(isFree({ left: at.x - 5, right: at.x + 5, top: at.y - 6.4, bottom: at.y + 6.4 }, lines), `${label.label} ${order}`);
    }
  }
});
