import assert from "node:assert/strict";
import test from "node:test";
import { Transform, Zoom } from "assur/canvas/transform.js";
import { often } from "assur/tests/random.js";

const near = (found, expected, within = 1e-9) => {
  for (const [i, value] of found.entries()) assert.ok(Math.abs(value - expected[i]) <= within * Math.max(1, Math.abs(expected[i])), `${found} ${expected}`);
};

/** @param {import("assur/tests/random.js").Dice} dice */
function anything(dice) {
  return new Transform(10 ** dice.between(-3, 4), dice.between(-2000, 2000), dice.between(-2000, 2000));
}

test("a place of the model comes back from the screen", () => {
  often(500, (dice) => {
    const view = anything(dice);
    const [x, y] = [dice.between(-50, 50), dice.between(-50, 50)];
    near(view.toModel(...view.toScreen(x, y)), [x, y], 1e-6 / Math.min(view.scale, 1));
    // Up in the model is up on the screen.
    assert.ok(view.toScreen(x, y + 1)[1] < view.toScreen(x, y)[1]);
    assert.ok(view.toScreen(x + 1, y)[0] > view.toScreen(x, y)[0]);
  });
});

test("a fitted picture is as large as the margin allows, and in the middle", () => {
  often(500, (dice) => {
    const [width, height, margin] = [dice.between(100, 2000), dice.between(100, 2000), dice.between(0, 40)];
    const [xmin, ymin] = [dice.between(-9, 9), dice.between(-9, 9)];
    const bounds = [xmin, ymin, xmin + dice.between(0.01, 20), ymin + dice.between(0.01, 20)];
    const view = Transform.fit(bounds, width, height, margin);
    const [left, bottom] = view.toScreen(bounds[0], bounds[1]);
    const [right, top] = view.toScreen(bounds[2], bounds[3]);
    near([left + right, top + bottom], [width, height], 1e-9 * width);
    near([Math.min(left, top)], [margin], 1e-9 * width);
    assert.ok(Math.max(left, top) >= margin - 1e-6);
  });
});

test("zooming leaves the point under the pointer, moving moves all alike", () => {
  often(500, (dice) => {
    const view = anything(dice);
    const [factor, left, top] = [dice.between(0.2, 5), dice.between(0, 900), dice.between(0, 900)];
    const zoomed = view.scaled(factor, left, top);
    near([zoomed.scale], [view.scale * factor]);
    near(zoomed.toScreen(...view.toModel(left, top)), [left, top], 1e-7);
    const moved = view.moved(3, 5);
    const [x, y] = view.toScreen(1, 2);
    near(moved.toScreen(1, 2), [x + 3, y + 5]);
  });
});

test("a body is drawn where it stands, turned against the clock", () => {
  often(300, (dice) => {
    const view = anything(dice);
    const [x, y, angle, ratio] = [dice.between(-5, 5), dice.between(-5, 5), dice.between(-7, 7), dice.one([1, 1.5, 2])];
    let matrix = [];
    view.place({ setTransform: (...all) => (matrix = all) }, ratio, x, y, angle);
    const [a, b, c, d, e, f] = matrix;
    const [u, v] = [dice.between(-2, 2), dice.between(-2, 2)];
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
    const expected = view.toScreen(x + u * cos - v * sin, y + u * sin + v * cos).map((one) => one * ratio);
    near([a * u + c * v + e, b * u + d * v + f], expected, 1e-7);
  });
});

test("a zoom is the same view in a canvas of any size", () => {
  often(500, (dice) => {
    const bounds = [-2, -1, 3, 2];
    const [width, height] = [dice.between(200, 1500), dice.between(200, 1500)];
    const fit = Transform.fit(bounds, width, height, 20);
    const factor = dice.between(Zoom.MIN, 20);
    const view = fit.scaled(factor, dice.between(0, width), dice.between(0, height)).moved(dice.between(-9, 9), dice.between(-9, 9));
    const zoom = Zoom.between(fit, view, bounds, width, height);
    const [x, y] = view.toModel(width / 2, height / 2);
    const inside = x >= -2 && x <= 3 && y >= -1 && y <= 2;
    if (inside) near(zoom.upon(fit, width, height).toScreen(1, 1), view.toScreen(1, 1), 1e-7);
    // Whatever the size, the same point is in the middle.
    const other = Transform.fit(bounds, 640, 480, 20);
    near(zoom.upon(other, 640, 480).toModel(320, 240), [Math.min(Math.max(x, -2), 3), Math.min(Math.max(y, -1), 2)], 1e-7);
    near([zoom.upon(other, 640, 480).scale / other.scale], [zoom.factor]);
  });
});

test("a zoom stays within its limits, and its middle inside the drawing", () => {
  const [bounds, fit] = [[0, 0, 10, 10], Transform.fit([0, 0, 10, 10], 500, 500, 0)];
  assert.equal(Zoom.between(fit, fit.scaled(1000, 0, 0), bounds, 500, 500).factor, Zoom.MAX);
  assert.equal(Zoom.between(fit, fit.scaled(0.001, 0, 0), bounds, 500, 500).factor, Zoom.MIN);
  const far = Zoom.between(fit, fit.moved(1e5, 0), bounds, 500, 500);
  near(far.upon(fit, 500, 500).toModel(250, 250), [0, 5]);
  near(Zoom.NONE.upon(fit, 500, 500).toScreen(3, 4), fit.toScreen(3, 4));
});
