// The rail of a linkage: its driver, its dimensions, its source. The engine computes the effect of every change.
import { NumberRow } from "assur/controls/number-row.js";
import { fold } from "assur/controls/section.js";
import { byId, make, write } from "assur/core/dom.js";
import { between, called, calledBy, toLine } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { lettered } from "assur/core/subscripts.js";
import { sourceOf } from "assur/core/titles.js";
import { change, inputNow } from "assur/state/change.js";

/**
 * @typedef {import("assur/state/details.js").Summaries["linkage"]} Summary
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/model.js").OwnSnapshot<"linkage">} Snapshot
 */

/** Number of dimensions of links that are always visible; all others are in a fold. */
const IN_SIGHT = 6;

/** Key of the name, and the symbol, for each kind of dimension. */
const KINDS = Object.freeze({
  length: Object.freeze({ key: "links.length", symbol: "l" }),
  side: Object.freeze({ key: "links.side", symbol: "l" }),
  corner: Object.freeze({ key: "links.corner", symbol: "∠" }),
  offset: Object.freeze({ key: "slides.offset", symbol: "e" }),
  x: Object.freeze({ key: "points.x", symbol: "x" }),
  y: Object.freeze({ key: "points.y", symbol: "y" }),
});

export class LinkageRail {
  #page;
  #driver = make("select", { id: "driver", class: "control", "data-t-label": "field.drivers" });
  #rates = make("div", { id: "linkage-rates" });
  #lengths = make("div", { id: "linkage-lengths" });
  #coordinates = make("div", { id: "linkage-frame" });
  /** Fold with the dimensions that are not always visible. */
  #more = make("details", { id: "more-dimensions", class: "fold within" });
  #moreName = make("summary");
  #moreLengths = make("div");
  #source = make("p", { class: "source", "data-of": "linkage" });
  /** @type {NumberRow[]} */
  #rows = [];
  /** @type {NumberRow[]} rows for the rates of further drivers */
  #further = [];
  #built = new Seen();
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    const { engine } = page;
    this.#page = page;
    this.#driver.addEventListener("change", () => this.#change((input) => engine.simulator.drive(this.#driver.value, input)));
    this.#more.append(this.#moreName, this.#moreLengths, make("section", {}, [make("h2", { "data-t": "lengths.frame" }), this.#coordinates]));
    fold("dimensions", [make("section", { "data-of": "linkage" }, [this.#lengths, this.#more])]);
    fold("structure", [make("section", { "data-of": "linkage" }, [make("h2", { "data-t": "field.drivers" }), this.#driver, this.#rates])]);
    byId("rail", HTMLElement).append(this.#source);
  }

  /** @param {Snapshot} snapshot */
  render({ state, summary, words, problems }) {
    const { document: linkage } = state;
    const wrong = new Set(problems.map(({ field, path }) => field ?? path));
    if (this.#shown.same(linkage, summary, words, ...wrong)) return;
    const { drivers, dimensions, rates } = summary;
    const built = JSON.stringify([words.lang, linkage.title, drivers, rates.map(({ field, link, role }) => [field, link, role]), dimensions.map(({ field, name, role }) => [field, name, role])]);
    if (!this.#built.same(built)) this.#build(summary, words);
    const source = sourceOf(linkage, this.#page.engine, words);
    // A source that a lesson gives for a linkage of the catalogue is in English.
    this.#source.lang = linkage.origin && source === linkage.source ? "en" : words.lang;
    write(this.#source, source);
    const [driver] = linkage.drivers;
    this.#driver.value = driver?.crank ?? linkage.slides?.[driver?.slide ?? -1]?.link ?? "";
    this.#rows.forEach((row, i) => row.show(dimensions[i].value, words, wrong.has(row.field)));
    this.#further.forEach((row, i) => row.show(rates[i].rate, words, wrong.has(row.field)));
  }

  /**
   * @param {(input: number) => import("assur/types/web.js").Changed} asked request to the engine, called with the current input
   * @param {string} [field] field that shows the reason if the engine refuses
   */
  #change(asked, field = "drivers") {
    change(() => asked(inputNow(this.#page)), field, this.#page);
  }

  /**
   * @param {Summary} summary
   * @param {Words} words
   */
  #build({ drivers, dimensions, rates }, words) {
    this.#driver.replaceChildren(...drivers.map((name) => make("option", { value: name }, [called(name, words)])));
    this.#rows = dimensions.map((dimension) => this.#row(dimension, words));
    this.#further = rates.map(({ field, link, role }, i) => {
      const kind = { field, id: `rate-${i + 2}`, key: "drivers.rate", n: called(link, words), symbol: "u", role };
      return new NumberRow(kind, this.#page.drafts, (value) => this.#change((input) => this.#page.engine.simulator.setDimension(field, value, input), field));
    });
    for (const { element } of [...this.#rows, ...this.#further]) words.fill(element);
    this.#rates.replaceChildren(...this.#further.map(({ element }) => element));
    const isOfPoint = (/** @type {NumberRow} */ { field }) => field.startsWith("points");
    const coordinates = this.#rows.filter(isOfPoint);
    const lengths = this.#rows.filter((row) => !isOfPoint(row));
    const inSight = lengths.length > IN_SIGHT + 1 ? IN_SIGHT : lengths.length;
    const show = (/** @type {HTMLElement} */ container, /** @type {NumberRow[]} */ rows) => container.replaceChildren(...rows.map(({ element }) => element));
    show(this.#lengths, lengths.slice(0, inSight));
    show(this.#moreLengths, lengths.slice(inSight));
    show(this.#coordinates, coordinates);
    if (this.#coordinates.parentElement) this.#coordinates.parentElement.hidden = coordinates.length === 0;
    const more = this.#rows.length - inSight;
    this.#more.hidden = more === 0;
    write(this.#moreName, words.counted("lengths.more", more));
  }

  /**
   * @param {import("assur/types/web.js").DimensionSummary} dimension
   * @param {Words} words
   */
  #row({ field, kind, index, name, points, role, min, max, step }, words) {
    const { engine, drafts } = this.#page;
    const isPoint = kind === "x" || kind === "y";
    const id = isPoint ? `point-${index}-${kind}` : `${kind}-${field.match(/\d+/g)?.join("-")}`;
    const { key, symbol: plain } = KINDS[kind];
    const isOffset = kind === "offset";
    const [point, ...line] = points;
    const symbol = lettered(plain, isOffset ? [point] : points);
    const by = (/** @type {readonly string[]} */ ends) => (isPoint ? name : calledBy(name, ends, words));
    const n = by(isOffset ? [toLine(point, line)] : kind === "length" ? [] : points);
    const shownName = symbol === plain ? n : isOffset ? between(line) : by([]);
    const row = { field, id, key, symbol, n, name: shownName, role, slider: { min, max, step }, ...(kind === "corner" ? { unit: "°", decimals: 2 } : {}) };
    return new NumberRow(row, drafts, (value) => this.#change((input) => engine.simulator.setDimension(field, value, input), field));
  }
}
