// Sentences for the problems that the engine reports.
import { degrees } from "assur/core/angles.js";
import { byId, setData } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { called, calledBy, entryNumber, toLine } from "assur/core/names.js";

/**
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {import("assur/state/state.js").State["document"]} Document
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** A field of an entry in a list, such as `wheels[2].z`. */
const ENTRY = /^(\w+)\[(\d+)\]\.(\w+)$/;
/** A dimension of a linkage: `links[5].length`, `links[2].side[1][2]`, `links[2].corner_deg[2]`, `slides[0].offset`, `points[8].x`. */
const DIMENSION = /^(links|slides|points)\[(\d+)\]\.(\w+?)(?:_deg)?((?:\[\d+\])*)$/;
/** A length that is not a dimension of a linkage: `l1` of a mixer, the module of a train, the frame of a synthesis, `x` of a traced point. */
const LENGTH = /^(?:l\d|module|frame|tracers\[\d+\]\.[xy])$/;
/** Keys of the names of links' dimensions. */
const OF_LINKS = Object.freeze(/** @type {Record<string, string>} */ ({ length: "field.links.length", side: "field.links.side", corner: "field.links.corner", mass_kg: "field.masses.mass", inertia: "field.masses.inertia" }));
/** A number in a list, such as `bodies.inertia[2]`, or in a list of pairs. */
const NUMBER = /^([\w.]+)\[(\d+)\](?:\[\d\])?$/;

/** Code of the message that reports the effect of a press. It is not a problem. */
const DONE = "on_link";

/** Keys of the sentences on impossible lengths, by the code of the problem. */
const OF_LENGTHS = Object.freeze(/** @type {Record<string, string>} */ ({ too_large: "problem.too_large_length", too_small: "problem.too_small_length" }));

/** Parameters of a problem that name a link. */
const LINKS = Object.freeze(["link", "shaft", "to", "mesh"]);

