// The worksheet that is printed: what it has of the mechanism and of an open lesson, and what it keeps to itself.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { found } from "assur/tests/document.js";
import { withhold } from "assur/controls/readout.js";
import { make } from "assur/core/dom.js";
import { numberEntries } from "assur/core/names.js";
import { Context } from "assur/tests/canvas.js";
import { Words } from "assur/core/words.js";
import { printWorksheets } from "assur/export/worksheet.js";
import { FolderLesson } from "assur/lesson/folder.js";
import { wholePresets } from "assur/lesson/offer.js";
import { LESSON } from "assur/lessons/mixer/lesson.js";
import { withDocument } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { happen } from "assur/tests/window.js";
import { tableOf } from "assur/tests/words.js";

const OWN = JSON.parse(readFileSync(new URL("../lessons/mixer/words.en.json", import.meta.url), "utf8"));
const words = new Words("en", new Map([...tableOf("en"), ...Object.entries(OWN)]));

globalThis.OffscreenCanvas = class OffscreenCanvas {
  getContext() {
    return Object.assign(new Context(), { getImageData: () => ({ data: [0, 0, 0, 255] }) });
  }
};

// As the rail of the mixer does.
numberEntries("wheels", (index) => String(index + 5));
for (const id of ["mechanism", "charts"]) found.set(id, new HTMLCanvasElement());

/**
 * A page, and what is printed of it.
 * @param {string} id of the mechanism
 * @param {boolean} taught whether the lesson of the mixer is open
 * @param {(page: Page) => void} prepare
 */
function print(id = "mixer-a", taught = true, prepare = () => {}) {
  const picture = { size: { width: 10, height: 10 }, paint() {} };
  /** What is withheld while the sheet is made. */
  let withheld = null;
  const opened = new Page(id, { phi_deg: 75 });
  const page = Object.assign(opened, {
    words: words.measured(opened.engine.lengths),
    mechanism: { cropped: () => picture, fit() {} },
    chart: { size: picture.size, panels: [], paint() {} },
    address: { link: () => "https://assur.test/#mixer-a" },
    posed: (hidden, make) => {
      withheld = hidden;
      return make();
    },
  });
  prepare(page);
  const steps = taught ? new FolderLesson("mixer", LESSON, {}, page).tell(words).filter(({ question }) => question) : [];
  page.lesson = { steps: () => steps, onPaper: () => [] };
  globalThis.document.body.replaceChildren();
  printWorksheets(page);
  happen("beforeprint");
  const sheet = globalThis.document.body.children.at(-1);
  return { sheet, steps, withheld };
}

test("text and formula of each step stand before its question", () => {
  const { sheet, steps } = print();
  const items = sheet.all.filter(({ tagName }) => tagName === "LI").map(({ textContent }) => textContent);
  assert.equal(items.length, steps.filter(({ question }) => question).length);
  for (const [i, item] of items.entries()) {
    const { title, text, question } = steps[i];
    const parts = [title, ...text.split("\n"), question.text].map((part) => item.indexOf(part.replace(/[*_]/g, "").slice(0, 40)));
    assert.ok(parts.every((at, k) => at >= 0 && (k === 0 || at > parts[k - 1])), `${item}: ${parts}`);
  }
  assert.match(items[4], /K = Δφ₁ \/ \(360° − Δφ₁\)/);
});

test("values that give an answer away are withheld, whichever step is open", () => {
  assert.deepEqual([...print().withheld], ["ratio", "swing-wheel5", "time-ratio"]);
});

test("no question speaks of a button", () => {
  for (const { question } of print().steps) assert.doesNotMatch(question.text, /Show it/);
});

/** Shows what a lesson has of its own. */
function show(page, lesson, preset) {
  const { kind, document } = wholePresets(JSON.parse(readFileSync(new URL(`../lessons/${lesson}/presets.json`, import.meta.url), "utf8")))[preset];
  page.choose(kind, document);
  page.model.follow(page.store.get());
}

/** Each line of the tables. */
function lines(...how) {
  return print(...how).sheet.all.filter(({ tagName }) => tagName === "TR").map(({ textContent }) => textContent);
}

for (const [id, count, wanted] of [
  ["class4-dwell", 19, "xH = 4.07"],
  ["mixer-a", 8, "Wheel 5, centre-line angle = −40°"],
  ["synthesis family", 6, "Position 2, direction of the driver φ₃ = 60°"],
  ["mobility-1a", 0],
]) {
  test(`what is given of ${id}, and nothing of a search or a view, is printed`, () => {
    const [lesson, preset] = id.split(" ");
    const said = preset ? lines("mixer-a", false, (page) => show(page, lesson, preset)) : lines(id, false);
    assert.equal(said.length, count, said.join("; "));
    assert.ok(!wanted || said.some((line) => line.startsWith(wanted)), said.join("; "));
    assert.doesNotMatch(said.join("; "), /target|tolerance|weight/i);
  });
}

test("beside a drawing stand the numbers that it is drawn with, not one that is refused", () => {
  const said = lines("mixer-a", false, ({ store, model }) => {
    store.update((state) => withDocument(state, { l1: 50 }));
    model.follow(store.get());
    assert.ok(!model.accepted);
  });
  assert.match(said[0], /^Crank l₁ = 0\.37(?!\d)/);
});

/** Has the page say what a selector finds. */
function saying(found, work) {
  const { querySelectorAll } = document;
  document.querySelectorAll = (selector) => found[Object.keys(found).find((part) => selector.includes(part))] ?? [];
  try {
    return work();
  } finally {
    document.querySelectorAll = querySelectorAll;
  }
}

test("values of the mechanism that was shown before are not printed with a scheme", () => {
  const row = make("tr", {}, [make("th", {}, ["φ₁"]), make("td", {}, ["75°"])]);
  assert.deepEqual(saying({ "#readouts": [row] }, () => lines("mobility-1a", false)), []);
  assert.equal(saying({ "#readouts": [row] }, () => lines("mixer-a", false)).at(-1), "φ₁75°");
});

test("what is withheld is a question mark alone", () => {
  const [cell, output] = [make("td"), make("dd")];
  for (const one of [cell, output]) withhold(one, words);
  const found = { "#readouts": [make("tr", {}, [make("th", {}, ["μ"]), cell])], "#status": [Object.assign(make("div", {}, [make("dt", {}, ["swing"]), output]), { matches: () => false })] };
  const { sheet } = saying(found, () => print("mixer-a", false));
  const said = sheet.all.map(({ textContent }) => textContent);
  assert.ok(said.includes("μ?") && said.includes("swing ?"), said.join("; "));
});
