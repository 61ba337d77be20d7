// Tests of the dwell painted over the plots: only over those of the output whose band the document gives, and clear of all labels.
import "assur/tests/document.js";
import assert from "node:assert/strict";
import test from "node:test";
import { paintCourse } from "assur/kinds/linkage/course.js";
import { isFree } from "assur/canvas/boxes.js";
import { drawMarks } from "assur/plots/marks.js";
import { withDocument, withView } from "assur/state/state.js";
import { Context, themeOf } from "assur/tests/canvas.js";
import { Page } from "assur/tests/page.js";

const SIZE = { width: 380, height: 480 };

/** Boxes of the magnified dwell on the plots of a page, the texts in them, and the labels of the marks. */
function painted(page) {
  const theme = themeOf(page.engine.roles);
  const snapshot = page.now();
  const context = new Context();
  const { palette, scale } = theme;
  const { panels } = page.engine.chart(context, { ...SIZE, palette, scale, ratio: 1, whole: false, only: snapshot.state.view.only, around: snapshot.input });
  const insets = paintCourse(context, panels, snapshot, page.engine, theme);
  const labels = panels.map((panel, i) => drawMarks(context, panel, insets[i] ? [insets[i]] : [], snapshot, theme));
  return { panels, insets, labels, texts: context.texts };
}

test("the dwell is magnified on the plots of the output that has the band, not on those of another link", () => {
  const page = new Page("class4-dwell");
  assert.equal(painted(page).insets.filter(Boolean).length, 3);
  page.store.update((state) => withView(state, { plot: "AB.angle" }));
  page.store.update((state) => withDocument(state, { drivers: [{ crank: "CD" }] }));
  const { panels, insets } = painted(page);
  assert.ok(panels.length > 0);
  assert.deepEqual(insets, []);
});

test("marks keep off the magnified dwell, and its scale stands above its curve", () => {
  const { insets, labels, texts } = painted(new Page("class4-dwell"));
  insets.forEach((inset, i) => {
    assert.ok(labels[i].length > 0);
    for (const label of labels[i]) assert.ok(isFree(label, [inset]), JSON.stringify([label, inset]));
  });
  const scales = texts.filter(({ text }) => text.startsWith("↕"));
  assert.equal(scales.length, 3);
});
