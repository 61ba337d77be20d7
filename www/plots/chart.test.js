// Tests of the plots: their texts, the places of the texts, and the input under a pointer. The engine draws the curves on a canvas without pixels.
import assert from "node:assert/strict";
import test from "node:test";
import { Context, themeOf } from "assur/tests/canvas.js";
import { axisName, described, drawAgainstCursor, drawAgainstText, inputAt } from "assur/plots/against.js";
import { isFree } from "assur/canvas/boxes.js";
import { ChartCursor } from "assur/plots/cursor.js";
import { drawMarks } from "assur/plots/marks.js";
import { ChartView } from "assur/plots/chart.js";
import { Refusal } from "assur/core/problem.js";
import { across, angleAt, down, shows } from "assur/plots/panel.js";
import { pointsOfFrame } from "assur/plots/pairs.js";
import { drawChartText } from "assur/plots/text.js";
import { axisValueText, power, unitOf } from "assur/plots/units.js";
import { quantityText } from "assur/plots/values.js";
import { withDocument, withView } from "assur/state/state.js";
import { often } from "assur/tests/random.js";
import { Page } from "assur/tests/page.js";
import { wordsOf } from "assur/tests/words.js";

const SIZE = { width: 620, height: 640 };
const en = wordsOf("en");

/**
 * @param {string} id
 * @param {object} [view]
 */
function begin(id, view = {}) {
  const page = new Page(id, { phi_deg: 62, ...view });
  const theme = themeOf(page.engine.roles);
  const draw = (change = (state) => state, lang = "en") => {
    page.store.update(change);
    page.words = wordsOf(lang);
    const snapshot = page.now();
    const context = new Context();
    const { palette, scale } = theme;
    const { panels, against } = page.engine.chart(context, { ...SIZE, palette, scale, ratio: 1, whole: false, only: snapshot.state.view.only, around: snapshot.input });
    const titles = drawChartText(context, panels, snapshot, theme);
    const labels = panels.map((panel, i) => drawMarks(context, panel, [titles[i]], snapshot, theme));
    if (against) drawAgainstText(context, against, snapshot, theme);
    return { panels, against, titles, labels, snapshot, texts: context.texts.map(({ text }) => text), written: context.texts };
  };
  return { page, theme, draw };
}

const has = (texts, part) => assert.ok(texts.some((text) => text.includes(part)), `${part}: ${texts}`);

test("zeros are labelled with their angle, extrema with value and angle; one label serves a common zero", () => {
  const { draw } = begin("mixer-a");
  const { texts } = draw();
  const count = (wanted) => texts.filter((text) => text === wanted).length;
  for (const wanted of ["23.1°", "217.1°", "99.7°", "60.3° at 23.1°", "148.2° at 217.1°", "0.673 at 99.7°", "−1.094 at 340.1°"]) assert.equal(count(wanted), 1, `${wanted}: ${texts}`);
  const point = draw((state) => withView(state, { plot: "C1" })).texts;
  for (const wanted of ["90.0°", "270.0°", "180.0°"]) assert.ok(point.filter((text) => text === wanted).length >= 2, `${wanted}: ${point}`);
});

test("no label of a plot is over another, over a title or outside the plot", () => {
  const { draw, page } = begin("mixer-a");
  for (const { id } of page.engine.catalogue.presets.filter(({ kind }, i) => kind !== "scheme" && (i < 8 || i % 4 === 0))) {
    const { draw: of } = begin(id, { phi_deg: 0 });
    for (const axes of id.startsWith("mixer") ? ["analogues", "physical"] : ["analogues"]) {
      const { panels, labels, titles } = of((state) => withView(state, { axes }));
      for (const [i, boxes] of labels.entries()) {
        const { left, top, width, height } = panels[i];
        for (const [k, box] of boxes.entries()) {
          assert.ok(isFree(box, [titles[i]]), `${id} ${k}`);
          for (const other of boxes.slice(0, k)) assert.ok(isFree(box, [other]), `${id} ${JSON.stringify([box, other])}`);
          assert.ok(box.left >= left && box.right <= left + width + 1e-6 && box.top >= top - 13 && box.bottom <= top + height + 3 + 1e-6, `${id} ${JSON.stringify(box)}`);
        }
      }
    }
  }
  assert.ok(draw().labels.flat().length > 8);
});

