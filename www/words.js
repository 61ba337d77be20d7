// Every word of the page comes from lang/*.json; this file only looks them up.
import { Numbers } from "assur/numbers.js";

/** The languages there are string tables for; the first is the one to fall back to. */
export const LANGUAGES = Object.freeze(["en", "ru", "uk", "kk"]);

/** @type {Map<string, Promise<Words>>} */
const loaded = new Map();

/**
 * @param {readonly string[]} wanted as the browser lists them, best first
 * @returns {string} a language of ours
 */
export function preferredLanguage(wanted) {
  for (const tag of wanted) {
    const lang = tag.toLowerCase().split("-")[0];
    if (LANGUAGES.includes(lang)) return lang;
  }
  return LANGUAGES[0];
}

/** The words and numbers of one language. */
export class Words {
  /** @type {ReadonlyMap<string, string>} */
  #table;

  /**
   * @param {string} lang
   * @param {ReadonlyMap<string, string>} table
   */
  constructor(lang, table) {
    this.lang = lang;
    this.numbers = new Numbers(lang);
    this.#table = table;
  }

  /**
   * @param {string} lang
   * @returns {Promise<Words>}
   */
  static load(lang) {
    let words = loaded.get(lang);
    if (!words) {
      words = fetchTable(lang).then((table) => new Words(lang, table));
      words.catch(() => loaded.delete(lang));
      loaded.set(lang, words);
    }
    return words;
  }

  /**
   * @param {string} key
   * @param {Readonly<Record<string, string>>} [places] what stands in the {places} of the text
   * @returns {string} the text, or the key where there is none
   */
  text(key, places = {}) {
    const text = this.#table.get(key);
    if (text === undefined) return key;
    return text.replace(/\{(\w+)\}/g, (place, name) => (Object.hasOwn(places, name) ? places[name] : place));
  }

  /** @param {string} key */
  has(key) {
    return this.#table.has(key);
  }

  /**
   * Writes the texts that never change into the page, where its elements name them; `data-n` is the {n} of a text.
   * @param {ParentNode} root
   */
  fill(root) {
    const said = (/** @type {Element} */ element, /** @type {string} */ name) =>
      this.text(element.getAttribute(name) ?? "", { n: element.getAttribute("data-n") ?? "" });
    for (const element of root.querySelectorAll("[data-t]")) element.textContent = said(element, "data-t");
    for (const element of root.querySelectorAll("[data-t-label]")) element.setAttribute("aria-label", said(element, "data-t-label"));
    for (const element of root.querySelectorAll("[data-t-title]")) element.setAttribute("title", said(element, "data-t-title"));
  }
}

/**
 * @param {string} lang
 * @returns {Promise<ReadonlyMap<string, string>>}
 */
async function fetchTable(lang) {
  const response = await fetch(import.meta.resolve(`assur/lang/${lang}.json`));
  if (!response.ok) throw new Error(`${response.status} ${lang}.json`);
  return new Map(Object.entries(await response.json()));
}
