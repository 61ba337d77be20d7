// Tests that tables, status line, steps of lessons and the worksheet show the same read-outs, and that none shows what a lesson asks for.
import { all } from "assur/tests/document.js";
import assert from "node:assert/strict";
import test from "node:test";
import { degrees } from "assur/core/angles.js";
import { idOf, readingOf } from "assur/core/quantity.js";
import { isLength } from "assur/core/symbols.js";
import { secrets } from "assur/lesson/quantity.js";
import { quantities } from "assur/lesson/tasks.js";
import { Tools } from "assur/lesson/tools.js";
import { withExtras } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { sheetOf } from "assur/tests/sheet.js";
import { Views } from "assur/tests/shown.js";

/** Mechanisms of the catalogue with their views. */
const CASES = [
  ["mixer-a", { phi_deg: 62 }], ["mixer-a", { axes: "physical", omega: 2, lang: "ru" }], ["crank-rocker", { measures: ["B-D.distance", "coupler-rocker.between"] }],
  ["slider-crank", { curvature: true }], ["class4-dwell", { groups: true }], ["jansen", { axes: "physical" }], ["whitworth", {}],
  ["train-gears", {}], ["train-magnets", {}], ["mobility-1a", {}],
];

/** A page that shows a mechanism, with its views. */
function open(id, view = {}) {
  const page = new Page(id, view);
  const snapshot = page.now();
  const views = new Views(page.engine, snapshot.kind);
  page.shown = views.shown;
  return { page, snapshot, views };
}

/** Ids, without `out-`, of the read-outs that show a question mark while a lesson asks for something. */
function asked({ views, snapshot }, withheld) {
  return views.render(snapshot, withheld).cells.filter((cell) => cell.asked).map(({ id }) => id.replace(/^out-/, "")).sort();
}

/** Texts and numbers of read-outs in the page itself, by the ids of their elements. */
function written() {
  return new Map(all(globalThis.document, "[id]").map((output) => [output.id, output]));
}

/** Read-outs in a step of a lesson: titles, texts and numbers. */
function inStep(views, names) {
  const tools = new Tools(views.shown);
  tools.show({ readouts: names }, () => ({}));
  const found = all(tools.element, "dl > div");
  tools.close();
  return found.map(({ children: [title, value], hidden }) => (hidden ? null : [title.textContent, value.textContent, value.dataset.value]));
}

/** Rows of the table and lines of the status line on a worksheet. */
function onPaper(page) {
  const sheet = sheetOf(page);
  return { rows: all(sheet, "tr").map(({ children }) => [...children].map((cell) => cell.textContent)), lines: all(sheet, "p").map(({ textContent }) => textContent) };
}

for (const [id, view] of CASES) {
  test(`tables, status line, step and worksheet show the same of ${id} ${JSON.stringify(view)}`, () => {
    const { page, snapshot, views } = open(id, view);
    const { shown, cells } = views.render(snapshot);
    assert.ok(cells.length > 3);
    assert.equal(new Set(cells.map(({ id: one }) => one)).size, cells.length);
    const outputs = written();
    const step = inStep(views, cells.map(({ id: one }) => one.replace(/^out-/, "")));
    for (const [i, cell] of cells.entries()) {
      const output = outputs.get(cell.id);
      const value = cell.value === undefined ? undefined : String(cell.value);
      assert.deepEqual([output.textContent, output.dataset.value], [cell.text, value], cell.id);
      assert.deepEqual(step[i], [cell.title, cell.text, value], cell.id);
      assert.ok(cell.text !== "" && cell.title !== "" && !/undefined|NaN/.test(cell.title + cell.text), JSON.stringify(cell));
    }
    const { rows, lines } = onPaper(page);
    for (const row of shown.rows("values", "curvature")) assert.ok(rows.some((one) => one.join("|") === [row.title, ...row.cells.map(({ text }) => text)].join("|")), row.title);
    for (const { title, cells: [{ text }] } of shown.rows("status")) assert.ok(lines.includes(`${title} ${text}`), title);
    for (const { title, cells: [{ text }] } of shown.rows("course")) assert.ok(!lines.includes(`${title} ${text}`), "the course is in the rail alone");
  });

  test(`every value in the table of ${id} ${JSON.stringify(view)} is the engine's, by its quantity and order`, () => {
    const { snapshot, views } = open(id, view);
    const { shown } = views.render(snapshot);
    const { listed = [] } = snapshot.summary;
    for (const { name, what } of listed) {
      for (const order of what === "transmission" || what === "pressure" ? [0] : [0, 1, 2]) {
        const reading = idOf(name, order);
        assert.deepEqual(readingOf(reading), { quantity: name, order });
        const value = snapshot.readouts.value(name, order);
        assert.equal(shown.find(reading).value, order === 0 && !isLength(what) ? degrees(value) : value, reading);
      }
    }
    assert.equal(shown.find("nobody.angle"), undefined);
    shown.clear();
    assert.deepEqual(inStep(views, ["input", "linkage-w"]), [null, null]);
  });
}

