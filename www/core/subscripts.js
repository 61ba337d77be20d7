// Marked texts: letters and digits after a _, as in x_PQ, are written as a subscript, and *words* between asterisks with emphasis.
import { make } from "assur/core/dom.js";

/** Name of a point that is short enough for a subscript. */
const LETTER = /^\p{L}\d{0,2}$/u;

/**
 * Symbol with the names of points as its subscript, if each name is short enough, or else the symbol alone.
 * @param {string} symbol
 * @param {readonly string[]} points
 */
export function lettered(symbol, points) {
  return points.every((point) => LETTER.test(point)) ? `${symbol}_${points.join("")}` : symbol;
}

/**
 * @param {string} text
 * @returns {(Node | string)[]} the text, with the letters and digits after each _ as a subscript
 */
export function withSubscripts(text) {
  const parts = text.split(/_([\p{L}\d]+)/u);
  return parts.map((part, i) => (i % 2 === 1 ? make("sub", {}, [part]) : part));
}

/**
 * Writes a text with its subscripts if it differs from the present one.
 * @param {Element} element
 * @param {string} text
 */
export function writeSubscripted(element, text) {
  const parts = withSubscripts(text);
  const plain = parts.map((part) => (typeof part === "string" ? part : part.textContent)).join("");
  if (element.textContent !== plain) element.replaceChildren(...parts);
}

/**
 * @param {string} text
 * @returns {(Node | string)[]} the text, with words between two asterisks emphasised, and with subscripts
 */
export function marked(text) {
  const parts = text.split(/\*([^*]+)\*/);
  return parts.flatMap((part, i) => (i % 2 === 1 ? [make("em", {}, withSubscripts(part))] : withSubscripts(part)));
}
