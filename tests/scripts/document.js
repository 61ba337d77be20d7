// A document without styles and layout: the elements of the page itself, by happy-dom.
import "assur/tests/window.js";
import { readFileSync } from "node:fs";
import { Window } from "happy-dom";

const PAGE = readFileSync(new URL("../../www/index.html", import.meta.url), "utf8");

const { window } = new Window();
const GIVEN = ["Comment", "CSS", "DOMParser", "Event", "EventTarget", "MutationObserver", "Node", "getComputedStyle", "localStorage", "matchMedia"];
const names = [...GIVEN, ...Object.getOwnPropertyNames(window).filter((name) => /^HTML\w*Element$/.test(name))];
for (const name of names) globalThis[name] = window[name];
globalThis.document = window.document;

/** Empties the page: the elements of `index.html`, as before any script. */
export function clear() {
  const [, body] = /<body[^>]*>([^]*)<\/body>/.exec(PAGE);
  window.document.body.innerHTML = body.replaceAll(/<script[^]*?<\/script>/g, "");
}
clear();

/**
 * @param {ParentNode} root
 * @param {string} [selector]
 * @returns {HTMLElement[]} elements in it that match the selector, by default all, in the order of the document
 */
export function all(root, selector = "*") {
  return [...root.querySelectorAll(selector)];
}

/** A style sheet is there as soon as it is asked for. */
window.document.head.append = (sheet) => sheet.onload?.();
