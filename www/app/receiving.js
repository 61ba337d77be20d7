// Content dropped on the page or pasted into it: files, and URLs or texts of other programs.
import { isForeign, takeFile, takeForeign } from "assur/app/opening.js";
import { isTyped } from "assur/core/typed.js";

/** @typedef {import("assur/app/page.js").Page} Page */

/** Types of dragged content that the page takes. */
const TYPES = Object.freeze(["Files", "text/uri-list", "text/plain"]);

/** @param {Page} page page that takes the content */
export function receive(page) {
  addEventListener("paste", (event) => {
    // A field keeps what is pasted into it.
    if (event.defaultPrevented || isTyped(event.target) || document.querySelector("dialog[open]")) return;
    if (bring(event.clipboardData, page, false)) event.preventDefault();
  });
  addEventListener("dragover", (event) => {
    if (!isTyped(event.target) && event.dataTransfer?.types.some((type) => TYPES.includes(type))) event.preventDefault();
  });
  addEventListener("drop", (event) => {
    if (event.defaultPrevented || isTyped(event.target)) return;
    if (bring(event.dataTransfer, page, true)) event.preventDefault();
  });
}

/**
 * @param {DataTransfer | null} data
 * @param {Page} page
 * @param {boolean} meant whether to show a message if the text is not in the format of a known program
 * @returns {boolean} whether the page takes the content
 */
function bring(data, page, meant) {
  const { engine } = page;
  const habits = page.ofNow();
  const file = data?.files[0];
  if (file) {
    page.take(takeFile(file, engine, habits));
    return true;
  }
  const text = data?.getData("text/plain") ?? "";
  if (text === "" || !(meant || isForeign(text, engine))) return false;
  page.take(takeForeign(text, null, engine, habits));
  return true;
}
