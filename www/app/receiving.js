// What is dropped on the page or pasted into it: files, and links and texts of other programs.
import { takeFile, takeForeign } from "assur/app/opening.js";

/** @typedef {import("assur/app/page.js").Page} Page */

/** What is dragged is taken where it has one of these. */
const TYPES = Object.freeze(["Files", "text/uri-list", "text/plain"]);

/** @param {Page} page that takes what comes */
export function receive(page) {
  addEventListener("paste", (event) => {
    // What is pasted into a field is the field's.
    if (event.defaultPrevented || writes(event.target) || document.querySelector("dialog[open]")) return;
    if (bring(event.clipboardData, page, false)) event.preventDefault();
  });
  addEventListener("dragover", (event) => {
    if (!writes(event.target) && event.dataTransfer?.types.some((type) => TYPES.includes(type))) event.preventDefault();
  });
  addEventListener("drop", (event) => {
    if (event.defaultPrevented || writes(event.target)) return;
    if (bring(event.dataTransfer, page, true)) event.preventDefault();
  });
}

/**
 * @param {DataTransfer | null} data
 * @param {Page} page
 * @param {boolean} meant whether a text that is none of another program's is said to be none
 * @returns {boolean} whether there was something to take
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
  if (text === "" || !(meant || engine.isForeign(text))) return false;
  page.take(takeForeign(text, null, engine, habits));
  return true;
}

/**
 * @param {EventTarget | null} target
 * @returns {boolean} whether it takes text
 */
function writes(target) {
  if (target instanceof HTMLInputElement) return !["range", "radio", "checkbox", "button"].includes(target.type);
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}
