// A section of the rail that only one kind has.
import { byId, make } from "assur/core/dom.js";

/**
 * @param {import("assur/state/state.js").Kind} kind
 * @param {string} key of its heading
 * @param {string} field by which a lesson asks for it
 * @param {readonly HTMLElement[]} content
 * @returns {HTMLElement} in its place
 */
export function section(kind, key, field, content) {
  const made = make("section", { "data-of": kind, "data-field": field }, [make("h2", { "data-t": key }), ...content]);
  byId("overlays", HTMLElement).before(made);
  return made;
}
