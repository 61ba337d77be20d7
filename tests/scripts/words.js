// The words of the page, put together from their sources as the build does: `lang`, what kinds add, what lessons are called.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { Words } from "assur/core/words.js";

export { LANGUAGES } from "assur/core/words.js";

const ROOT = new URL("../../", import.meta.url);

/** @param {string} path */
function read(path) {
  return JSON.parse(readFileSync(new URL(path, ROOT), "utf8"));
}

/**
 * @param {string} lang
 * @returns {Map<string, string>}
 */
export function tableOf(lang) {
  const table = new Map(Object.entries(read(`lang/${lang}.json`)));
  for (const kind of readdirSync(new URL("www/kinds", ROOT))) {
    const path = `www/kinds/${kind}/words.${lang}.json`;
    if (existsSync(new URL(path, ROOT))) for (const [key, text] of Object.entries(read(path))) table.set(key, text);
  }
  for (const lesson of readdirSync(new URL("www/lessons", ROOT))) {
    const { title, line } = read(`www/lessons/${lesson}/words.${lang}.json`);
    table.set(`lessons.${lesson}.title`, title).set(`lessons.${lesson}.line`, line);
  }
  return table;
}

/**
 * @param {string} lang
 * @param {string} [lengths] their unit
 */
export function wordsOf(lang, lengths) {
  return new Words(lang, tableOf(lang), lengths);
}
