// The rail of a linkage: its driver, lengths, fixed pivots, assembly.
import { NumberRow } from "assur/controls/number-row.js";
import { byId, make } from "assur/core/dom.js";
import { edited, withDocument } from "assur/state/state.js";

/**
 * @typedef {import("assur/engine.js").MotionSummary} Summary
 * @typedef {import("assur/state/state.js").LinkageDocument} LinkageDocument
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/model.js").OwnSnapshot<"linkage">} Snapshot
 */

/** A slider goes to so many times the length that it is made for. */
const LONGEST = 2;
const SHORTEST = 0.05;
/** That of a coordinate goes by this part of the drawing's diagonal to both sides. */
const ASIDE = 0.1;
/** The coordinates of a point: where they stand in `at`, their symbols and words. */
const AXES = Object.freeze([{ axis: 0, symbol: "x", key: "points.x" }, { axis: 1, symbol: "y", key: "points.y" }]);

/**
 * A dimension with a slider: its row, where a linkage has it, what becomes other with it.
 * @typedef {{
 *   kind: import("assur/controls/number-row.js").RowKind,
 *   of: (linkage: LinkageDocument) => number,
 *   changed: (linkage: LinkageDocument, value: number) => Partial<LinkageDocument>,
 * }} Dimension
 */

export class LinkageRail {
  #store;
  #drafts;
  #driver = make("select", { id: "driver", class: "control", "data-t-label": "field.drivers" });
  #assembly = make("select", { id: "linkage-assembly", class: "control", "data-t-label": "field.assembly" });
  #lengths = make("div", { id: "linkage-lengths" });
  #coordinates = make("div", { id: "linkage-frame" });
  /** @type {{ row: NumberRow, of: Dimension["of"] }[]} */
  #rows = [];
  #built = "";
  /** @type {readonly unknown[]} what was shown last */
  #shown = [];

