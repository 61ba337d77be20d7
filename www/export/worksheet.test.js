// The worksheet that is printed: what it has of an open lesson, and what it keeps to itself.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { found } from "assur/tests/document.js";
import { Context } from "assur/tests/canvas.js";
import { Words } from "assur/core/words.js";
import { printWorksheets } from "assur/export/worksheet.js";
import { FolderLesson } from "assur/lesson/folder.js";
import { LESSON } from "assur/lessons/mixer/lesson.js";
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

for (const id of ["mechanism", "charts"]) found.set(id, new HTMLCanvasElement());

/** A page at the first step of the lesson of the mixer, and what is printed of it. */
function print() {
  const picture = { size: { width: 10, height: 10 }, paint() {} };
  /** What is withheld while the sheet is made. */
  let withheld = null;
  const page = Object.assign(new Page("mixer-a", { phi_deg: 75 }), {
    words,
    mechanism: { cropped: () => picture },
    chart: { size: picture.size, panels: [], paint() {} },
    address: { link: () => "https://assur.test/#mixer-a" },
    posed: (hidden, make) => {
      withheld = hidden;
      return make();
    },
  });
  const steps = new FolderLesson("mixer", LESSON, {}, page).tell(words).filter(({ question }) => question);
  page.lesson = { steps: () => steps };
  page.engine.code = () => null;
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

test("what tells the answer of any question is withheld, whichever step is open", () => {
  assert.deepEqual([...print().withheld], ["ratio", "swing-wheel5", "time-ratio"]);
});

test("no question speaks of a button", () => {
  for (const { question } of print().steps) assert.doesNotMatch(question.text, /Show it/);
});