test("a derivative is called as its column is: by strokes, or by time with a letter of its own", () => {
  const title = (view, name) => {
    const { views, snapshot } = open("mixer-a", view);
    return views.render(snapshot).shown.find(name).title;
  };
  for (const [name, analogue, physical] of [
    ["rocker.angle", "φ₃ rocker, wheel 4", "φ₃ rocker, wheel 4"], ["rocker.angle′", "φ₃′ rocker, wheel 4", "ω₃ rocker, wheel 4"], ["wheel5.angle″", "ψ₅″ wheel 5", "ε₅ wheel 5"], ["C2.x′", "x′ C₂", "ẋ C₂"], ["input", "φ₁ input angle", "φ₁ input angle"],
  ]) {
    const plot = name.startsWith("C2") ? "C2" : "angles";
    assert.deepEqual([title({ plot }, name), title({ plot, axes: "physical", omega: 2 }, name)], [analogue, physical]);
  }
});

for (const [id, view, expected] of [
  ["crank-rocker", {}, {
    "rocker.angle:swing": ["course-stroke", "linkage-swing"], "rocker.angle:time_ratio": ["linkage-time-ratio"], "C.transmission:worst": ["linkage-transmission"],
    "rocker.angle": ["rocker.angle"], "rocker.angle″": ["rocker.angle″"], W: ["linkage-w"], input: [], "course-stroke": ["course-stroke"],
  }],
  ["slider-crank", { plot: "C" }, { "C.x:swing": ["course-stroke", "linkage-stroke"], "C.x′": ["C.x′"] }],
  ["mixer-a", {}, {
    "rocker.angle:swing": ["swing-rocker"], "wheel5.angle:swing": ["swing-wheel5"], "rocker.angle:time_ratio": ["time-ratio"], "C.transmission:worst": ["transmission"], ratio: ["ratio"],
  }],
  ["train-gears", {}, { "sun.angle′": ["sun.angle′", "train-sun"], "sun.angle": ["sun.angle"], "train-sun": ["train-sun"] }],
  ["mobility-1a", {}, { "scheme-w": ["scheme-w"], W: [] }],
]) {
  test(`what a lesson asks of ${id} is a question mark wherever it would stand`, () => {
    const { page, snapshot, views } = open(id, view);
    for (const [quantity, names] of Object.entries(expected)) {
      const withheld = [quantity];
      assert.deepEqual(asked({ views, snapshot }, withheld), names, quantity);
      const outputs = written();
      const step = inStep(views, names);
      const { rows, lines } = onPaper(page);
      for (const [i, name] of names.entries()) {
        const { title, text, value } = views.shown.find(name);
        assert.deepEqual([text, value], ["?", undefined], name);
        for (const [said, shown] of [[outputs.get(`out-${name}`).textContent, outputs.get(`out-${name}`).dataset.value], step[i].slice(1)]) {
          assert.deepEqual([said, shown], [`? ${page.words.text("lesson.asked")}`, undefined], name);
        }
        const inTable = views.shown.rows("values").findIndex(({ cells }) => cells.some((cell) => cell.id === `out-${name}`));
        if (inTable >= 0) assert.ok(rows.some((row) => row[0] === views.shown.rows("values")[inTable].title && row.includes("?")), name);
        else if (!name.startsWith("course-")) assert.ok(lines.includes(`${title} ?`), name);
      }
      // Read-outs that were withheld show their values again.
      assert.deepEqual(asked({ views, snapshot }, []), []);
      for (const name of names) assert.ok(!outputs.get(`out-${name}`).textContent.startsWith("?"), name);
    }
  });
}

test("whatever a lecturer may ask for is hidden by a read-out of its own, except the input", () => {
  for (const [id, view] of CASES) {
    const shown = open(id, view);
    for (const quantity of quantities(shown.snapshot)) {
      const withheld = secrets({ quantity, within: 0 });
      if (quantity === "input") assert.deepEqual(withheld, []);
      // The table of values does not list every quantity.
      else if (shown.views.render(shown.snapshot).shown.find(quantity)) assert.ok(asked(shown, withheld).includes(quantity), `${id} ${quantity}`);
      else if (quantity.includes(":")) assert.ok(asked(shown, withheld).length > 0, `${id} ${quantity}`);
    }
  }
});

test("the difference from another mechanism does not give away what a lesson asks for", () => {
  const { page, views } = open("mixer-a");
  page.store.update((state) => withExtras(state, { compared: { kind: "mixer", document: { ...state.document, l2: 0.9 } } }));
  const snapshot = page.now();
  assert.deepEqual(asked({ views, snapshot }, ["rocker.angle"]), ["difference-rocker.angle", "rocker.angle"]);
  const { cells } = views.shown.rows("values").find(({ title, cells: [{ id }] }) => title === "Ⓐ" && id === "a-rocker.angle");
  assert.equal(cells[0].value, degrees(snapshot.compared.readouts.value("rocker.angle")));
  const [a, b] = [snapshot.compared, snapshot].map(({ readouts }) => readouts.value("rocker.angle", 1));
  assert.equal(views.render(snapshot).cells.find(({ id }) => id === "difference-rocker.angle′").value, b - a);
});