  /**
   * @param {import("assur/app/page.js").Page} page
   */
  constructor({ store, drafts }) {
    this.#store = store;
    this.#drafts = drafts;
    this.#driver.addEventListener("change", () => this.#edit({ drivers: [{ crank: this.#driver.value }], assembly: null }));
    this.#assembly.addEventListener("change", () => this.#edit({ assembly: Number(this.#assembly.value) }));
    const section = (/** @type {string} */ key, /** @type {HTMLElement} */ content) =>
      make("section", { "data-of": "linkage" }, [make("h2", { "data-t": key }), content]);
    const sections = [
      section("field.drivers", this.#driver),
      section("lengths.links", this.#lengths),
      section("lengths.frame", this.#coordinates),
      section("field.assembly", this.#assembly),
    ];
    byId("overlays", HTMLElement).before(...sections);
  }

  /** @param {Snapshot} snapshot */
  render({ state, summary, words, problems }) {
    const { document: linkage } = state;
    const wrong = new Set(problems.map(({ field, path }) => field ?? path));
    const shown = [linkage, summary, words, ...wrong];
    if (shown.length === this.#shown.length && shown.every((part, i) => part === this.#shown[i])) return;
    this.#shown = shown;
    const built = JSON.stringify([linkage.title, linkage.frame, linkage.links.map(({ name, points }) => [name, points])]);
    if (built !== this.#built) {
      this.#built = built;
      this.#build(linkage, summary, words);
    }
    const [driver] = linkage.drivers;
    this.#driver.value = driver?.crank ?? "";
    for (const { row, of } of this.#rows) row.show(of(linkage), words, wrong.has(row.field));
    const { assembly, assemblies } = summary;
    const numbers = Array.from({ length: assemblies }, (_, i) => String(i + 1));
    if (this.#assembly.options.length !== assemblies) {
      this.#assembly.replaceChildren(...numbers.map((value) => make("option", { value }, [value])));
    }
    this.#assembly.value = String(assembly);
  }

  /** @param {Partial<LinkageDocument>} change */
  #edit(change) {
    this.#store.update((state) => withDocument(state, change));
  }

  /**
   * @param {LinkageDocument} linkage
   * @param {Summary} summary
   * @param {Words} words
   */
  #build(linkage, summary, words) {
    const hinged = linkage.links.filter(({ points, fixed_to: to }) => !to && points.some((point) => linkage.frame.includes(point)));
    this.#driver.replaceChildren(...hinged.map(({ name }) => make("option", { value: name }, [name])));
    this.#rows = [];
    this.#place(this.#lengths, straightLinks(linkage).map((index) => length(linkage, summary, index)), words);
    this.#place(this.#coordinates, frameHinges(linkage).flatMap((index) => AXES.map((axis) => coordinate(linkage, summary, index, axis))), words);
  }

  /**
   * @param {HTMLElement} place
   * @param {readonly Dimension[]} dimensions
   * @param {Words} words
   */
  #place(place, dimensions, words) {
    const rows = dimensions.map(({ kind, of, changed }) => {
      const row = new NumberRow(kind, this.#drafts, (value) =>
        this.#store.update((state) => edited(state, "linkage", (linkage) => changed(linkage, value))),
      );
      words.fill(row.element);
      return { row, of };
    });
    this.#rows.push(...rows);
    place.replaceChildren(...rows.map(({ row }) => row.element));
    if (place.parentElement) place.parentElement.hidden = rows.length === 0;
  }
}

/**
 * @param {LinkageDocument} linkage
 * @param {Summary} summary
 * @param {number} index of a link
 * @returns {Dimension}
 */
function length(linkage, summary, index) {
  const { name } = linkage.links[index];
  const now = lengthOf(linkage, index);
  const slider = { min: SHORTEST * now, max: LONGEST * now, step: stepOf(now) };
  return {
    kind: { field: `links[${index}].length`, id: `length-${index}`, key: "links.length", n: name, symbol: "l", role: summary.roles[name] ?? "secondary", slider },
    of: (document) => lengthOf(document, index),
    changed: ({ links }, value) => ({ links: links.map((link, at) => (at === index ? { ...link, length: value } : link)) }),
  };
}

/**
 * @param {LinkageDocument} linkage
 * @param {Summary} summary
 * @param {number} index of a point of the frame
 * @param {(typeof AXES)[number]} axis
 * @returns {Dimension}
 */
function coordinate({ points }, { bounds: [left, bottom, right, top] }, index, { axis, symbol, key }) {
  const { name, at } = points[index];
  const reach = ASIDE * Math.hypot(right - left, top - bottom);
  const slider = { min: at[axis] - reach, max: at[axis] + reach, step: stepOf(reach) };
  return {
    kind: { field: `points[${index}].${symbol}`, id: `point-${index}-${symbol}`, key, n: name, symbol, role: "secondary", slider },
    of: (document) => document.points[index].at[axis],
    changed: (document, value) => ({
      points: document.points.map((point, i) => (i === index ? { ...point, at: /** @type {const} */ ([axis ? point.at[0] : value, axis ? value : point.at[1]]) } : point)),
      // The links that are hinged there stay as they are.
      links: document.links.map((link, i) => (link.points.includes(name) ? kept(document, link, i) : link)),
    }),
  };
}

/**
 * @param {LinkageDocument} linkage
 * @param {LinkageDocument["links"][number]} link
 * @param {number} index of the link
 * @returns {LinkageDocument["links"][number]} the link with the dimensions that it has from the drawing
 */
function kept(linkage, link, index) {
  if (link.length || link.shape || link.points.length < 2) return link;
  if (link.points.length === 2) return { ...link, length: lengthOf(linkage, index) };
  return { ...link, shape: link.points.flatMap((name) => linkage.points.filter((point) => point.name === name)).map(({ at }) => at) };
}

/** @param {number} size of what a slider changes */
function stepOf(size) {
  return 10 ** (Math.floor(Math.log10(size)) - 2);
}

/**
 * The hinges of the frame that can be moved by themselves: no guide goes through them, and no link that is fixed to
 * another, and lies on it as drawn, depends on them.
 * @param {LinkageDocument} linkage
 * @returns {number[]} points, by their numbers
 */
function frameHinges({ points, frame, links, slides = [] }) {
  const bound = new Set(slides.flatMap(({ point, line }) => [point, ...line]));
  for (const { name, points: own, fixed_to: to } of links) {
    if (to || links.some((link) => link.fixed_to === name)) own.forEach((point) => bound.add(point));
  }
  return points.flatMap(({ name }, index) => (
    frame.includes(name) && !bound.has(name) && links.some((link) => link.points.includes(name)) ? [index] : []
  ));
}

/**
 * @param {LinkageDocument} linkage
 * @returns {number[]} the links that have one length, by their numbers
 */
export function straightLinks({ links }) {
  return links.flatMap((link, index) => (link.points.length === 2 && !link.shape && !link.fixed_to ? [index] : []));
}

/**
 * @param {LinkageDocument} linkage
 * @param {number} index of a link with two points
 * @returns {number} its length: its own, or else as it is drawn
 */
function lengthOf({ links, points }, index) {
  const { length, points: ends } = links[index];
  if (length) return length;
  const [[ax, ay], [bx, by]] = ends.map((name) => points.find((point) => point.name === name)?.at ?? [0, 0]);
  return Math.hypot(bx - ax, by - ay);
}
