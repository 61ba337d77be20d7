// Titles and sources of documents; those of the catalogue are in every language.

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/core/words.js").Words} Words
 */

/**
 * @param {Parameters<Engine["presetOf"]>[0]} state
 * @param {Engine} engine
 * @param {Words} words
 * @returns {string} its name in the gallery, or else its own title, or else the name of its kind
 */
export function titleOf(state, engine, words) {
  const preset = engine.presetOf(state);
  if (preset) return words.text(`gallery.${preset.id}`);
  const { document, kind } = state;
  return ("title" in document && document.title) || words.text(`kind.${kind}`);
}

/**
 * @param {import("assur/state/state.js").Documents["linkage"]} linkage
 * @param {Engine} engine
 * @param {Words} words
 * @returns {string} its source: that of the catalogue in the reader's language, any other as it is
 */
export function sourceOf({ origin, source }, engine, words) {
  const { source: noted } = /** @type {{ source?: string }} */ (engine.preset(origin ?? "")?.document ?? {});
  return source && source === noted ? words.text(`source.${origin}`) : source ?? "";
}
