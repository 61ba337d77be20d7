// The list of friction: in the hinges at a point, or in the slides of a link.
import { make } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { card, writeReasons } from "assur/forces/card.js";
import { linkageOf, putList, without } from "assur/forces/change.js";
import { Fields, replaced } from "assur/forces/fields.js";

/**
 * @typedef {import("assur/state/state.js").LinkageDocument} Document
 * @typedef {import("assur/types/file.js").FrictionDocument} Friction
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Coefficient of new friction. */
const USUAL = 0.1;
/** Radius of a new pin, as a part of the length of the first link. */
const PIN = 0.05;

export class FrictionList {
  name = /** @type {const} */ ("friction");
  element = make("div", { id: "friction" });
  #page;
  /** @type {Fields | null} */
  #fields = null;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
  }

  /** @param {Document} document */
  shape(document) {
    return [placesOf(document), list(document).map(({ hinge, slide }) => [hinge, slide])];
  }

  /**
   * @param {Document} document
   * @param {Words} words
   */
  build(document, words) {
    const fields = new Fields(this.#page, words);
    this.#fields = fields;
    const cards = list(document).map((one, i) => this.#card(document, one, i, fields, words));
    replaced(this.element, [...cards, fields.button("friction-add", "forces.friction.add", () => this.#add())]);
  }

  /**
   * @param {ReadonlySet<string>} wrong fields at fault
   * @param {(index: number) => string} reason why an entry is refused; empty if it is not
   */
  show(wrong, reason) {
    this.#fields?.show(wrong);
    writeReasons(this.element, this.name, list(linkageOf(this.#page)).length, reason);
  }

  #add() {
    const document = linkageOf(this.#page);
    const taken = new Set(list(document).map(keyOf));
    const place = placesOf(document).find((one) => !taken.has(keyOf(one))) ?? placesOf(document)[0];
    if (place) this.#page.history.step(() => putList(this.#page, "friction", (all) => [...all, fresh(document, place)]));
  }

  /**
   * @param {number} i
   * @param {Partial<Friction>} change; an undefined field is removed
   */
  #put(i, change) {
    putList(this.#page, "friction", (all) => all.map((one, k) => (k === i ? without({ ...one, ...change }) : one)));
  }

  /**
   * @param {Document} document
   * @param {Friction} one
   * @param {number} i
   * @param {Fields} fields
   * @param {Words} words
   */
  #card(document, one, i, fields, words) {
    const now = () => list(linkageOf(this.#page))[i] ?? one;
    const name = (/** @type {Place} */ { hinge, slide }) => words.text(hinge ? "forces.friction.hinge" : "forces.friction.slide", { name: hinge ?? called(slide ?? "", words) });
    const places = placesOf(document);
    const options = places.map((place) => /** @type {const} */ ([keyOf(place), name(place)]));
    const move = (/** @type {string} */ key) => {
      const place = places.find((other) => keyOf(other) === key);
      if (place) this.#page.history.step(() => this.#put(i, { ...fresh(linkageOf(this.#page), place), coefficient: now().coefficient }));
    };
    const n = words.numbers.exact(i + 1);
    const number = (/** @type {"coefficient" | "radius" | "length"} */ of, /** @type {string} */ symbol, /** @type {import("assur/forces/fields.js").Unit} */ unit) =>
      fields.number(`friction[${i}].${of}`, { symbol, unit, n }, () => now()[of] ?? 0, (value) => this.#put(i, { [of]: value }));
    const content = [
      fields.choice(`friction-${i}-place`, "forces.friction.place", options, () => keyOf(now()), move),
      number("coefficient", "f", "none"),
      one.hinge ? number("radius", "r", "length") : number("length", "l", "length"),
    ];
    const remove = () => this.#page.history.step(() => putList(this.#page, "friction", (all) => all.filter((_, k) => k !== i)));
    return card({ list: this.name, i, title: name(one) }, content, fields, remove);
  }
}

/**
 * @param {Document} document
 * @returns {readonly Friction[]}
 */
function list(document) {
  return document.friction ?? [];
}

/** @typedef {{ hinge?: string | null, slide?: string | null }} Place a hinge, or a sliding link */

/**
 * @param {Document} document
 * @returns {Place[]} hinges and sliding links
 */
function placesOf({ points, links, frame, slides = [] }) {
  const bodies = [frame, ...links.map((link) => link.points)];
  const hinges = points.map(({ name }) => name).filter((name) => bodies.filter((own) => own.includes(name)).length > 1);
  return [...hinges.map((hinge) => ({ hinge })), ...new Set(slides.map(({ link }) => link))].map((place) => (typeof place === "string" ? { slide: place } : place));
}

/** @param {Place} place */
function keyOf({ hinge, slide }) {
  return hinge ? `hinge ${hinge}` : `slide ${slide}`;
}

/**
 * @param {Document} document
 * @param {Place} place
 * @returns {Friction} usual friction there; a pin has a radius, a block no known length
 */
function fresh({ points, links }, { hinge, slide }) {
  if (!hinge) return { slide, hinge: undefined, radius: undefined, coefficient: USUAL };
  const ends = links[0]?.points.map((name) => points.find((point) => point.name === name)?.at ?? [0, 0]) ?? [];
  const [[x, y], [u, v]] = [ends[0] ?? [0, 0], ends[1] ?? [1, 0]];
  return { hinge, slide: undefined, length: undefined, coefficient: USUAL, radius: Number((PIN * Math.hypot(u - x, v - y)).toPrecision(1)) };
}
