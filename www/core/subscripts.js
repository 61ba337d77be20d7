// Formulas written in a line, x_PQ, with what belongs below the line below it; texts in which *words* are emphasised.
import { make } from "assur/core/dom.js";

/**
 * @param {string} text
 * @returns {(Node | string)[]} the same, what follows each _ as a subscript
 */
export function withSubscripts(text) {
  const parts = text.split(/_([\p{L}\d]+)/u);
  return parts.map((part, i) => (i % 2 === 1 ? make("sub", {}, [part]) : part));
}

/**
 * @param {string} text
 * @returns {(Node | string)[]} the same, what stands between two * emphasised
 */
export function marked(text) {
  const parts = text.split(/\*([^*]+)\*/);
  return parts.flatMap((part, i) => (i % 2 === 1 ? [make("em", {}, withSubscripts(part))] : withSubscripts(part)));
}
