// What a mechanism is made of, in numbers, as it is printed beside its drawing: with these alone it can be solved on paper.
import { fieldName, measuredAs } from "assur/controls/problems.js";
import { called } from "assur/core/names.js";
import { attempt } from "assur/core/problem.js";
import { lettered } from "assur/core/subscripts.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {Extract<State["document"], { links: readonly unknown[] }>} Linkage
 */

/** Numbers of a gear train that say nothing until it is loaded. */
const LOADED = /^(magnets|bodies|members|load|span_s)\b/;
/** Numbers that a linkage tells by its points, and the tolerance of its dwell, which is none of it. */
const BY_POINTS = /^(links|points)\[|^band$/;
/** With as many positions as there are lengths to choose, each is met whatever its weight. */
const WEIGHED = 4;
/** A number of a shaft: it has a factor where it is tied, a speed where it is not. */
const DRIVE = /^drives\[(\d)\]\.(\w+)$/;

/** The words for what is given by points, by its symbol. */
const BY_SYMBOL = Object.freeze({ l: "export.dimension.length", x: "export.dimension.x", y: "export.dimension.y" });

/** Decimals of a number: it may be that of a drawing. */
const DECIMALS = 6;

/**
 * @param {State} state
 * @param {import("assur/engine.js").Engine} engine
 * @param {Words} words with the unit of its lengths
 * @returns {readonly string[]} every number with what it is called; what follows a _ stands below the line
 */
export function given(state, engine, words) {
  const { document } = state;
  const plain = (attempt(() => engine.numbers(state)).value ?? [])
    .filter(({ field }) => isGiven(field, document))
    .map(({ field, value }) => `${fieldName(field, words, document)} = ${measuredAs(field, words.numbers.upTo(value, DECIMALS), words)}`);
  return "links" in document ? [...ofPoints(document, words), ...plain] : plain;
}

/**
 * @param {string} field
 * @param {State["document"]} document
 * @returns {boolean} whether its number says something of the mechanism
 */
function isGiven(field, document) {
  if ("links" in document) return !BY_POINTS.test(field);
  if ("positions" in document) return !field.endsWith(".weight") || document.positions.length >= WEIGHED;
  if (!("drives" in document)) return true;
  const [, drive, part] = DRIVE.exec(field) ?? [];
  if (drive) return (part === "factor") === Boolean(document.drives[Number(drive)].to);
  return document.loaded || !LOADED.test(field);
}

/**
 * @param {Linkage} linkage
 * @param {Words} words
 * @returns {string[]} distances of the points of each link, places of those of the frame and of what is traced, teeth
 */
function ofPoints({ points, links, frame, gears = [], tracers = [] }, words) {
  const written = (/** @type {number} */ value) => words.numbers.upTo(value, DECIMALS);
  const length = (/** @type {number} */ value) => words.length(written(value));
  const drawn = new Map(points.map(({ name, at }) => [name, at]));
  const said = (/** @type {keyof typeof BY_SYMBOL} */ plain, /** @type {readonly string[]} */ of, /** @type {number} */ value) => {
    const symbol = lettered(plain, of);
    return symbol === plain ? words.text(BY_SYMBOL[plain], { of: of.join("-"), value: length(value) }) : `${symbol} = ${length(value)}`;
  };
  /** @type {Set<string>} of points that several links share the distance is said once */
  const lengths = new Set();
  for (const { points: own, shape, length: fixed } of links) {
    const places = own.map((name, i) => shape?.[i] ?? drawn.get(name) ?? [0, 0]);
    for (const [j, [x, y]] of places.entries()) {
      for (const [i, [x0, y0]] of places.slice(0, j).entries()) lengths.add(said("l", [own[i], own[j]], fixed ?? Math.hypot(x - x0, y - y0)));
    }
  }
  return [
    ...lengths,
    ...frame.flatMap((of) => (drawn.get(of) ?? []).map((value, axis) => said(axis === 0 ? "x" : "y", [of], value))),
    ...tracers.map(({ name, link, at: [x, y] }) => `${name} (${called(link, words)}): x = ${length(x)}, y = ${length(y)}`),
    ...new Set(gears.flatMap(({ links: pair, teeth }) => pair.map((link, i) => `${called(link, words)}: z = ${written(teeth[i])}`))),
  ];
}
