// What links are called in the reader's language: by the words of the field, else by the names that they have. How entries of
// a list are numbered, and assemblies of a linkage.

/**
 * A number at the end of the name stands where the word has a place {n} for it, else behind the word. Without a number the
 * word stands alone, without the hyphen or space that joins the two.
 * @param {string} link
 * @param {import("assur/core/words.js").Words} words
 */
export function called(link, words) {
  const [, name, space, n] = /^(.*?)( ?)(\d*)$/.exec(link) ?? [link, link, "", ""];
  const key = `link.${name}`;
  if (!words.has(key)) return link;
  if (!words.text(key).includes("{n}")) return `${words.text(key)}${space}${n}`;
  return words.text(key, { n }).replace(/^-|\s$/, "");
}

/**
 * @param {string} formula of a structure, or a term of it: `I(frame,crank) → II₂(rod,slider)`, links that are solved as one joined by `+`
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} the same with what the links are called
 */
export function calledIn(formula, words) {
  return formula.replace(/(?<=[(,+])[^(),+]+(?=[,)+])/g, (link) => called(link, words));
}

/** A dash at which no line breaks. */
const DASH = "\u2060–\u2060";

/**
 * @param {readonly string[]} points
 * @returns {string} the points with dashes between
 */
export function between(points) {
  return points.join(DASH);
}

/**
 * @param {string} link
 * @param {readonly string[]} points
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} what a dimension of a link is called: by the link and points of it
 */
export function calledBy(link, points, words) {
  return [called(link, words), between(points)].filter(Boolean).join(", ");
}

/**
 * @param {string} point
 * @param {readonly string[]} line two points of it
 * @returns {string} from the point to the line
 */
export function toLine(point, line) {
  return `${point} → ${between(line)}`;
}

/**
 * Which of the assemblies at the drawn input moves, and of how many: of those that are known there may be more.
 * @param {Pick<import("assur/engine.js").MotionSummary, "assembled" | "home">} summary
 * @param {import("assur/state/coordinate.js").Coordinate} coordinate
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} empty where that is unknown
 */
export function numbered({ assembled, home }, coordinate, words) {
  if (!assembled) return "";
  const [number, count] = [assembled.number, assembled.count].map((one) => words.numbers.exact(one));
  return words.text(assembled.whole ? "status.assembly_at" : "status.assembly_of_known", { number, count, input: coordinate.short(home, words, 2) });
}

/** @typedef {(index: number) => string} Numbering of the entries of a list in a document, by their place from 0 */

/** @type {Map<string, Numbering>} by the name of the list */
const NUMBERINGS = new Map();

/**
 * A kind of document says how readers number the entries of a list of its own.
 * @param {string} list
 * @param {Numbering} numbering
 */
export function numberEntries(list, numbering) {
  NUMBERINGS.set(list, numbering);
}

/**
 * @param {string} list
 * @param {number} index from 0
 * @returns {string} the number of the entry for readers, who count from 1 where no kind says otherwise
 */
export function entryNumber(list, index) {
  return NUMBERINGS.get(list)?.(index) ?? String(index + 1);
}
