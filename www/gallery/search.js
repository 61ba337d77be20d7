// Search for cards by their names in all languages, by other names, by their groups, by the lines about them, and by class.
import { OTHER_NAMES } from "assur/gallery/other-names.js";

/**
 * Search words of a card. `names`: found by their beginning; `about`: words of the line about it, found by their beginning if at least
 * {@link BEGINNING} letters are typed, or else as a whole; `number`: class, from 1; 0 if there is none.
 * @typedef {{ readonly names: readonly string[], readonly about: readonly string[], readonly number: number }} Findable
 */

/** Roman numerals of classes, indexed by their values, because a class can also be typed as a digit. */
const CLASSES = Object.freeze(["", "i", "ii", "iii", "iv", "v", "vi"]);

/** Least number of typed letters that find a word of a sentence by its beginning. Fewer letters would find too many words. */
const BEGINNING = 4;

/** Matches the word for a class, in any language of the page, as normalised by {@link wordsOf}. */
const CLASS = /^(class|клас)/;

/**
 * Collects the search words of a card.
 * @param {{ names: readonly string[], headings?: readonly string[], about?: readonly string[] }} texts `headings`: of its group
 * @param {string} [highest] class of the card's mechanism, as a Roman numeral
 * @returns {Findable}
 */
export function findable({ names, headings = [], about = [] }, highest = "") {
  const number = Math.max(CLASSES.indexOf(highest.toLowerCase()), 0);
  const own = number > 0 ? [CLASSES[number], String(number)] : [];
  return { names: [...names.flatMap(joined), ...headings.flatMap(wordsOf), ...own], about: about.flatMap(wordsOf), number };
}

/**
 * @param {import("assur/types/file.js").Shelf} shelf
 * @param {string} kind of its document
 * @param {readonly import("assur/core/words.js").Words[]} tables words of all languages
 * @returns {Findable} search words of a mechanism of the catalogue
 */
export function findableMechanism({ id, group, class: highest }, kind, tables) {
  const inAll = (/** @type {string} */ key) => tables.map((table) => table.text(key));
  // The Roman numeral in a group's heading is left out: not all mechanisms of the group have this class.
  const headings = [...inAll(`gallery.group.${group}`).map((text) => text.replace(/[IVX]+/, "")), ...inAll(highest ? "gallery.class" : `kind.${kind}`)];
  return findable({ names: [...inAll(`gallery.${id}`), OTHER_NAMES[id] ?? ""], headings, about: inAll(`about.${id}`) }, highest ?? "");
}

/**
 * Checks whether a card has every word of a query. A Roman numeral must match as a whole, and beside the word “class” it
 * means the class.
 * @param {Findable} card
 * @param {string} query
 */
export function found({ names, about, number }, query) {
  const parts = wordsOf(query);
  return parts.every((part, at) => {
    const value = Math.max(CLASSES.indexOf(part), CLASSES.indexOf(CLASSES[Number(part)] ?? part));
    if (value > 0 && [parts[at - 1], parts[at + 1]].some((next) => next !== undefined && CLASS.test(next))) return value === number;
    const begins = (/** @type {string} */ word) => word.startsWith(part) && !CLASSES.includes(word);
    return names.some((word) => word === part || begins(word)) || about.some((word) => word === part || (part.length >= BEGINNING && begins(word)));
  });
}

/**
 * @param {string} text
 * @returns {string[]} its words, and each two neighbours as one word: a “slider-crank” is also found as “slidercrank”
 */
function joined(text) {
  const words = wordsOf(text);
  return [...words, ...words.slice(1).map((word, before) => words[before] + word)];
}

/** @param {string} text */
function wordsOf(text) {
  // Letters count without their marks, the Ukrainian і as the Latin i, and the English ’s not at all.
  const bare = text.toLowerCase().normalize("NFD").replace(/\p{M}/gu, "").replaceAll("і", "i").replace(/['’]s(?!\p{L})/gu, "");
  return bare.split(/[^\p{L}\p{N}]+/u).filter((word) => word !== "");
}
