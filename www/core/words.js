// Look-up of the page's texts, which are in lang/*.json and in the folders of lessons.
import { fetched } from "assur/core/fetched.js";
import { Numbers } from "assur/core/numbers.js";
import { measured } from "assur/core/units.js";

/** Languages that have string tables. */
export const LANGUAGES = Object.freeze(["en", "ru", "uk", "kk"]);

/** Units that follow numbers in the texts, as a regular expression. */
const UNITS = "\\{unit\\}|%|px|rpm|об/(?:мин|хв)|айн/мин|(?:min|мин|хв)⁻¹|[NН]·[mм]|m?m|cm|s|kB|MB|м?м(?:/с)?|см|с|[кМ]Б|п[иі]кс";

/**
 * Spaces at which a line may not break: before a unit, on both sides of an equals sign that a number follows, before a
 * dash, and after `fig.`, an initial or a Cyrillic word of one letter.
 */
const HELD = new RegExp(
  [
    `(?<=[\\d}]) (?=(?:${UNITS})(?!\\p{L}))`,
    "(?<=[\\p{L}\\p{N}}′″)]) (?== [\\d{−])",
    "(?<=[\\p{L}\\p{N}}′″)] =) (?=[\\d{−])",
    " (?=—)",
    "(?<=(?<!\\p{L})(?:fig|рис)\\.) ",
    "(?<=(?<!\\p{L})\\p{Lu}\\.) (?=\\p{Lu})",
    "(?<=(?<!\\p{L})\\p{Script=Cyrillic}) (?=[\\p{L}{])",
  ].join("|"),
  "gu",
);

/** A unit with the comma, space or brackets that join it to its quantity. */
const UNIT = /,?[ \u00a0](\{unit\}|\(\{unit\}\))/g;

/** @type {Map<string, Promise<ReadonlyMap<string, string>>>} */
const tables = new Map();

/** Tables of the page, with * for the language. Parts that are loaded on demand add theirs. */
const OF_PAGE = ["lang/*"];

/** Words and numbers of one language, and the unit of lengths. */
export class Words {
  /** @type {ReadonlyMap<string, string>} */
  #table;

  /**
   * @param {string} lang
   * @param {ReadonlyMap<string, string>} table
   * @param {import("assur/types/file.js").LengthUnit} [lengths] unit of lengths
   */
  constructor(lang, table, lengths = "none") {
    this.lang = lang;
    this.numbers = new Numbers(lang);
    this.#table = table;
    this.lengths = lengths;
    /** Unit written beside lengths; empty if lengths have no unit. */
    this.unit = lengths === "none" ? "" : this.text(`unit.${lengths}`);
  }

  /**
   * @param {import("assur/types/file.js").LengthUnit} lengths
   * @returns {Words} the same words with lengths in that unit
   */
  measured(lengths) {
    return lengths === this.lengths ? this : new Words(this.lang, this.#table, lengths);
  }

  /**
   * @param {string} number
   * @returns {string} the number with the unit of lengths
   */
  length(number) {
    return measured(number, this.unit);
  }

  /**
   * @param {string} lang
   * @param {readonly string[]} [paths] of tables in the page, with * for the language; later ones override earlier ones
   * @returns {Promise<Words>}
   */
  static async load(lang, paths = OF_PAGE) {
    const names = paths.map((path) => path.replace("*", lang));
    const entries = (await Promise.all(names.map(table))).flatMap((one) => [...one]);
    // A part may have added its table in the meantime.
    return paths.length > names.length ? Words.load(lang, paths) : new Words(lang, new Map(entries));
  }

  /**
   * Adds a table to those of the page.
   * @param {string} path with * for the language
   * @param {string} lang language in which it is loaded now
   * @returns {Promise<Words>} the words of the page with it
   */
  static async extended(path, lang) {
    await table(path.replace("*", lang));
    if (!OF_PAGE.includes(path)) OF_PAGE.push(path);
    return Words.load(lang);
  }

  /**
   * @param {string} key
   * @param {Readonly<Record<string, string>>} [given] values for the {placeholders} of the text; {unit} is the unit of lengths unless it is given
   * @returns {string} the text, or the key if there is none
   */
  text(key, given = {}) {
    const text = this.#table.get(key);
    if (text === undefined) return key;
    /** @type {Record<string, string>} */
    const values = { unit: this.unit, ...given };
    // If there is no unit, the comma, space or brackets around it are also omitted.
    const bare = values.unit ? text : text.replace(UNIT, "");
    return bare.replace(/\{(\w+)\}/g, (placeholder, name) => (Object.hasOwn(values, name) ? values[name] : placeholder));
  }

  /**
   * Text with a count. Its plural forms are `key.one`, `key.few`, `key.many`, `key.other`, as the language requires.
   * A browser that lacks the language's plural rules uses another language's; `other` stands in for missing forms.
   * @param {string} key
   * @param {number} count value of the placeholder {count}
   * @param {Readonly<Record<string, string>>} [values]
   */
  counted(key, count, values = {}) {
    const form = `${key}.${this.numbers.form(count)}`;
    return this.text(this.has(form) ? form : `${key}.other`, { count: this.numbers.exact(count), ...values });
  }

  /** @param {string} key */
  has(key) {
    return this.#table.has(key);
  }

  /**
   * Writes texts into the elements that give text keys in `data-t` and similar attributes; `data-n` is a text's {n}.
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

/** @param {string} name */
function table(name) {
  let wanted = tables.get(name);
  if (!wanted) {
    wanted = fetchTable(name);
    wanted.catch(() => tables.delete(name));
    tables.set(name, wanted);
  }
  return wanted;
}

/** @param {string} name */
async function fetchTable(name) {
  const response = await fetched(`assur/${name}.json`);
  return new Map(Object.entries(await response.json()).map(([key, text]) => [key, unbroken(text)]));
}

/**
 * @param {string} text
 * @returns {string} the text, with non-breaking spaces where a line may not break
 */
export function unbroken(text) {
  return text.replace(HELD, "\u00a0");
}
