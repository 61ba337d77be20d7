// A document without styles and layout, which happy-dom makes of the elements of the page.
import "assur/tests/window.js";
import { readFileSync } from "node:fs";
import { Window } from "happy-dom";

const PAGE = readFileSync(new URL("../../www/index.html", import.meta.url), "utf8");

const { window } = new Window();
const GIVEN = ["Comment", "CSS", "DOMParser", "Event", "EventTarget", "MutationObserver", "Node", "getComputedStyle", "localStorage", "matchMedia"];
const names = [...GIVEN, ...Object.getOwnPropertyNames(window).filter((name) => /^HTML\w*Element$/.test(name))];
for (const name of names) globalThis[name] = window[name];
globalThis.document = window.document;

/** Resets the document to the elements of `index.html`, as they are before any script runs. */
export function clear() {
  const [, body] = /<body[^>]*>([^]*)<\/body>/.exec(PAGE);
  window.document.body.innerHTML = body.replaceAll(/<script[^]*?<\/script>/g, "");
}
clear();

/**
 * @param {ParentNode} root
 * @param {string} [selector]
 * @returns {HTMLElement[]} elements in the root that match the selector, by default all, in the order of the document
 */
export function all(root, selector = "*") {
  return [...root.querySelectorAll(selector)];
}

/** Style sheets count as loaded as soon as they are added. */
window.document.head.append = (sheet) => sheet.onload?.();