/** Parameters of a problem that are lengths, unless the problem's field is a rate or an angle. */
const LENGTHS = Object.freeze(["by", "last"]);
const RATE = /\.rate$/;
const MASS = /\.(mass_kg|inertia)$/;
/** An angle: `links[2].corner_deg[2]`, `wheels[0].centre_line_deg`. */
const ANGLE = /_deg(?:\[|$)/;

/**
 * @param {string} field
 * @param {string} number
 * @param {Words} words
 * @returns {string} the number, with its unit if the field is an angle or a length
 */
export function measuredAs(field, number, words) {
  if (ANGLE.test(field)) return `${number}°`;
  return (DIMENSION.test(field) && !MASS.test(field)) || LENGTH.test(field) ? words.length(number) : number;
}

/**
 * @param {Problem} problem
 * @param {number} value
 * @param {Words} words
 */
function length({ field = "" }, value, words) {
  const said = words.numbers.short(value);
  return RATE.test(field) || ANGLE.test(field) ? measuredAs(field, said, words) : words.length(said);
}

/**
 * @param {string} field
 * @param {Words} words
 * @param {Document | undefined} document that has the field
 * @returns {string} name of the field, with the number of its entry in a list or the name of its shaft, link or point
 */
export function fieldName(field, words, document) {
  const [, of, at, dimension, indices] = DIMENSION.exec(field) ?? [];
  const linkage = document && "links" in document ? document : null;
  if (of === "points") return words.text(`field.points.${dimension}`, { n: linkage?.points[Number(at)]?.name ?? at });
  if (of === "slides") {
    const slide = linkage?.slides?.[Number(at)];
    return words.text("field.slides.offset", { n: slide ? calledBy(slide.link, [toLine(slide.point, slide.line)], words) : at });
  }
  if (of) return ofLink(linkage?.links[Number(at)] ?? { name: at, points: [] }, dimension, indices.match(/\d+/g) ?? [], words);
  const [, numbers, entry] = NUMBER.exec(field) ?? [];
  if (numbers) return words.text(`field.${numbers}`, { n: entryNumber(numbers, Number(entry)) });
  const [, list, index, part] = ENTRY.exec(field) ?? [];
  if (!list) return words.text(`field.${field}`);
  const number = entryNumber(list, Number(index));
  const shaft = list === "drives" && document && "drives" in document ? document.drives[Number(index)]?.shaft : null;
  return words.text(`field.${list}.${part}`, { n: shaft ? `${number} (${called(shaft, words)})` : number });
}

/**
 * @param {{ readonly name: string, readonly points: readonly string[] }} link
 * @param {string} dimension
 * @param {readonly string[]} indices of points of the link, as in the field
 * @param {Words} words
 * @returns {string} name of a dimension of a link: the link and, if it has three points or more, the dimension's points
 */
function ofLink({ name, points }, dimension, indices, words) {
  const isSide = dimension === "length" && points.length > 2;
  const before = dimension === "corner" ? [1, 0] : isSide ? [0, 1] : [];
  const of = [...before, ...indices].map((index) => points[Number(index)] ?? index);
  return words.text(OF_LINKS[isSide ? "side" : dimension], { n: calledBy(name, of, words) });
}

/**
 * @param {Problem} problem
 * @param {Words} words
 * @param {Document} [document]
 * @param {(angle: number) => number} [onto] maps an angle in degrees to the range that the reader sees
 * @returns {string}
 */
export function sentence(problem, words, document, onto) {
  return sentenceFor(keyOf(problem, document), problem, words, document, onto);
}

/**
 * @param {Problem} problem
 * @param {Document} [document]
 * @returns {string} key of the problem's sentence, which depends on the field and the document
 */
function keyOf({ code, field = "" }, document) {
  const isLength = ["length", "side"].includes(DIMENSION.exec(field)?.[3] ?? "");
  const undriven = code === "locked" && document && "links" in document && !document.drivers?.length;
  return (isLength && OF_LENGTHS[code]) || (undriven ? "problem.locked_undriven" : `problem.${code}`);
}

/**
 * @param {Problem} loss part that could not be imported from another program
 * @param {Words} words
 * @returns {string}
 */
export function lossOf(loss, words) {
  return sentenceFor(`import.${loss.code}`, loss, words);
}

/**
 * @param {string} key
 * @param {Problem} problem
 * @param {Words} words
 * @param {Document} [document]
 * @param {(angle: number) => number} [onto]
 */
function sentenceFor(key, problem, words, document, onto = (angle) => angle) {
  if (!words.has(key)) return words.text("problem.unknown", { code: problem.code });
  /** @type {Record<string, string>} */
  const values = {};
  for (const [name, value] of Object.entries(problem)) {
    if (name === "field") values.field = fieldName(String(value), words, document);
    else if (name === "path" && value === ".") values.path = words.text("field.state");
    else if (name === "phi") values.phi = `${words.numbers.upTo(onto(degrees(Number(value))), 3)}°`;
    else if (Array.isArray(value)) values[name] = value.map((one) => (name === "links" ? called(String(one), words) : one)).join(", ");
    else if (LINKS.includes(name)) values[name] = called(String(value), words);
    else if (LENGTHS.includes(name) && typeof value === "number") values[name] = length(problem, value, words);
    else values[name] = typeof value === "number" ? words.numbers.short(value) : String(value);
  }
  return words.text(key, values);
}

export class ProblemView {
  #container = byId("problem", HTMLElement);
  #shown = "";

  /** @param {Snapshot} snapshot */
  render({ problems, words, state, coordinate }) {
    const onto = (/** @type {number} */ angle) => (coordinate.moves === "angle" ? coordinate.onto(angle) : angle);
    const sentences = problems.map((problem) => sentence(problem, words, state.document, onto));
    setData(this.#container, "done", String(problems.every(({ code }) => code === DONE)));
    if (sentences.length > 1) sentences.unshift(words.counted("problems.count", sentences.length));
    const shown = sentences.join("\n");
    if (shown === this.#shown) return;
    this.#shown = shown;
    render(sentences.map((text) => html`<p>${text}</p>`), this.#container);
  }
}
