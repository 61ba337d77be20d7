// Pictures of the stage.
import assert from "node:assert/strict";
import test from "node:test";
import { Context, themeOf } from "assur/tests/canvas.js";
import { Page } from "assur/tests/page.js";
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

function viewOf(width, height) {
  const page = new Page("mixer-a");
  const canvas = { clientWidth: width, clientHeight: height, dataset: {}, getContext: () => new Context() };
  const view = new MechanismView(canvas, page.engine, themeOf(page.engine.roles));
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
