// The words of the page, those that load later included, put together from their sources by the build's own code.
import { readFileSync } from "node:fs";
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
  const sources = list(`${ROOT}www`);
  const first = words(sources, `${ROOT}lang/${lang}.json`, lang);
  const later = [...sources.keys()].filter((name) => name.endsWith(`/later.${lang}.json`));
  const tables = [first, ...later.map((name) => JSON.parse(readFileSync(sources.get(name) ?? "", "utf8")))];
  return new Map(tables.flatMap((table) => Object.entries(table)));
}

/**
 * @param {string} lang
 * @param {string} [lengths] unit of lengths
 */
export function wordsOf(lang, lengths) {
  return new Words(lang, tableOf(lang), lengths);
}
