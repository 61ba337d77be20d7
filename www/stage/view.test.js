// Tests of the view of the drawing, and of the pictures made of it.
import assert from "node:assert/strict";
import test from "node:test";
import { Context, themeOf } from "assur/tests/canvas.js";
import { Page } from "assur/tests/page.js";
import { newDrawing } from "assur/drawing/begin.js";
import { MechanismView } from "assur/stage/view.js";

globalThis.OffscreenCanvas ??= class {
  getContext() {
    return new Context();
  }
};
globalThis.matchMedia ??= () => new EventTarget();
globalThis.ResizeObserver ??= class {
  #measure;

  constructor(measure) {
    this.#measure = measure;
  }

  observe() {
    this.#measure();
  }
};

const canvasOf = (clientWidth, clientHeight) => ({ clientWidth, clientHeight, dataset: {}, getContext: () => new Context() });

function viewOf(width, height, id = "mixer-a", look = {}) {
  const page = new Page(id, look);
  const view = new MechanismView(canvasOf(width, height), page.engine, themeOf(page.engine.roles));
  view.render(page.now());
  return view;
}

test("a picture shows the mechanism whole and large, whether the stage is seen or not, zoomed or not", () => {
  for (const [width, height] of [[800, 600], [0, 0], [800, 0], [0, 600]]) {
    const view = viewOf(width, height);
    for (const zoom of [() => {}, () => view.zoom(2)]) {
      zoom();
      const { size } = view.sheet();
      assert.ok(Math.max(size.width, size.height) > 400 && Math.min(size.width, size.height) > 150, `${width} × ${height}: ${JSON.stringify(size)}`);
    }
  }
});

test("a picture of a drawing whose view is kept has a usual size, however large and far the mechanism", () => {
  const page = new Page("crank-rocker", { drawing: true });
  const view = new MechanismView(canvasOf(800, 600), page.engine, themeOf(page.engine.roles));
  view.keep(true, () => ({ top: 40, bottom: 0 }));
  const now = page.now();
  view.render(now);
  for (const bounds of [[0, 0, 1e9, 1e9], [1e18, 1e18, 2e18, 2e18], [0, 0, 1e-9, 1e-9]]) {
    view.render({ ...now, summary: { ...now.summary, bounds } });
    const { width, height } = view.sheet().size;
    assert.ok(width > 100 && width <= 800 && height > 100 && height <= 600, `${bounds}: ${width} × ${height}`);
  }
});

test("buttons in the corner cover nothing of a fitted drawing, and take no room where they cover nothing", () => {
  const corner = { width: 250, height: 64 };
  for (const [id, width, height, shrinks] of [["jansen", 360, 300, true], ["jansen", 960, 900, true], ["mixer-a", 600, 630, false]]) {
    const view = viewOf(width, height, id);
    const before = view.view.scale;
    view.spare(corner.width, corner.height);
    const under = view.joints().filter(({ x, y }) => {
      const [left, top] = view.view.toScreen(x, y);
      return left > width - corner.width && top > height - corner.height;
    });
    assert.deepEqual(under, [], id);
    assert.equal(view.view.scale < before, shrinks, `${id} ${width} × ${height}`);
  }
});

test("a new drawing has the scale of an empty sheet, whatever was drawn and zoomed before", () => {
  const page = new Page("crank-rocker", { drawing: true });
  const shown = (mechanism) => {
    page.mechanism = mechanism;
    mechanism.render(page.now());
    return mechanism;
  };
  const view = shown(new MechanismView(canvasOf(800, 600), page.engine, themeOf(page.engine.roles)));
  view.keep(true, () => ({ top: 40, bottom: 0 }));
  view.zoom(5);
  const before = view.view.scale;
  newDrawing(page);
  const { scale } = shown(view).view;
  const fresh = new MechanismView(canvasOf(800, 600), page.engine, themeOf(page.engine.roles));
  fresh.keep(true, () => ({ top: 40, bottom: 0 }));
  assert.equal(scale, shown(fresh).view.scale);
  assert.notEqual(scale, before);
  assert.ok(!view.zoomed);
});

test("all that is shown is brought into view: distant instant centres and circles with the mechanism", () => {
  const [width, height] = [600, 400];
  const look = { phi_deg: 140, instant_centres: true, curvature: true };
  const view = viewOf(width, height, "crank-rocker", look);
  const before = view.view.scale;
  // At this input, the instant centre P₀₂, where the lines of crank and rocker meet, lies far below the frame.
  const far = [Math.cos, Math.sin].map((of) => of((140 * Math.PI) / 180));
  const along = (/** @type {number} */ t) => /** @type {const} */ ([t * far[0], t * far[1]]);
  view.fitAll();
  assert.ok(view.zoomed && view.view.scale < before);
  const [left, top] = view.view.toScreen(...along(-14.2));
  assert.ok(left > 0 && left < width && top > 0 && top < height, `${left} ${top}`);
  view.fit();
  assert.equal(view.view.scale, before);
  // Without overlays, the view is the fitted one.
  const plain = viewOf(width, height, "crank-rocker", { phi_deg: 140 });
  plain.fitAll();
  assert.equal(plain.zoomed, false);
});
