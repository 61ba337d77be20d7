// Titles and sources of documents. Those of the catalogue exist in every language.

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/core/words.js").Words} Words
 */

/**
 * @param {Pick<import("assur/state/state.js").State, "kind" | "document">} state
 * @param {Engine} engine
 * @param {Words} words
 * @returns {string} name of the document in the gallery, or else its own title, or else the name of its kind
 */
export function titleOf(state, engine, words) {
  const preset = engine.catalogue.presetOf(state);
  if (preset) return words.text(`gallery.${preset.id}`);
  const { document, kind } = state;
  return ("title" in document && document.title) || words.text(`kind.${kind}`);
}

/**
 * @param {import("assur/state/state.js").Documents["linkage"]} linkage
 * @param {Engine} engine
 * @param {Words} words
 * @returns {string} source of the linkage: that of the catalogue in the reader's language, empty until its words have loaded; any other as it was written
 */
export function sourceOf({ origin, source }, engine, words) {
  const { source: noted } = /** @type {{ source?: string }} */ (engine.catalogue.preset(origin ?? "")?.document ?? {});
  if (!source || source !== noted) return source ?? "";
  const known = `source.${origin}`;
  return words.has(known) ? words.text(known) : "";
}
