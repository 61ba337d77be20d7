// What documents are called and where they come from: those of the catalogue have words for it in every language.

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/core/words.js").Words} Words
 */

/**
 * @param {Parameters<Engine["presetOf"]>[0]} state
 * @param {Engine} engine
 * @param {Words} words
 * @returns {string} what the gallery calls it, else its own title, else what its kind is called
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
 * @returns {string} the note of the catalogue on where it comes from; one that is not the catalogue's as it is
 */
export function sourceOf({ origin, source }, engine, words) {
  const { source: noted } = /** @type {{ source?: string }} */ (engine.preset(origin ?? "")?.document ?? {});
  return source && source === noted ? words.text(`source.${origin}`) : source ?? "";
}
