// Tests of the printed worksheet: the parts of the mechanism and of an open lesson that it shows, and those that it
// withholds.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { all } from "assur/tests/document.js";
import { cellOf } from "assur/controls/shown.js";
import { numberEntries } from "assur/core/names.js";
import { Words } from "assur/core/words.js";
import { FolderLesson } from "assur/lesson/folder.js";
import { wholePresets } from "assur/lesson/offer.js";
import { LESSON } from "assur/lessons/mixer/lesson.js";
import { withDocument } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";
import { sheetOf } from "assur/tests/sheet.js";
import { tableOf } from "assur/tests/words.js";

const OWN = JSON.parse(readFileSync(new URL("../lessons/mixer/words.en.json", import.meta.url), "utf8"));
const words = new Words("en", new Map([...tableOf("en"), ...Object.entries(OWN)]));

// The rail of the mixer sets the same numbers.
numberEntries("wheels", (index) => String(index + 5));

/**
 * Makes the worksheet of a page.
 * @param {string} id of the mechanism
 * @param {boolean} taught whether the lesson of the mixer is open
 * @param {(page: Page) => void} prepare
 */
function print(id = "mixer-a", taught = true, prepare = () => {}) {
  const page = Object.assign(new Page(id, { phi_deg: 75 }), { words });
  prepare(page);
  const steps = taught ? new FolderLesson("mixer", LESSON, {}, page).tell(words).filter(({ question }) => question) : [];
  /** Quantities and read-outs that are withheld from the sheet. */
  let withheld = null;
  const sheet = sheetOf(page, steps, (hidden) => (withheld = hidden));
  return { sheet, steps, withheld };
}

test("text and formula of each step stand before its question", () => {
  const { sheet, steps } = print();
  const items = all(sheet, "li").map(({ textContent }) => textContent);
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

/** Opens a document that belongs to a lesson. */
function show(page, lesson, preset) {
  const { kind, document } = wholePresets(JSON.parse(readFileSync(new URL(`../lessons/${lesson}/presets.json`, import.meta.url), "utf8")))[preset];
  page.choose(kind, document);
  page.model.follow(page.store.get());
}

/** Texts of the rows of the tables. */
function lines(...how) {
  return all(print(...how).sheet, "tr").map(({ textContent }) => textContent);
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

test("an address too long to be read from paper is not printed, and the sheet says so", () => {
  const foot = (/** @type {number} */ length) => {
    const { sheet } = print("mixer-a", false, (page) => Object.assign(page, { address: { link: () => "x".repeat(length) } }));
    const [footer] = all(sheet, "footer");
    return [all(footer, "svg").length > 0, footer.textContent];
  };
  assert.deepEqual(foot(80), [true, "x".repeat(80)]);
  assert.deepEqual(foot(600), [true, words.text("print.code")]);
  assert.deepEqual(foot(2775), [false, words.text("print.long")]);
});

test("the table of values and the status line are printed as they are shown, and nothing of a document before", () => {
  const cell = (id, text, more) => ({ id: `out-${id}`, title: id, text, ...more });
  const show = ({ shown }) => {
    shown.put("values", [{ title: "", cells: [cell("", "φ")] }, { title: "φ₁ crank", cells: [cell("input", "75°")] }]);
    shown.put("curvature", [{ title: "R of C", cells: [cell("C.radius", "none", { wide: true })] }]);
    shown.put("status", [{ title: "swing", cells: [cellOf("swing-rocker", { title: "swing", text: "87.905°" }, { withheld: new Set(["swing-rocker"]), words })] }]);
    shown.put("course", [{ title: "arc", cells: [cell("course-arc", "20°")] }]);
  };
  const { sheet } = print("mixer-a", false, show);
  const rows = all(sheet, "tr").slice(-3);
  assert.deepEqual(rows.map(({ children }) => [...children].map(({ textContent }) => textContent)), [["", "φ"], ["φ₁ crank", "75°"], ["R of C", "none"]]);
  assert.deepEqual(rows.map(({ children }) => children[1].getAttribute("colspan")), ["1", "1", "3"]);
  const said = all(sheet, "p").map(({ textContent }) => textContent);
  assert.ok(said.includes("swing ?") && !/87|arc/.test(sheet.textContent), said.join("; "));
  assert.deepEqual(lines("mobility-1a", false, (page) => {
    show(page);
    page.shown.clear();
  }), []);
});
