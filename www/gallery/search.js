// Search for cards by words in their texts and groups, in the page's language and in English, and by class.

/** Roman numerals of classes, indexed by their values, because a class can also be typed as a digit. */
const CLASSES = Object.freeze(["", "i", "ii", "iii", "iv", "v", "vi"]);

/**
 * Collects the search words of a card.
 * @param {readonly string[]} texts
 * @param {string} [highest] class of the card's mechanism, as a Roman numeral
 * @returns {readonly string[]} search words
 */
export function findable(texts, highest = "") {
  const value = CLASSES.indexOf(highest.toLowerCase());
  return [...texts.flatMap(wordsOf), ...(value > 0 ? [CLASSES[value], String(value)] : [])];
}

/**
 * Checks whether every word of a query is a prefix of a search word. A Roman numeral must match as a whole.
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
  // The Ukrainian і counts as the Latin i.
  return text.toLowerCase().replaceAll("і", "i").split(/[^\p{L}\p{N}]+/u).filter((word) => word !== "");
}
