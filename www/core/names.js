// Names of links in the reader's language, and numbers of list entries and assemblies.

/**
 * Name of a link in the reader's language, or the link's own name if the words lack it. The link's number replaces {n} in the word, or
 * else follows the word. Without a number, the hyphen or space that would join word and number is omitted.
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
 * @param {string} formula structural formula or one term: `I(frame,crank) → II₂(rod,slider)`; `+` joins links of one body
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} the formula with the names of its links in the reader's language
 */
export function calledIn(formula, words) {
  return formula.replace(/(?<=[(,+])[^(),+]+(?=[,)+])/g, (link) => called(link, words));
}

/** A dash at which no line breaks. */
const DASH = "\u2060–\u2060";

/**
 * @param {readonly string[]} points
 * @returns {string} the names of the points, with dashes between them
 */
export function between(points) {
  return points.join(DASH);
}

/**
 * @param {string} link
 * @param {readonly string[]} points
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} name of a dimension of a link: the link and the points of the dimension
 */
export function calledBy(link, points, words) {
  return [called(link, words), between(points)].filter(Boolean).join(", ");
}

/**
 * @param {string} point
 * @param {readonly string[]} line two points on the line
 * @returns {string} the point and the line with an arrow between them
 */
export function toLine(point, line) {
  return `${point} → ${between(line)}`;
}

/**
 * Text that gives the number of the moving assembly at the drawn input, and the count of all assemblies or, if there may be more, of those known.
 * @param {Pick<import("assur/state/details.js").MotionSummary, "home" | "assembled">} summary
 * @param {import("assur/state/coordinate.js").Coordinate} coordinate
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} empty if the number is unknown
 */
export function numbered({ assembled, home }, coordinate, words) {
  if (!assembled) return "";
  const [number, count] = [assembled.number, assembled.count].map((one) => words.numbers.exact(one));
  return words.text(assembled.complete ? "status.assembly_at" : "status.assembly_of_known", { number, count, input: coordinate.short(home, words, 2) });
}

/** @typedef {(index: number) => string} Numbering gives the number shown for an entry of a list; `index` starts at 0 */

/** @type {Map<string, Numbering>} by the name of the list */
const NUMBERINGS = new Map();

/**
 * Sets the numbers shown for the entries of a list.
 * @param {string} list
 * @param {Numbering} numbering
 */
export function numberEntries(list, numbering) {
  NUMBERINGS.set(list, numbering);
}

/**
 * @param {string} list
 * @param {number} index from 0
 * @returns {string} the number shown for the entry; numbers start at 1 unless {@link numberEntries} sets others
 */
export function entryNumber(list, index) {
  return NUMBERINGS.get(list)?.(index) ?? String(index + 1);
}
