// Sums in written form: 2·1 + 1·3 = 5.

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {Readonly<{ freedoms: number, count: number }>} Class `count`: number of pairs with `freedoms` degrees of freedom
 */

/**
 * @param {number} value of W by count, of W by rank, or of q
 * @param {"w" | "rank" | "q"} which
 * @param {Pick<import("assur/kinds/scheme/opening.js").Snapshot, "withheld" | "words">} snapshot
 * @returns {string} the value, or a question mark while a lesson asks for it
 */
export function asked(value, which, { withheld, words }) {
  return withheld.has(`scheme-${which}`) ? "?" : words.numbers.exact(value);
}

/**
 * Returns the actual W and q: by the rank of the constraints in space if position and axis of every pair are known, otherwise by count.
 * @param {Pick<import("assur/kinds/scheme/opening.js").Snapshot["summary"], "mobility" | "redundant" | "space">} summary
 * @returns {Readonly<{ mobility: number, redundant: number, ranked: boolean }>} `ranked`: whether q by rank differs from q by count
 */
export function actual({ mobility, redundant, space }) {
  const judged = space ?? { mobility, redundant };
  return { mobility: judged.mobility, redundant: judged.redundant, ranked: judged.redundant !== redundant };
}

const SMALL = "₀₁₂₃₄₅₆₇₈₉";

/** @param {number} freedoms */
export function symbolOf(freedoms) {
  return `P${SMALL[freedoms]}`;
}

/**
 * @param {readonly number[]} terms
 * @param {Words} words
 * @returns {string} the sum; several terms are written out, as in 2 + 3 = 5
 */
export function sum(terms, { numbers }) {
  const total = numbers.exact(terms.reduce((all, one) => all + one, 0));
  return terms.length > 1 ? `${terms.map(numbers.exact.bind(numbers)).join(" + ")} = ${total}` : total;
}

/**
 * @param {readonly Class[]} classes
 * @param {string} total Σ i·Pᵢ, where Pᵢ is the number of pairs with i freedoms
 * @param {Words} words
 */
export function freedomsOf(classes, total, { numbers }) {
  const terms = classes.map(({ freedoms, count }) => `${numbers.exact(freedoms)}·${numbers.exact(count)}`);
  return terms.length > 0 ? `${terms.join(" + ")} = ${total}` : total;
}

/**
 * Writes the structural formula: the freedoms of all links less the constraints of the pairs, for example 3·3 − 2·4.
 * @param {3 | 6} space freedoms of a link
 * @param {number} links
 * @param {readonly Class[]} classes
 * @param {Words} words
 * @returns {[string, string]} the formula with symbols, and with numbers
 */
export function structural(space, links, classes, { numbers }) {
  const [symbols, values] = [[`${space}n`], [`${space}·${numbers.exact(links)}`]];
  for (const { freedoms, count } of classes) {
    const by = space - freedoms;
    if (by === 0) continue;
    symbols.push(by === 1 ? symbolOf(freedoms) : `${by}${symbolOf(freedoms)}`);
    values.push(by === 1 ? numbers.exact(count) : `${by}·${numbers.exact(count)}`);
  }
  return [symbols.join(" − "), values.join(" − ")];
}
