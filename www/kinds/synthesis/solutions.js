// The list of solutions with verdicts, which can be saved. The chosen one is drawn and can be opened in the simulator.
import { degrees } from "assur/core/angles.js";
import { make, write } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { download } from "assur/core/download.js";
import { section } from "assur/controls/section.js";
import { Seen } from "assur/core/seen.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/synthesis/positions.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").SolutionSummary} Solution
 * @typedef {import("assur/types/web.js").WantedSummary} Wanted
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Keys of the texts on how the solutions were found. */
const FROM = Object.freeze({ family: "solutions.family", exact: "solutions.exact", found: "solutions.found", trial: "solutions.trial" });

/** Gap below which a contour counts as closed: a smaller gap is invisible in the digits that are written. */
const EXACT = 5e-7;

/** Columns of the file: lengths, starting angles, errors, verdict. */
const COLUMNS = Object.freeze([
  "l1", "l2", "l3", "phi20_deg", "phi30_deg", "gap", "sum", "at_bound",
  "passage", "order", "grashof", "input_turns", "transmission_deg", "size_ratio", "output_error_deg",
]);

export class SolutionsView {
  #page;
  #said = make("p", { id: "synthesis-said" });
  #printed = make("p", { id: "synthesis-printed" });
  #weighted = make("p", { id: "synthesis-weighted" });
  #body = make("tbody");
  #equation = make("div");
  /** @type {Snapshot["summary"] | null} */
  #summary = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    const send = make("button", { id: "synthesis-send", class: "control add", type: "button", "data-t": "solutions.send", onclick: () => this.#send() });
    const save = make("button", { id: "synthesis-csv", class: "control add", type: "button", "data-t": "solutions.csv", onclick: () => this.#save() });
    const table = make("table", { class: "solutions", "data-t-label": "solutions.heading" }, [this.#body]);
    const equation = make("details", { id: "main-equation", "data-field": "main-equation" }, [make("summary", { "data-t": "solutions.equation" }), this.#equation]);
    section("synthesis", "solutions.heading", "solutions", [this.#said, table, this.#printed, this.#weighted, send, save]);
    section("synthesis", "solutions.equation_heading", "equation", [equation]);
  }

  /** @param {Snapshot} snapshot */
  render({ summary, words }) {
    if (this.#shown.same(summary, words)) return;
    this.#summary = summary;
    const { from, found, number, turned, wanted } = summary;
    const { best = 0, starts = 0 } = found ?? {};
    const said = words.text(FROM[from], { best: words.numbers.exact(best), starts: words.numbers.exact(starts) });
    write(this.#said, turned ? `${said} ${words.text("solutions.turned")}` : said);
    const chosen = from === "trial" ? 0 : (number ?? 1);
    render(listed(summary).map(([n, solution]) => this.#row(solution, n, chosen, words)), this.#body);
    this.#sayOthers(summary, words);
    render(wanted.map((one, k) => mainEquation(k + 1, one, summary.frame, words)), this.#equation);
  }

  /**
   * @param {Solution} solution
   * @param {number} n
   * @param {number} chosen
   * @param {Words} words
   */
  #row(solution, n, chosen, words) {
    const { numbers } = words;
    const choose = () => this.#page.store.update((state) => edited(state, "synthesis", () => ({ solution: n, trial: null })));
    const lengths = solution.lengths.map((length, i) => `l${"₁₂₃"[i]} = ${numbers.short(length)}`).join("; ");
    const turned = solution.starts.some((start) => start !== 0) ? solution.starts.map((start, i) => `φ${"₂₃"[i]}₀ = ${words.numbers.angle(start, 3)}`) : [];
    return html`<tr><td><label for="solution-${n}"><input id="solution-${n}" type="radio" name="solution" .checked=${n === chosen} @change=${choose}> ${[lengths, ...turned].join("; ")}</label><small>${verdict(solution, words)}</small></td></tr>`;
  }

  /**
   * Writes the results of the paper's method and of Levitsky's method.
   * @param {Snapshot["summary"]} summary
   * @param {Words} words
   */
  #sayOthers({ printed, weighted }, words) {
    for (const [element, key, found, least] of /** @type {const} */ ([
      [this.#printed, "solutions.printed", printed, printed?.least], [this.#weighted, "solutions.weighted", weighted, weighted?.sum],
    ])) {
      element.hidden = !found;
      if (!found || least === undefined) continue;
      const said = (/** @type {number} */ value) => words.numbers.short(value);
      const [l1, l2, l3] = found.lengths.map(said);
      write(element, words.text(key, { l1, l2, l3, least: said(least), drawn: said(found.drawn) }));
    }
  }

  #send() {
    if (!this.#summary) return;
    const { kind, document } = this.#summary.linkage;
    this.#page.choose(kind, document);
  }

  #save() {
    if (!this.#summary) return;
    const lines = listed(this.#summary).map(([, { lengths, starts, gap, sum, at_bound: bound, output_error: off, verdict: one }]) => [
      ...lengths, ...starts.map(degrees), gap, sum, bound,
      ...(one ? [one.passage, one.order, one.grashof, one.turns, degrees(one.transmission), one.size_ratio] : ["", "", "", "", "", ""]),
      off === null ? "" : degrees(off),
    ]);
    download(new Blob([COLUMNS, ...lines].map((cells) => `${cells.join(",")}\n`), { type: "text/csv" }), "solutions.csv");
  }
}

/**
 * @param {Snapshot["summary"]} summary
 * @returns {readonly [number, Solution][]} numbered solutions in the order shown; of a family, only the drawn member
 */
function listed({ solutions, shown, drawn }) {
  return shown.length > 0 ? shown.map((number) => [number, solutions[number - 1]]) : [[1, drawn]];
}

/**
 * @param {Solution} solution
 * @param {Words} words
 */
function verdict({ verdict: one, gap, output_error: off, at_bound: bound }, words) {
  const open = `${words.text("verdict.gap")} ${words.numbers.upTo(gap, 4)}`;
  if (!one) return `${words.text("verdict.none")}; ${open}`;
  return [
    words.text(`grashof.${one.grashof}`),
    `${words.text("verdict.passage")} ${words.text(`verdict.${one.passage}`)}`,
    `${words.text("verdict.order")} ${words.text(`verdict.${one.order}`)}`,
    `μ ≥ ${words.numbers.angle(one.transmission, 3)}`,
    ...(bound ? [words.text("verdict.at_bound")] : []),
    ...(off === null ? [] : [`${words.text("verdict.output_error")} ${words.numbers.angle(off, 3)}`]),
    open,
  ].join("; ");
}

/**
 * Writes the paper's main equation for a position: its angles, the equation with symbols and with numbers, and the gap.
 * @param {number} k
 * @param {Wanted} wanted
 * @param {number} frame length of the frame
 * @param {Words} words
 */
function mainEquation(k, { output, input, error, at, open, equation: [left, constant, byInput, byOutput] }, frame, words) {
  const said = (/** @type {number} */ value) => words.numbers.fixed(value, 5);
  const lines = [
    `${words.text("positions.number", { n: String(k) })}: φ₂ = ${words.numbers.angle(output, 3)}, φ₃ = ${words.numbers.angle(input, 3)}`,
    "e₂·e₃ = Z + e₀·e₂ / z₃ + e₀·e₃ / z₂",
    `${said(left)} = ${said(constant)} + (${said(byInput)}) + (${said(byOutput)})`,
    `${said(left)} ${Math.abs(error) < EXACT ? "=" : "≠"} ${said(constant + byInput + byOutput)}`,
    `φ₁ = ${words.numbers.angle(at, 3)}: |l₁e₁ + l₂e₂ + l₃e₃ − l₀e₀| = ${length(open, words)} (${words.numbers.upTo((100 * (open < EXACT ? 0 : open)) / frame, 1)} %)`,
  ];
  return html`<p>${lines.map((line, i) => html`${i > 0 ? html`<br>` : nothing}${line}`)}</p>`;
}

/**
 * @param {number} open
 * @param {Words} words
 * @returns {string} the gap, or 0 if it is too small to be read
 */
function length(open, words) {
  return words.numbers.upTo(open < EXACT ? 0 : open, 4);
}
