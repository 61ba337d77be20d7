// What the page shows of a linkage beside drawing and plots: its rail and its status line. Loaded with the first linkage.
import { degrees } from "assur/angles.js";
import { byId, make, setData, write } from "assur/dom.js";
import { NumberRow } from "assur/number-row.js";
import { withDocument } from "assur/state.js";

/**
 * @typedef {import("assur/engine.js").LinkageSummary} Summary
 * @typedef {import("assur/state.js").LinkageDocument} LinkageDocument
 * @typedef {import("assur/words.js").Words} Words
 * @typedef {Omit<import("assur/model.js").Snapshot, "summary" | "state"> & { summary: Summary, state: import("assur/state.js").LinkageState }} Snapshot
 */

/** A slider goes to so many times the length that it is made for. */
const LONGEST = 2;
const SHORTEST = 0.05;

export class LinkageRail {
  #store;
  #drafts;
  #driver = make("select", { id: "driver", class: "control", "data-t-label": "field.drivers" });
  #assembly = make("select", { id: "linkage-assembly", class: "control", "data-t-label": "field.assembly" });
  #lengths = make("div", { id: "linkage-lengths" });
  /** @type {{ row: NumberRow, index: number }[]} */
  #rows = [];
  #links = "";
  /** @type {readonly unknown[]} what was shown last */
  #shown = [];

  /**
   * @param {import("assur/store.js").Store<any>} store
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
    const links = linkage.links.map(({ name, points }) => `${name}:${points.length}`).join();
    if (links !== this.#links) {
      this.#links = links;
      this.#build(linkage, summary, words);
    }
    const [driver] = linkage.drivers;
    this.#driver.value = driver?.crank ?? "";
    for (const { row, index } of this.#rows) row.show(lengthOf(linkage, index), words, wrong.has(row.field));
    const { assembly, assemblies } = summary;
    const numbers = Array.from({ length: assemblies }, (_, i) => String(i + 1));
    if (this.#assembly.options.length !== assemblies) {
      this.#assembly.replaceChildren(...numbers.map((value) => make("option", { value }, [value])));
    }
    this.#assembly.value = String(assembly);
  }

  /** @param {Partial<LinkageDocument>} change */
  #edit(change) {
    this.#store.update((state) => withDocument(state, /** @type {any} */ (change)));
  }

  /**
   * @param {LinkageDocument} linkage
   * @param {Summary} summary
   * @param {Words} words
   */
  #build(linkage, summary, words) {
    const hinged = linkage.links.filter(({ points, fixed_to: to }) => !to && points.some((point) => linkage.frame.includes(point)));
    this.#driver.replaceChildren(...hinged.map(({ name }) => make("option", { value: name }, [name])));
    this.#rows = straightLinks(linkage).map((index) => {
      const { name } = linkage.links[index];
      const length = lengthOf(linkage, index);
      const step = 10 ** (Math.floor(Math.log10(length)) - 2);
      const row = new NumberRow(
        {
          field: `links[${index}].length`, id: `length-${index}`, key: "links.length", n: name, symbol: "l", role: summary.roles[name] ?? "secondary",
          slider: { min: SHORTEST * length, max: LONGEST * length, step },
        },
        this.#drafts,
        (value) => this.#lengthen(index, value),
      );
      words.fill(row.element);
      return { row, index };
    });
    this.#lengths.replaceChildren(...this.#rows.map(({ row }) => row.element));
  }

  /**
   * @param {number} index
   * @param {number} length
   */
  #lengthen(index, length) {
    const { links } = this.#store.get().document;
    this.#edit({ links: links.map((/** @type {object} */ link, /** @type {number} */ at) => (at === index ? { ...link, length } : link)) });
  }
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
    const name = mixer ? "" : nameOf(this.#engine, /** @type {any} */ (state.document), words);
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

/** @type {Readonly<Record<string, (summary: Summary, words: Words) => string>>} */
const ENTRIES = Object.freeze({
  mobility: ({ mobility }, words) => words.numbers.exact(mobility),
  class: ({ class: highest, order }, words) => `${highest}, ${words.numbers.exact(order)}`,
  formula: ({ formula }) => formula,
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
  render({ summary, words, revision, stale }) {
    setData(this.#list, "faded", String(stale));
    if (stale && this.#shown.endsWith(` ${words.lang}`)) return;
    const shown = `${revision} ${words.lang}`;
    if (shown === this.#shown) return;
    this.#shown = shown;
    for (const { name, entry, output } of this.#entries) {
      const text = ENTRIES[name](summary, words);
      entry.hidden = text === "";
      write(output, text);
    }
  }
}

/**
 * @param {number} phi
 * @param {Words} words
 */
function angle(phi, words) {
  return `${words.numbers.upTo(degrees(phi), 2)}°`;
}