/** Makes a canvas without pixels for a view of the page; it has the boxes of the numbers painted on it. */
function canvasOf({ width, height }) {
  globalThis.ResizeObserver = class {
    constructor(measure) {
      this.observe = measure;
    }
  };
  globalThis.matchMedia = () => new EventTarget();
  const tags = [];
  const roundRect = (left, top, wide, tall) => tags.push({ left, top, right: left + wide, bottom: top + tall });
  const context = Object.assign(new Context(), { roundRect });
  return { canvas: { dataset: {}, clientWidth: width, clientHeight: height, getContext: () => context }, tags, context };
}

test("numbers at the cursor lie on no label, no title, no number of an axis and not on each other, at any size", () => {
  let labelled = 0;
  for (const [id, view, size] of [["mixer-a", {}, SIZE], ["jansen", {}, SIZE], ["stephenson-3", {}, { width: 340, height: 460 }], ["jansen", { plot: "F" }, { width: 900, height: 900 }], ["crank-rocker", { only: "value" }, { width: 340, height: 460 }]]) {
    const { page, theme } = begin(id, view);
    const { canvas, context } = canvasOf(size);
    const chart = new ChartView(canvas, page.engine, theme, () => assert.fail());
    chart.render(page.now());
    const axes = context.texts.filter(({ align }) => align !== "left").map(({ x, y, width, align }) => ({ left: align === "right" ? x - width : x - width / 2, right: align === "right" ? x : x + width / 2, top: align === "right" ? y - 5 : y, bottom: align === "right" ? y + 5 : y + 11 }));
    const still = [...chart.titles, ...axes, ...chart.labels.flat()];
    labelled += chart.labels.flat().length;
    for (const [k, box] of chart.labels.flat().entries()) assert.ok(isFree(box, still.filter((_, i) => i !== k + chart.titles.length + axes.length)), `${id} ${JSON.stringify(box)}`);
    const { canvas: over, tags } = canvasOf(size);
    const cursor = new ChartCursor(over, theme, chart, page.engine);
    cursor.render(page.now());
    for (let degrees = 0; degrees <= 360; degrees += 5) {
      tags.length = 0;
      cursor.hover((degrees * Math.PI) / 180);
      for (const [k, tag] of tags.entries()) assert.ok(isFree(tag, [...still, ...tags.slice(0, k)]), `${id} ${degrees} ${JSON.stringify(tag)}`);
    }
  }
  assert.ok(labelled > 30, String(labelled));
});

test("a low plot of several curves has marks without labels, which the cursor gives; on paper they are there", () => {
  const { page, theme } = begin("mixer-a");
  const { canvas } = canvasOf({ width: 340, height: 420 });
  const chart = new ChartView(canvas, page.engine, theme, () => assert.fail());
  chart.render(page.now());
  assert.deepEqual(chart.labels.map(({ length }) => length), [0, 0, 0]);
  const { canvas: over, context } = canvasOf({ width: 340, height: 420 });
  const cursor = new ChartCursor(over, theme, chart, page.engine);
  cursor.render(page.now());
  const said = (/** @type {number} */ degrees) => {
    context.texts.length = 0;
    cursor.hover((degrees * Math.PI) / 180);
    return context.texts.map(({ text }) => text);
  };
  const texts = said(217);
  for (const text of ["148.2° at 217.1°", "−296.4° at 217.1°", "0.000 at 217.1°", "217.0°"]) has(texts, text);
  assert.ok(!said(205).some((text) => text.includes(" at ")));
  const paper = new Context();
  chart.paint({ context: paper, ratio: 1 }, theme);
  has(paper.texts.map(({ text }) => text), "148.2° at 217.1°");
});

test("an axis of time says its unit once, by its last number", () => {
  for (const [lang, unit] of [["en", "s"], ["ru", "с"]]) {
    const { panels, texts } = begin("train-magnets").draw((state) => state, lang);
    const ticks = panels.at(-1).xticks.map(({ value }) => value);
    assert.ok(texts.includes(`${ticks.at(-1)}\u00a0${unit}`), String(texts));
    assert.ok(texts.includes(String(ticks[1])), String(texts));
  }
});

test("a curve that does not change says so, in the reader's words and numbers", () => {
  const { draw } = begin("peaucellier");
  const titles = (all) => [...new Set(all.texts.filter((text) => text.startsWith("x") || text.startsWith("ẋ") || text.startsWith("ẍ")))].sort();
  assert.deepEqual(titles(draw()), ["x = 4.583 throughout", "x′ = 0 throughout", "x″ = 0 throughout"].sort());
  const physical = draw((state) => withView(state, { axes: "physical" }), "ru").texts;
  for (const title of ["x = 4,583 всюду", "ẋ = 0 всюду", "ẍ = 0 всюду"]) assert.ok(physical.includes(title), `${title}: ${physical}`);
});

