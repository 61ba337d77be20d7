// Plot of the analogue ψ″ over a turn: the exact curve, and finite differences of positions with the reader's step.
import { radians } from "assur/core/angles.js";
import { make, makeSvg, write } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";

/**
 * @typedef {import("assur/lesson/panel.js").Figure} Figure
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/details.js").Summaries["linkage"]} Summary
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {readonly [number, number]} Pair of ψ′ and ψ″
 */

/** Limits and initial value of the slider; at its value n, the step is 10^(n/10) degrees. */
const EXPONENTS = Object.freeze({ least: -60, most: 15, first: 13 });
/** Size of the plot, in units of its view box. */
const SIZE = Object.freeze({ width: 320, height: 180 });
/** Number of positions computed over a turn. */
const PLACES = 144;
/** Number of computed positions from one dot to the next. */
const DOTTED = 3;

/** @implements {Figure} */
export class Differences {
  #engine;
  #step = make("input", {
    id: "differences-step", type: "range", min: String(EXPONENTS.least), max: String(EXPONENTS.most), value: String(EXPONENTS.first),
    oninput: () => this.#draw(),
  });
  #name = make("span");
  #legend = make("p", { class: "note" });
  #errors = make("p", { id: "differences-errors" });
  #plot = makeSvg("svg", { viewBox: `0 0 ${SIZE.width} ${SIZE.height}`, class: "lesson-plot", role: "img" });
  /** @type {Summary | null} summary of the mechanism for which `#places` was computed */
  #summary = null;
  /** @type {{ at: number, exact: Pair }[]} */
  #places = [];
  /** @type {Words | null} */
  #words = null;
  element;

  /** @param {Pick<import("assur/engine.js").Engine, "simulator">} engine */
  constructor(engine) {
    this.#engine = engine;
    this.element = make("figure", {}, [make("label", {}, [this.#name, this.#step]), this.#plot, this.#legend, this.#errors]);
  }

  /**
   * @param {Snapshot} snapshot
   * @param {Words} words
   */
  render({ kind, summary, stale }, words) {
    if (kind !== "linkage" || stale || (summary === this.#summary && words === this.#words)) return;
    this.#words = words;
    this.#summary = summary;
    const { start, end } = summary.cycle;
    const places = Array.from({ length: PLACES }, (_, i) => start + ((end - start) * (i + 0.5)) / PLACES);
    this.#places = places.flatMap((at) => {
      const exact = attempt(() => this.#engine.simulator.plotted(at)).value;
      return exact && exact.length >= 3 ? [{ at, exact: /** @type {const} */ ([exact[1], exact[2]]) }] : [];
    });
    this.#draw();
  }

  #draw() {
    const words = this.#words;
    this.element.hidden = this.#places.length === 0;
    if (!words || this.element.hidden) return;
    const exponent = Number(this.#step.value);
    const { least, most } = EXPONENTS;
    this.#step.style.setProperty("--fill", String((exponent - least) / (most - least)));
    const degrees = 10 ** (exponent / 10);
    const h = radians(degrees);
    const value = (/** @type {number} */ at) => attempt(() => this.#engine.simulator.plotted(at)).value?.[0];
    const found = this.#places.map(({ at, exact }) => ({ at, exact, found: differences([value(at - h), value(at), value(at + h)], h) }));
    const worst = [0, 1].map((order) => Math.max(...found.map(({ exact, found }) => (found ? Math.abs(found[order] - exact[order]) : 0))));
    write(this.#name, words.text("differences.figure.step", { step: words.numbers.brief(degrees) }));
    write(this.#legend, words.text("differences.figure.legend"));
    write(this.#errors, words.text("differences.figure.errors", { first: words.numbers.short(worst[0]), second: words.numbers.short(worst[1]) }));
    this.#plot.setAttribute("aria-label", words.text("differences.figure.legend"));
    this.#paint(found, words);
  }

  /**
   * @param {readonly { at: number, exact: Pair, found: Pair | null }[]} all
   * @param {Words} words
   */
  #paint(all, { numbers }) {
    const { start, end } = /** @type {Summary} */ (this.#summary).cycle;
    const values = all.map(({ exact }) => exact[1]);
    const [least, most] = [Math.min(...values), Math.max(...values)];
    const room = 0.15 * (most - least);
    const x = (/** @type {number} */ at) => ((at - start) / (end - start)) * SIZE.width;
    const y = (/** @type {number} */ one) => SIZE.height * (1 - (one - least + room) / (most - least + 2 * room));
    const curve = all.map(({ at, exact }) => `${x(at).toFixed(1)},${y(exact[1]).toFixed(1)}`).join(" ");
    const zero = y(0).toFixed(1);
    const ends = [most, least].map((value) => makeSvg("text", { x: "2", y: (y(value) + (value > 0 ? -4 : 12)).toFixed(1) }, [numbers.short(value)]));
    const dots = all.flatMap(({ at, found }, i) => (found && i % DOTTED === 0 ? [[x(at), y(found[1])]] : []));
    const seen = dots.filter(([, top]) => top >= 0 && top <= SIZE.height);
    this.#plot.replaceChildren(
      makeSvg("line", { x1: "0", x2: String(SIZE.width), y1: zero, y2: zero, class: "axis" }),
      ...[most, least].map((value) => makeSvg("line", { x1: "0", x2: String(SIZE.width), y1: y(value).toFixed(1), y2: y(value).toFixed(1), class: "axis" })),
      makeSvg("polyline", { points: curve }),
      ...seen.map(([left, top]) => makeSvg("circle", { cx: left.toFixed(1), cy: top.toFixed(1), r: "2" })),
      ...ends,
    );
  }
}

/**
 * @param {readonly (number | undefined)[]} places ψ at φ₁ − h, φ₁ and φ₁ + h
 * @param {number} h step in radians
 * @returns {Pair | null} ψ′ and ψ″ by central differences; null if a position is missing
 */
export function differences([before, here, after], h) {
  if (before === undefined || here === undefined || after === undefined) return null;
  return [(after - before) / (2 * h), (after - 2 * here + before) / (h * h)];
}
