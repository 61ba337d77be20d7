// What a mechanism is made of, in numbers, as it is printed beside its drawing: with these alone it can be solved on paper.
import { fieldName, measuredAs } from "assur/controls/problems.js";
import { called } from "assur/core/names.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {Extract<State["document"], { links: readonly unknown[] }>} Linkage
 */

/** Numbers of a gear train that say nothing until it is loaded. */
const LOADED = /^(magnets|bodies|load|span_s)\b/;
/** Numbers that a linkage tells by its points. */
const BY_POINTS = /^(links|points)\[/;

/** Decimals of a number: it may be that of a drawing. */
const DECIMALS = 6;

/**
 * @param {State} state
 * @param {import("assur/engine.js").Engine} engine
 * @param {Words} words with the unit of its lengths
 * @returns {readonly string[]} every number with what it is called
 */
export function given({ kind, document, ...rest }, engine, words) {
  const { numbers } = words;
  const idle = "loaded" in document && !document.loaded;
  const plain = engine.numbers(/** @type {State} */ ({ kind, document, ...rest }))
    .filter(({ field }) => !BY_POINTS.test(field) && !(idle && LOADED.test(field)))
    .map(({ field, value }) => `${fieldName(field, words, document)} = ${measuredAs(field, numbers.upTo(value, DECIMALS), words)}`);
  return "links" in document ? [...ofPoints(document, words), ...plain] : plain;
}

/**
 * @param {Linkage} linkage
 * @param {Words} words
 * @returns {string[]} distances of the points of each link, places of those of the frame, teeth
 */
function ofPoints({ points, links, frame, gears = [] }, words) {
  const written = (/** @type {number} */ value) => words.numbers.upTo(value, DECIMALS);
  const drawn = new Map(points.map(({ name, at }) => [name, at]));
  /** @type {Map<string, number>} */
  const lengths = new Map();
  for (const { points: own, shape, length } of links) {
    const places = own.map((name, i) => shape?.[i] ?? drawn.get(name) ?? [0, 0]);
    for (const [j, [x, y]] of places.entries()) {
      for (const [i, [x0, y0]] of places.slice(0, j).entries()) lengths.set(`${own[i]}-${own[j]}`, length ?? Math.hypot(x - x0, y - y0));
    }
  }
  return [
    ...[...lengths].map(([of, value]) => words.text("export.dimension.length", { of, value: words.length(written(value)) })),
    ...frame.flatMap((of) => (drawn.get(of) ?? []).map((value, axis) => words.text(axis === 0 ? "export.dimension.x" : "export.dimension.y", { of, value: words.length(written(value)) }))),
    ...new Set(gears.flatMap(({ links: pair, teeth }) => pair.map((link, i) => `${called(link, words)}: z = ${written(teeth[i])}`))),
  ];
}
