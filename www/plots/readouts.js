// Table of the current input and quantities. The colours of its rows serve as the legend of the drawing and the plots.
import { withhold, writeReadout } from "assur/controls/readout.js";
import { byId, make, setData, write } from "assur/core/dom.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { MEASURES, calledWhole, isLength, letterOfAngle, readoutOf, subscript, symbol } from "assur/core/symbols.js";
import { quantityText } from "assur/plots/values.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").ListedSummary} Listed
 * @typedef {import("assur/core/words.js").Words} Words
 */

const STROKES = Object.freeze(["", "′", "″"]);
const NONE = "—";

/** Heads of two further rows for each quantity if mechanism A is shown, too; B is the current mechanism. */
const COMPARED_ROWS = Object.freeze(/** @type {const} */ ({ a: "Ⓐ", difference: "Ⓑ − Ⓐ" }));

export class ReadoutTable {
  #table = byId("readouts", HTMLTableElement);
  #heads = STROKES.map(() => make("th", { scope: "col" }));
  #input = make("td", { id: "out-input" });
  #inputName = make("span");
  #inputSymbol = make("b");
  /** @type {{ listed: Listed, order: number, output: HTMLElement }[]} */
  #cells = [];
  /** @type {{ listed: Listed, order: number, outputs: Record<keyof typeof COMPARED_ROWS, HTMLElement> }[]} */
  #comparedRows = [];
  #built = new Seen();

