// A section of the rail for one kind of document.
import { byId, make } from "assur/core/dom.js";

/** @typedef {"dimensions" | "show" | "structure"} Fold a fold of the rail */

/**
 * Adds elements to the end of a fold.
 * @param {Fold} fold
 * @param {readonly HTMLElement[]} content
 */
export function fold(fold, content) {
  byId(`fold-${fold}`, HTMLElement).append(...content);
}

/**
 * @param {import("assur/state/state.js").Kind} kind
 * @param {string} key of the heading's text
 * @param {string} field name by which a lesson includes the section
 * @param {readonly HTMLElement[]} content
 * @returns {HTMLElement} the section, already added to the rail
 */
export function section(kind, key, field, content) {
  const made = make("section", { "data-of": kind, "data-field": field }, [make("h2", { "data-t": key }), ...content]);
  byId("fold-dimensions", HTMLElement).before(made);
  return made;
}