test("plots are titled with their quantities and units: analogues by the angle, rates by time", () => {
  const { draw } = begin("jansen", { plot: "F" });
  has(draw((state) => withDocument(state, { unit: "mm" })).texts, "coordinates, mm");
  const { texts } = draw((state) => withView(state, { axes: "physical" }));
  for (const unit of ["velocity, mm/s", "acceleration, mm/s²"]) has(texts, unit);
  const mixer = begin("mixer-a", { axes: "physical" }).draw().texts;
  for (const title of ["φ₃", "ω₃", "ω₅", "ε₃", "ε₅"]) assert.ok(mixer.includes(title), `${title}: ${mixer}`);
  has(mixer, "rad/s²");
});

test("the dots of differences are named where they lie, over the second derivative alone", () => {
  const { draw } = begin("mixer-a");
  assert.ok(!draw().texts.some((text) => text.includes("differences of")));
  const { texts } = draw((state) => withView(state, { differenced: true }));
  has(texts, "differences of φ′");
  assert.equal(texts.filter((text) => text.includes("differences")).length, 1);
});

test("one plot alone has all of the room", () => {
  const { draw } = begin("mixer-a");
  const three = draw().panels;
  assert.deepEqual(three.map(({ order }) => order), [0, 1, 2]);
  const [one, ...none] = draw((state) => withView(state, { only: "first" })).panels;
  assert.deepEqual([none.length, one.order], [0, 1]);
  assert.ok(one.height > 2 * three[1].height);
});

test("a place of a plot is found again: input across, value down", () => {
  const [panel] = begin("mixer-a").draw().panels;
  often(300, (dice) => {
    const input = dice.between(panel.x0, panel.x1);
    assert.ok(Math.abs(angleAt(panel, across(panel, input)) - input) < 1e-9);
  });
  assert.deepEqual([angleAt(panel, -1e4), angleAt(panel, 1e4)], [panel.x0, panel.x1]);
  assert.equal(down(panel, panel.y1), panel.top);
  assert.deepEqual([shows(panel, panel.y0), shows(panel, panel.y1 + 1)], [true, false]);
});

test("numbers of an axis have four digits of what it spans, and powers of ten where they are long", () => {
  const panel = (y0, y1, kind = "length", order = 0) => ({ y0, y1, kind, order, physical: false });
  for (const [y0, y1, value, text, exponent] of [[0, 1, 0.123456, "0.1235", 0], [0, 100, 12.3456, "12.35", 0], [-5000, 5000, 1234.5, "1235", 0], [0, 2e6, 1234567, "1.235", 6], [0, 5e-4, 1.23456e-4, "123.5", -6]]) {
    assert.equal(power(panel(y0, y1)), exponent, `${y0} ${y1}`);
    assert.equal(axisValueText(panel(y0, y1), value, en.numbers), text);
  }
  assert.equal(axisValueText(panel(0, 7, "angle"), Math.PI, en.numbers), "180.0°");
  assert.equal(axisValueText(panel(0, 7, "angle"), Math.PI, en.numbers, true), "180°");
  const coordinate = { moves: "angle" };
  assert.equal(unitOf(panel(0, 2e6), coordinate, en.measured("mm")), "10⁶ mm");
  assert.equal(unitOf(panel(0, 1, "angle", 1), coordinate, en), "1");
  assert.equal(unitOf({ ...panel(0, 1, "angle", 2), physical: true }, coordinate, en), "rad/s²");
  assert.equal(unitOf(panel(0, 1, "length", 2), coordinate, en.measured("m")), "m");
  assert.equal(unitOf(panel(0, 1, "length", 1), { moves: "length" }, en.measured("m")), "1");
});

test("values that stand alone have three decimals, large ones fewer", () => {
  const say = (...of) => quantityText(...of, en).text;
  assert.deepEqual([say(Math.PI, "angle", 0), say(1, "angle", 1), say(1234.567, "x", 0), say(1.5e7, "y", 2), say(0.1, "distance", 0)], ["180.000°", "1.000", "1234.6", "15000000", "0.100"]);
  assert.equal(quantityText(Math.PI, "corner", 0, en).value, 180);
});

