// Numbers of a mechanism, as printed beside its drawing. They suffice to solve the mechanism on paper.
import { fieldName, measuredAs } from "assur/controls/problems.js";
import { called } from "assur/core/names.js";
import { attempt } from "assur/core/problem.js";
import { lettered } from "assur/core/subscripts.js";
import { withoutExtras } from "assur/state/state.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {Extract<State["document"], { links: readonly unknown[] }>} Linkage
 */

/** Fields of a gear train that matter only under load. */
const LOADED = /^(magnets|bodies|members|load|span_s)\b/;
/**
 * Fields of a linkage that are not listed one by one: dimensions and coordinates, for which `ofPoints` prints its own
 * numbers, and the band within which a dwell is measured, which is no property of the linkage.
 */
const BY_POINTS = /^(links|points)\[|^band$/;
/** Masses and loads of a linkage. They are printed if their words are loaded, as they are once forces have been shown. */
const OF_FORCES = /^(links\[\d+\]\.(mass_kg|inertia)$|(loads|springs|dampers|friction)\[|flywheel$)/;
/** Least number of positions at which their weights matter: fewer positions are met exactly. */
const WEIGHED = 4;
/** Field of a driven shaft. For a multiple of another shaft's speed only `factor` is printed, else all but `factor`. */
const DRIVE = /^drives\[(\d)\]\.(\w+)$/;

/** Keys of the words used instead of a dimension's symbol if the names of its points cannot be subscripts. */
const BY_SYMBOL = Object.freeze({ l: "export.dimension.length", x: "export.dimension.x", y: "export.dimension.y" });

/** Decimals to which numbers are rounded; those from a drawing may have many more. */
const DECIMALS = 6;

/**
 * @param {State} state
 * @param {import("assur/engine.js").Engine} engine
 * @param {Words} words words with the unit of the mechanism's lengths
 * @returns {readonly string[]} every number with its name; the letters after a `_` are a subscript
 */
export function given(state, engine, words) {
  const { document } = state;
  const plain = (attempt(() => engine.functions.numbersOf(withoutExtras(state))).value ?? [])
    .filter(({ field }) => isGiven(field, document, words))
    .map(({ field, value }) => `${fieldName(field, words, document)} = ${measuredAs(field, words.numbers.upTo(value, DECIMALS), words)}`);
  return "links" in document ? [...ofPoints(document, words), ...plain] : plain;
}

/**
 * @param {string} field
 * @param {State["document"]} document
 * @param {Words} words
 * @returns {boolean} whether the number in the field is printed
 */
function isGiven(field, document, words) {
  if ("links" in document) return OF_FORCES.test(field) ? words.has("field.masses.mass") : !BY_POINTS.test(field);
  if ("positions" in document) return !field.endsWith(".weight") || document.positions.length >= WEIGHED;
  if (!("drives" in document)) return true;
  const [, drive, part] = DRIVE.exec(field) ?? [];
  if (drive) return (part === "factor") === Boolean(document.drives[Number(drive)].to);
  return document.loaded || !LOADED.test(field);
}

/**
 * @param {Linkage} linkage
 * @param {Words} words
 * @returns {string[]} distances between the points of each link, coordinates of frame points and traced points, numbers of teeth
 */
function ofPoints({ points, links, frame, gears = [], tracers = [] }, words) {
  const written = (/** @type {number} */ value) => words.numbers.upTo(value, DECIMALS);
  const length = (/** @type {number} */ value) => words.length(written(value));
  const drawn = new Map(points.map(({ name, at }) => [name, at]));
  const said = (/** @type {keyof typeof BY_SYMBOL} */ plain, /** @type {readonly string[]} */ of, /** @type {number} */ value) => {
    const symbol = lettered(plain, of);
    return symbol === plain ? words.text(BY_SYMBOL[plain], { of: of.join("-"), value: length(value) }) : `${symbol} = ${length(value)}`;
  };
  /** @type {Set<string>} each distance once, even if several links share its points */
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
