// The words of the page, put together from their sources by the build's own code.
import { fileURLToPath } from "node:url";
import { Words } from "assur/core/words.js";
import { list } from "../../crates/xtask/build/files.js";
import { words } from "../../crates/xtask/build/folders.js";

export { LANGUAGES } from "assur/core/words.js";

const ROOT = fileURLToPath(new URL("../../", import.meta.url));

/**
 * @param {string} lang
 * @returns {Map<string, string>}
 */
export function tableOf(lang) {
  return new Map(Object.entries(words(list(`${ROOT}www`), `${ROOT}lang/${lang}.json`, lang)));
}

/**
 * @param {string} lang
 * @param {string} [lengths] unit of lengths
 */
export function wordsOf(lang, lengths) {
  return new Words(lang, tableOf(lang), lengths);
}
