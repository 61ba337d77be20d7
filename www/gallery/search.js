// Finds cards by words: names in the language of the page and in English, groups, classes.

/** Numerals of classes with their values: typed on a keyboard without Latin letters, too. */
const CLASSES = Object.freeze(["", "i", "ii", "iii", "iv", "v", "vi"]);

/**
 * What a card is found by.
 * @param {readonly string[]} texts
 * @param {string} [highest] the class of its mechanism
 * @returns {readonly string[]} words
 */
export function findable(texts, highest = "") {
  const value = CLASSES.indexOf(highest.toLowerCase());
  return [...texts.flatMap(wordsOf), ...(value > 0 ? [CLASSES[value], String(value)] : [])];
}

/**
 * Whether every word of a query begins one of the words; the numeral of a class is a whole word.
 * @param {readonly string[]} words
 * @param {string} query
 */
export function found(words, query) {
  return wordsOf(query).every((part) =>
    words.some((word) => word === part || (word.startsWith(part) && !CLASSES.includes(word))),
  );
}

/** @param {string} text */
function wordsOf(text) {
  // Of two alphabets, one letter.
  return text.toLowerCase().replaceAll("і", "i").split(/[^\p{L}\p{N}]+/u).filter((word) => word !== "");
}