test("any two quantities are plotted against each other, by axes with names and units", () => {
  const { draw } = begin("mixer-a", { against: { x: "C.dx", y: "rocker.ddangle" } });
  const { texts, against } = draw();
  has(texts, "↑ φ₃″, 1/rad");
  assert.ok(texts.some((text) => text.startsWith("x′ C")), String(texts));
  assert.ok(against.curve.flat().every(Number.isFinite) && against.curve.flat().length > 300);
  const input = draw((state) => withView(state, { against: { x: "input", y: "rocker.angle" } }));
  for (const title of ["↑ φ₃, °", "φ₁, ° →"]) assert.ok(input.texts.includes(title), `${title}: ${input.texts}`);
  assert.ok(described(input.against, input.snapshot).startsWith("φ₃ against φ₁."), described(input.against, input.snapshot));
  const train = begin("train-gears", { against: { x: "carrier.angle", y: "carrier.dangle" } }).draw();
  has(train.texts, "↑ ω₃, rad/s");
  assert.ok(train.texts.includes("φ₃, ° →"), String(train.texts));
});

test("points of the frame have neither path nor hodograph to choose", () => {
  const { page } = begin("whitworth");
  assert.deepEqual(pointsOfFrame(page.store.get()), ["A", "D", "G"]);
  assert.deepEqual(pointsOfFrame(new Page("mixer-a").store.get()), []);
});

test("a press on a curve is the input of its place, next to the motion where it passes twice", () => {
  const { draw } = begin("jansen", { against: { x: "F.x", y: "F.y" } });
  const { against, snapshot } = draw();
  const points = against.curve.flatMap((run) => Array.from({ length: run.length / 3 }, (_, i) => run.slice(3 * i, 3 * i + 3)));
  often(200, (dice) => {
    const [x, y, input] = dice.one(points);
    assert.ok(Math.abs(inputAt(against, x, y, 10, input) - input) < 0.2, `${input}`);
  });
  // If the curve passes only once near the pointer, that pass is taken, whatever the current input.
  const [x0, y0, top] = points.reduce((best, point) => (point[1] < best[1] ? point : best));
  for (const away of [1, 2, 3]) assert.ok(Math.abs(inputAt(against, x0, y0, 10, top + away) - top) < 0.5, String(away));
  assert.equal(inputAt(against, against.left - 30, against.top, 10, 0), null);
  // Both axes of a path have the same scale.
  const { x, y, width, height } = against;
  assert.ok(Math.abs(width / (x.to - x.from) / (height / (y.to - y.from)) - 1) < 1e-6);
  assert.equal(axisName(x, against, snapshot), "x F");
});

test("the cursor on a curve has both numbers of its place, and hides what a lesson asks for", () => {
  const { draw, page, theme } = begin("mixer-a", { against: { x: "C.dx", y: "rocker.ddangle" } });
  const { against, snapshot } = draw();
  const tag = (withheld) => {
    const context = Object.assign(new Context(), { roundRect() {}, save() {}, restore() {} });
    drawAgainstCursor(context, against, snapshot.plotted, { ...snapshot, withheld }, theme, { tagged: true });
    return context.texts.map(({ text }) => text).find((text) => text.includes("; "));
  };
  const numbers = tag(new Set()).split("; ").map((text) => Number(text.replace("−", "-")));
  const { readouts } = page.now();
  assert.ok(Math.abs(numbers[0] - readouts.value("C.x", 1)) < 6e-4 && Math.abs(numbers[1] - readouts.value("rocker.angle", 2)) < 6e-4, String(numbers));
  assert.match(tag(new Set(["rocker.angle″"])), /; \?$/);
  assert.match(tag(new Set(["C.x′"])), /^\?; /);
});

test("plots that cannot be drawn are empty, and that is said once until they are drawn again", () => {
  const { page, theme } = begin("jansen");
  const { canvas } = canvasOf(SIZE);
  let told = 0;
  const chart = new ChartView(canvas, page.engine, theme, () => (told += 1));
  const render = (title) => {
    page.store.update((state) => withDocument(state, { title }));
    chart.render(page.now());
    return [chart.panels.length > 0, told];
  };
  assert.deepEqual(render("drawn"), [true, 0]);
  page.engine.chart = () => {
    throw new Refusal([{ code: "trapped" }]);
  };
  assert.deepEqual([render("failed"), render("failed"), render("failed again")], [[false, 1], [false, 1], [false, 1]]);
  delete page.engine.chart;
  assert.deepEqual(render("drawn again"), [true, 1]);
});
