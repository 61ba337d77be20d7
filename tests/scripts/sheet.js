// Printing of the worksheet of a page without a drawing.
import { Context } from "assur/tests/canvas.js";
import "assur/tests/document.js";
import { printWorksheets } from "assur/export/worksheet.js";
import { happen } from "assur/tests/window.js";

globalThis.OffscreenCanvas = class OffscreenCanvas {
  getContext() {
    return Object.assign(new Context(), { getImageData: () => ({ data: [0, 0, 0, 255] }) });
  }
};

/**
 * @param {import("assur/tests/page.js").Page} page
 * @param {readonly import("assur/lesson/panel.js").Told[]} steps of the open lesson
 * @param {(hidden: readonly string[]) => void} pose called before the sheet is made, with the quantities that it withholds
 * @returns {HTMLElement} the worksheet
 */
export function sheetOf(page, steps = [], pose = () => {}) {
  const picture = { size: { width: 10, height: 10 }, paint() {} };
  Object.assign(page, {
    lesson: { steps: () => steps, onPaper: () => [] },
    words: page.words.measured(page.engine.lengths),
    mechanism: { cropped: () => picture, fit() {} },
    chart: { size: picture.size, panels: [], paint() {} },
    address: page.address ?? { link: () => "https://assur.test/#mixer-a" },
    posed: (hidden, make) => {
      pose(hidden);
      return make();
    },
  });
  printWorksheets(page);
  happen("beforeprint");
  return globalThis.document.body.lastElementChild;
}
