// What links are called in the reader's language: by the words of the field, else by the names that they have.

/**
 * @param {string} link
 * @param {import("assur/core/words.js").Words} words
 */
export function called(link, words) {
  const [, name, n] = /^(.*?)(\d*)$/.exec(link) ?? [link, link, ""];
  return words.has(`link.${name}`) ? words.text(`link.${name}`, { n }) : link;
}
