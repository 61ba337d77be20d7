// Tests of the drawing: places and texts of its labels.
import assert from "node:assert/strict";
import test from "node:test";
import { Context, themeOf } from "assur/tests/canvas.js";
import { Transform } from "assur/canvas/transform.js";
import { Figure } from "assur/stage/figure.js";
import { withExtras, withView } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

const SIZE = { width: 1000, height: 700 };
const HEIGHT = 15;
const ALL = { vectors: true, loop_vectors: true, transmission: true };

/**
 * Makes a page with a figure, and functions that paint it and return its labels as they are written.
 * @param {string} id
 * @param {object} [view]
 */
function begin(id, view = {}, { small = false, size = SIZE } = {}) {
  const page = new Page(id, view);
  const theme = themeOf(page.engine.roles);
  const figure = new Figure(page.engine, theme);
  const fit = Transform.fit(page.now().summary.bounds, size.width, size.height, 30);
  const paint = (change = (state) => state) => {
    page.store.update(change);
    const context = new Context();
    const target = { context, ratio: 1 };
    figure.take(page.now());
    figure.paintStill(target, fit);
    figure.paintMoving(target, fit);
    const shapes = new Set(context.painted);
    figure.paintLabels(target, fit, size, small);
    return { labels: context.texts, shapes };
  };
  return { page, theme, paint, turned: (degrees) => paint((state) => withView(state, { phi_deg: degrees })) };
}

const texts = ({ labels }) => labels.map(({ text }) => text);
const crossed = (one, other) => Math.abs(one.x - other.x) < (one.width + other.width) / 2 && Math.abs(one.y - other.y) < HEIGHT;

test("round a whole turn no label is over another, with everything shown", () => {
  const { turned } = begin("mixer-a", ALL);
  for (let degrees = 0; degrees <= 360; degrees += 2) {
    const { labels } = turned(degrees);
    assert.ok(labels.length > 12);
    for (const [i, one] of labels.entries()) {
      for (const other of labels.slice(0, i)) assert.ok(!crossed(one, other), `${degrees}°: ${JSON.stringify([one, other])}`);
    }
  }
});

test("a label that changes its side stays there, and does not jump to and fro", () => {
  const { turned } = begin("mixer-a", ALL);
  const jumps = new Map();
  let last = null;
  for (let degrees = 0; degrees <= 360; degrees += 4) {
    const { labels } = turned(degrees);
    for (const [i, { text, x, y }] of labels.entries()) {
      const before = last?.[i];
      if (before && Math.hypot(x - before.x, y - before.y) > 1.6 * HEIGHT) jumps.set(i, [...(jumps.get(i) ?? []), degrees, text]);
    }
    last = labels;
  }
  for (const all of jumps.values()) {
    // A label at the tip of a vector (′, ″) moves as fast as the tip.
    if (/[′″]$/.test(all[1])) continue;
    const at = all.filter((_, i) => i % 2 === 0);
    assert.ok(at.length <= 8 && at.every((one, i) => i === 0 || one - at[i - 1] > 4), String(all));
  }
});

test("what follows _ in a label stands lower and smaller beside the rest", () => {
  const { labels } = begin("class4-dwell", { loop_vectors: true, phi_deg: 60 }).paint();
  const eta = labels.findIndex(({ text }) => text === "η");
  const [symbol, low] = labels.slice(eta, eta + 2);
  assert.equal(low.text, "H");
  assert.ok(low.y > symbol.y && low.x > symbol.x && low.width < symbol.width, JSON.stringify([symbol, low]));
  assert.ok(!labels.some(({ text }) => text.includes("_")));
});

test("on a small drawing a label without a place is left out, on a large one it is written", () => {
  const size = { width: 120, height: 90 };
  const [large, small] = [false, true].map((is) => begin("mixer-a", ALL, { small: is, size }).paint().labels.length);
  assert.ok(small < large, `${small} ${large}`);
});

test("a label has the number of its frame: with a decimal at rest, in whole degrees in motion", () => {
  const { paint, page } = begin("mixer-a", { phi_deg: 75 });
  assert.ok(texts(paint()).includes("φ₁ = 75.0°"));
  for (let i = 1; i < 10; i++) {
    const moving = texts(paint((state) => withView(state, { playing: true, phi_deg: 75 + 1.4 * i })));
    assert.ok(moving.includes(`φ₁ = ${Math.round(75 + 1.4 * i)}°`), String(moving));
  }
});

test("what a lesson asks for is a question mark in the drawing too", () => {
  const { paint, page } = begin("mixer-a", { transmission: true, phi_deg: 75 });
  const known = texts(paint()).find((text) => text.startsWith("μ"));
  assert.match(known, /^μ = \d+\.\d°$/);
  page.model.withheld = new Set(["C.transmission"]);
  assert.ok(texts(paint()).includes("μ = ?"), String(texts(paint())));
});

test("links and points are called as the language calls them, with their numbers low", () => {
  const { paint } = begin("mixer-a", { phi_deg: 75, centres: true });
  const said = texts(paint());
  for (const label of ["A", "B", "C", "D", "4", "5", "C₁", "C₂", "C₃"]) assert.equal(said.filter((text) => text === label).length, 1, `${label} in ${said}`);
});

test("every mechanism of the catalogue is drawn in the colours of its links, and its labels are texts", () => {
  const { page } = begin("mixer-a");
  for (const { id } of page.engine.catalogue.presets) {
    const { paint, theme } = begin(id);
    const { labels, shapes } = paint();
    assert.ok(shapes.size >= 2, id);
    for (const colour of shapes) assert.ok(Object.values(theme.colours).includes(colour), `${id} ${colour}`);
    for (const { text, x, y } of labels) assert.ok(!/undefined|NaN|=\s*$/.test(text) && Number.isFinite(x + y), `${id} ${text}`);
  }
});

test("what is compared is drawn in one colour, without labels", () => {
  const { paint, page, theme } = begin("mixer-a", { phi_deg: 75 });
  const alone = paint();
  const { kind, document } = page.store.get();
  const both = paint((state) => withExtras(state, { compared: { kind, document: { ...document, l2: 0.9 } } }));
  assert.deepEqual(texts(both), texts(alone));
  assert.deepEqual([...both.shapes].filter((colour) => !alone.shapes.has(colour)), [theme.colours.secondary].filter((colour) => !alone.shapes.has(colour)));
});

test("names are names, whatever they look like", () => {
  const { page, paint } = begin("crank-rocker", { transmission: true });
  const { document } = page.store.get();
  const rename = (name) => ({ B: "x=input", M: "A=1", C: "rod", D: "by_hand" })[name] ?? name;
  const named = (points) => points.map((name) => rename(name));
  const other = {
    ...document, points: document.points.map((point) => ({ ...point, name: rename(point.name) })), links: document.links.map((link) => ({ ...link, points: named(link.points) })),
    frame: named(document.frame), traces: [], plots: [],
  };
  page.choose("linkage", other);
  assert.deepEqual(page.now().problems, []);
  const written = texts(paint((state) => withView(state, { transmission: true, phi_deg: 62 })));
  assert.ok(written.includes("x=input") && written.includes("A=1"), written.join("|"));
  assert.ok(written.includes("φ₁ = 62.0°") && written.some((text) => /^μ = \d/.test(text)), written.join("|"));
  // A point whose name equals the word of a link or a key of the words keeps its name in every language.
  page.words = wordsOf("ru");
  const translated = texts(paint());
  assert.ok(translated.includes("rod") && translated.includes("by_hand"), translated.join("|"));
});