  constructor() {
    this.#table.tHead?.append(make("tr", {}, [make("td"), ...this.#heads]));
    this.#table.tBodies[0].append(row("crank", false, [this.#inputSymbol, " ", this.#inputName], [this.#input, make("td"), make("td")]));
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, summary, readouts, coordinate, inputShown, words, stale, numbersDue, withheld, compares } = snapshot;
    setData(this.#table, "faded", String(stale));
    if (!numbersDue) return;
    if (!this.#built.same(summary, words, state.view.axes, compares)) this.#build(snapshot);
    write(this.#input, coordinate.written(inputShown, words, state.view.playing ? 1 : 3));
    this.#input.dataset.value = String(inputShown);
    for (const { listed, order, output } of this.#cells) {
      const value = readouts?.[listed.name + STROKES[order]];
      const said = value === undefined ? null : quantityText(value, listed.what, order, words);
      if (withheld.has(readoutOf(listed.name, order))) withhold(output, words);
      else writeReadout(output, said?.text ?? NONE, said?.value);
    }
    this.#compare(snapshot);
  }

  /** @param {Snapshot} snapshot */
  #compare({ readouts, compared, words, withheld }) {
    for (const { listed, order, outputs } of this.#comparedRows) {
      const name = listed.name + STROKES[order];
      const [a, b] = [compared?.readouts?.[name], readouts?.[name]];
      const difference = differenceOf(listed.what, order, a, b);
      for (const [value, output] of /** @type {const} */ ([[a, outputs.a], [difference, outputs.difference]])) {
        const said = value === undefined ? null : quantityText(value, listed.what, order, words);
        // The difference from A would give a withheld value away.
        if (output === outputs.difference && withheld.has(readoutOf(listed.name, order))) withhold(output, words);
        else writeReadout(output, said?.text ?? NONE, said?.value);
      }
    }
  }

  /** @param {Snapshot} snapshot */
  #build({ state: { view }, summary: { listed, curves }, coordinate, words, compares }) {
    write(this.#inputSymbol, coordinate.symbol);
    write(this.#inputName, words.text(`readouts.input.${coordinate.moves}`));
    // The heads show the symbols of the derivatives of angles, of lengths or of both.
    const found = (/** @type {string[]} */ ...sorts) => sorts.filter((one) => listed.some(({ what }) => what === one));
    const usual = found("angle", "load_angle", "x", "y");
    // Measures have letters of their own, which are in the heads only if no other quantities are listed.
    const sorts = usual.length > 0 ? usual : found(...MEASURES);
    const physical = view.axes === "physical" || coordinate.moves === "time";
    this.#heads.forEach((head, order) => {
      write(head, sorts.map((sort) => symbol({ name: `.${sort}` }, order, physical, words).trim()).join(", "));
    });
    this.#cells = [];
    this.#comparedRows = [];
    const rows = listed.flatMap((one) => {
      const bare = one.what === "transmission" || one.what === "pressure";
      const cells = STROKES.map((_, order) => {
        if (bare && order > 0) return make("td");
        const output = make("td", { id: `out-${readoutOf(one.name, order)}` });
        this.#cells.push({ listed: one, order, output });
        return output;
      });
      const title = [make("b", {}, [letter(one)]), " ", make("span", {}, [ofRow(one, words)])];
      const own = row(one.role, curves.includes(one.name), title, cells);
      return compares ? [own, ...this.#besideRows(one, bare ? 1 : STROKES.length)] : [own];
    });
    const [input] = this.#table.tBodies[0].rows;
    this.#table.tBodies[0].replaceChildren(input, ...rows);
  }

  /**
   * @param {Listed} listed
   * @param {number} count of values in a row: the quantity and its derivatives
   * @returns {HTMLElement[]} the rows of the comparison
   */
  #besideRows(listed, count) {
    const sorts = /** @type {(keyof typeof COMPARED_ROWS)[]} */ (Object.keys(COMPARED_ROWS));
    const outputs = STROKES.map((_, order) => {
      const made = sorts.map((sort) => [sort, make("td", order < count ? { id: `${sort}-${readoutOf(listed.name, order)}` } : {})]);
      return /** @type {Record<keyof typeof COMPARED_ROWS, HTMLElement>} */ (Object.fromEntries(made));
    });
    outputs.slice(0, count).forEach((pair, order) => this.#comparedRows.push({ listed, order, outputs: pair }));
    return sorts.map((sort) => {
      const head = make("th", { scope: "row" }, [make("b"), " ", make("span", {}, [COMPARED_ROWS[sort]])]);
      return make("tr", { class: "beside" }, [head, ...outputs.map((pair) => pair[sort])]);
    });
  }
}

/**
 * @param {Listed["what"]} what quantity of the two values
 * @param {number} order of the derivative
 * @param {number | undefined} a
 * @param {number | undefined} b
 * @returns {number | undefined} b − a, for angles reduced to −π … π; undefined if a value is missing
 */
export function differenceOf(what, order, a, b) {
  if (a === undefined || b === undefined) return undefined;
  return order === 0 && !isLength(what) ? turned(b - a) : b - a;
}

/**
 * @param {number} angle in radians
 * @returns {number} the angle less whole turns, from −π to π
 */
function turned(angle) {
  return angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
}

/**
 * A row of the table.
 * @param {string} role
 * @param {boolean} curve whether the quantity is plotted
 * @param {readonly (Node | string)[]} title
 * @param {readonly HTMLElement[]} cells
 */
export function row(role, curve, title, cells) {
  const swatch = make("i", { class: curve ? "swatch curve" : "swatch", "aria-hidden": "true" });
  const head = make("th", { scope: "row", style: `--accent: var(--role-${role})` }, [swatch, ...title]);
  return make("tr", {}, [head, ...cells]);
}

/** @param {Listed} listed */
function letter({ what, of, number }) {
  if (what === "transmission") return "μ";
  if (what === "pressure") return "α";
  if (what === "distance") return "d";
  if (what === "corner" || what === "between") return "θ";
  if (what === "angle") return letterOfAngle(of[0], number) + subscript(number ?? "");
  return what === "load_angle" ? `Δ${subscript(number ?? "")}` : what;
}

/**
 * @param {Listed} listed
 * @param {Words} words
 * @returns {string} text of a row after its letter; for a load angle Δ, only the name of the link
 */
export function ofRow(listed, words) {
  return listed.what === "load_angle" ? called(listed.of[0], words) : whose(listed, words);
}

/**
 * @param {Pick<Listed, "what" | "of">} listed
 * @param {Words} words
 * @returns {string} name of the quantity's link or point; except for angles of links and for coordinates, also the name of the quantity
 */
export function whose({ what, of }, words) {
  if (what === "angle") return of.map((link) => called(link, words)).join(", ");
  if (what === "load_angle") return words.text("readouts.load_angle", { name: called(of[0], words) });
  if (MEASURES.includes(what)) return `${words.text(`readouts.${what}`)} ${calledWhole(of.join("-"), what, words)}`;
  const point = subscript(of[0]);
  if (what === "transmission") return `${words.text("readouts.transmission")} ${point}`;
  return what === "pressure" ? `${words.text("readouts.pressure")} ${point}` : point;
}
