// What the page shows of a linkage beside drawing and plots: its rail and its status line. Loaded with the first linkage.
import { degrees } from "assur/angles.js";
import { byId, make, setData, write } from "assur/dom.js";
import { NumberRow } from "assur/number-row.js";
import { edited, withDocument } from "assur/state.js";

/**
 * @typedef {import("assur/engine.js").LinkageSummary} Summary
 * @typedef {import("assur/state.js").LinkageDocument} LinkageDocument
 * @typedef {import("assur/state.js").State<"linkage">} LinkageState
 * @typedef {import("assur/words.js").Words} Words
 * @typedef {import("assur/model.js").OwnSnapshot<"linkage">} Snapshot
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
 *   kind: import("assur/number-row.js").RowKind,
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
   * @param {import("assur/store.js").Store<import("assur/state.js").State>} store
   * @param {import("assur/drafts.js").Drafts} drafts
   * @param {Words} words
   */
  constructor(store, drafts, words) {
    this.#store = store;
    this.#drafts = drafts;
    this.#driver.addEventListener("change", () => this.#edit({ drivers: [{ crank: this.#driver.value }], assembly: null }));
    this.#assembly.addEventListener("change", () => this.#edit({ assembly: Number(this.#assembly.value) }));
    const section = (/** @type {string} */ key, /** @type {HTMLElement} */ content) =>
      make("section", { class: "of-linkage" }, [make("h2", { "data-t": key }), content]);
    const sections = [
      section("field.drivers", this.#driver),
      section("lengths.links", this.#lengths),
      section("lengths.frame", this.#coordinates),
      section("field.assembly", this.#assembly),
    ];
    byId("overlays", HTMLElement).before(...sections);
    for (const one of sections) words.fill(one);
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

/** What is called otherwise of a linkage: element, attribute, the key of its words of the mixer, and of a linkage. */
const CALLED = Object.freeze([
  ["mechanism", "data-t-label", "stage.canvas", "stage.linkage"],
  ["reset", "data-t", "edit.reset", "reset.linkage"],
]);

/** The name of the linkage, where the mixer's would stand. */
export class LinkageTitle {
  #place = byId("linkage-name", HTMLElement);
  #engine;
  /** @type {readonly unknown[]} what was shown last */
  #shown = [];

  /** @param {import("assur/engine.js").Engine} engine */
  constructor(engine) {
    this.#engine = engine;
  }

  /** @param {import("assur/model.js").Snapshot} snapshot */
  render({ state, words }) {
    const mixer = state.lesson === "mixer";
    const name = mixer ? "" : nameOf(this.#engine, state.document, words);
    const shown = [mixer, name, words];
    if (shown.every((part, i) => part === this.#shown[i])) return;
    this.#shown = shown;
    write(this.#place, name);
    for (const [id, attribute, ofMixer, ofLinkage] of CALLED) {
      const element = byId(id, HTMLElement);
      element.setAttribute(attribute, mixer ? ofMixer : ofLinkage);
      element.dataset.n = name;
      words.fill(element.parentElement ?? element);
    }
  }
}

/**
 * @param {import("assur/engine.js").Engine} engine
 * @param {LinkageDocument} linkage
 * @param {Words} words
 * @returns {string} its name in the gallery, else the title it has itself
 */
function nameOf(engine, linkage, words) {
  const original = engine.original(linkage);
  return original ? words.text(`gallery.${original.id}`) : linkage.title || words.text("gallery.own");
}

/** @type {Readonly<Record<string, (summary: Summary, words: Words, state: LinkageState) => string | (Node | string)[]>>} */
const ENTRIES = Object.freeze({
  mobility: ({ mobility }, words) => words.numbers.exact(mobility),
  class: ({ class: highest, order }, words) => `${highest}, ${words.numbers.exact(order)}`,
  formula: ({ formula, groups }, _, { view }) => (view.groups ? coloured(groups) : formula),
  "linkage-assembly": ({ assembly, assemblies }, words) =>
    words.text("status.assembly_of", { number: words.numbers.exact(assembly), count: words.numbers.exact(assemblies) }),
  "linkage-range": ({ cycle }, words) => (cycle.full ? "" : cycle.arcs.map((arc) => arc.map((end) => angle(end, words)).join("…")).join(", ")),
  "linkage-dead": ({ dead_points: dead }, words) =>
    dead.map(({ phi, kind, links }) => `${angle(phi, words)} ${words.text(`dead.${kind}`)} (${links.join(", ")})`).join("; "),
  "linkage-change": ({ change_points: points }, words) => points.map((phi) => angle(phi, words)).join(", "),
});

const TITLES = Object.freeze({
  "linkage-assembly": "assembly", "linkage-range": "range", "linkage-dead": "dead-points", "linkage-change": "change-points",
});

export class LinkageStatus {
  #list = byId("status", HTMLElement);
  /** @type {{ name: string, entry: HTMLElement, output: HTMLElement }[]} */
  #entries = [];
  #shown = "";

  /** @param {Words} words */
  constructor(words) {
    for (const name of Object.keys(ENTRIES)) {
      const output = make("dd", { id: `out-${name}` });
      const title = make("dt", { "data-t": `status.${/** @type {Record<string, string>} */ (TITLES)[name] ?? name}` });
      const entry = make("div", { class: "entry of-linkage" }, [title, " ", output, " "]);
      this.#list.append(entry);
      this.#entries.push({ name, entry, output });
      words.fill(entry);
    }
  }

  /** @param {Snapshot} snapshot */
  render({ state, summary, words, revision, stale }) {
    setData(this.#list, "faded", String(stale));
    if (stale && this.#shown.endsWith(` ${words.lang}`)) return;
    const shown = `${revision} ${words.lang}`;
    if (shown === this.#shown) return;
    this.#shown = shown;
    for (const { name, entry, output } of this.#entries) {
      const said = ENTRIES[name](summary, words, state);
      entry.hidden = said === "";
      output.replaceChildren(...(typeof said === "string" ? [said] : said));
    }
  }
}

/**
 * @param {Summary["groups"]} groups
 * @returns {(Node | string)[]} the structural formula, beside each term the colour of its links in the drawing
 */
function coloured(groups) {
  const swatch = (/** @type {string} */ role) => make("i", { class: "swatch", style: `--accent: var(--role-${role})`, "data-role": role, "aria-hidden": "true" });
  return groups.flatMap(({ term, role }, i) => [...(i > 0 ? [" → "] : []), make("span", { class: "group" }, [swatch(role), term])]);
}

/**
 * @param {number} phi
 * @param {Words} words
 */
function angle(phi, words) {
  return `${words.numbers.upTo(degrees(phi), 2)}°`;
}
