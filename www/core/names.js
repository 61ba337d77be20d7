// What links are called in the reader's language: by the words of the field, else by the names that they have.

/**
 * @param {string} link
 * @param {import("assur/core/words.js").Words} words
 */
export function called(link, words) {
  const [, name, n] = /^(.*?)(\d*)$/.exec(link) ?? [link, link, ""];
  if (!words.has(`link.${name}`)) return link;
  const said = words.text(`link.${name}`, { n });
  return said.endsWith(n) ? said : said + n;
}

/**
 * @param {string} formula of a structure, or a term of it: `I(frame,crank) → II₂(rod,slider)`
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} the same with what the links are called
 */
export function calledIn(formula, words) {
  return formula.replace(/(?<=[(,])[^(),]+(?=[,)])/g, (link) => called(link, words));
}
