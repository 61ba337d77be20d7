// Conditions and theorems of the paper at the coupler angle of each position: as printed, beside the true results.
import { radians } from "assur/core/angles.js";
import { make } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { cone } from "assur/kinds/synthesis/cone.js";
import { Plane } from "assur/kinds/synthesis/plane.js";
import { section } from "assur/controls/section.js";

/**
 * @typedef {import("assur/kinds/synthesis/positions.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").WantedSummary} Wanted
 * @typedef {import("assur/core/words.js").Words} Words
 */

export class ConditionsView {
  #theme;
  #region;
  #content = make("div");
  /** @type {Snapshot | null} */
  #snapshot = null;
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ theme }) {
    this.#theme = theme;
    this.#region = new Plane("synthesis-region", theme, ["l₁", "l₂"], () => this.#paint());
    section("synthesis", "conditions.heading", "conditions", [
      make("details", { id: "synthesis-conditions" }, [
        make("summary", { "data-t": "conditions.show" }), this.#content,
        make("p", { class: "legend", "data-t": "region.heading" }), this.#region.element,
      ]),
    ]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { summary, words, state, withheld } = snapshot;
    const frame = radians(state.document.phi0_deg);
    if (this.#shown.same(summary, words, this.#theme.revision, withheld)) return;
    this.#snapshot = snapshot;
    const hidden = withheld.has(ANSWER);
    render(summary.wanted.map((one, k) => [
      table(one, k + 1, words, hidden),
      cone([frame, one.at, one.output, one.input], hidden ? words.text("lesson.asked") : words.text(one.interval ? "cone.inside" : "cone.outside", { n: String(k + 1) })),
    ]), this.#content);
    this.#region.element.ariaLabel = words.text("region.label");
    this.#paint();
  }

  /** Shades the plane of lengths l₁, l₂, darker where the linkage closes in more positions. Marks the drawn lengths. */
  #paint() {
    if (!this.#snapshot) return;
    const { summary: { frame, closed, wanted, drawn }, words } = this.#snapshot;
    if (!this.#region.begin(frame, words)) return;
    this.#region.shade(closed, (count) => (count / wanted.length) ** 2);
    this.#region.dot(drawn.lengths, "ink");
    this.#region.end();
  }
}

/**
 * @param {Wanted} wanted
 * @param {number} k
 * @param {Words} words
 * @param {boolean} hidden whether a lesson asks for the values of l₁ at which l₂ and l₃ are positive
 */
function table({ at, conditions, theorems, pair, ranges, interval }, k, words, hidden) {
  const { numbers } = words;
  const rows = conditions.map(({ number, about, values, holds, truth }) => row([`(${number})`, about ?? ""].join(" ").trim(), valued(number, about, values, words), [holds, truth], words));
  const left = pair ? [row(words.text("conditions.pair"), pair.values.map((value) => numbers.short(value)).join("; "), [null, pair.holds], words)] : [];
  const judged = theorems.map(({ number, conditions: asked, truth }) => row(words.text("conditions.theorem", { n: String(number) }), words.text(JUDGED[`${asked} ${truth}`]), [asked, truth], words, asked && !truth));
  const between = (ranges ?? []).map((range, i) => rangeRow(`l${"₂₃"[i]} > 0`, range ? ends("conditions.range", range, words) : words.text("conditions.never")));
  const name = words.text("conditions.of", { n: String(k), coupler: numbers.angle(at, 3) });
  const heads = ["conditions.printed", "conditions.truth"].map((key) => html`<th scope="col">${words.text(key)}</th>`);
  const known = interval ? ends(interval[0] === interval[1] ? "conditions.single" : "conditions.interval", interval, words) : words.text("conditions.empty");
  const truth = hidden ? `? (${words.text("lesson.asked")})` : known;
  return html`<table class="solutions conditions">
    <caption>${name}</caption>
    <thead><tr><td colspan="2"></td>${heads}</tr></thead>
    <tbody>${rows}${left}${hidden ? [] : judged}${between}${rangeRow(words.text("conditions.truth"), truth, "truth")}</tbody></table>`;
}

/** Name by which lessons withhold the values of l₁ at which l₂ and l₃ are positive. */
const ANSWER = "conditions-truth";

/** Keys of the texts on a theorem, by whether its conditions hold and whether its conclusion is true. */
const JUDGED = Object.freeze(/** @type {Readonly<Record<string, string>>} */ ({
  "true true": "conditions.right", "true false": "conditions.wrong", "false true": "conditions.missed", "false false": "conditions.silent",
}));

/**
 * @param {string} name
 * @param {string} said
 * @param {readonly (boolean | null)[]} verdicts entries of the columns for the printed condition and the true result; null for an empty cell
 * @param {Words} words
 * @param {boolean} [fails] whether the row shows a theorem that is false for this position
 */
function row(name, said, verdicts, words, fails = false) {
  return html`<tr ?data-fails=${fails}><th scope="row">${name}</th><td>${said}</td>${verdicts.map((holds) => mark(holds, words))}</tr>`;
}

/**
 * @param {boolean | null} holds
 * @param {Words} words
 */
function mark(holds, words) {
  if (holds === null) return html`<td>—</td>`;
  return html`<td data-holds=${holds}>${holds ? "✓" : "✗"}<span class="unseen">${words.text(holds ? "conditions.holds" : "conditions.fails")}</span></td>`;
}

/**
 * @param {string} name
 * @param {string} said
 * @param {string} [kind]
 */
function rangeRow(name, said, kind = "range") {
  return html`<tr class=${kind}><th scope="row">${name}</th><td colspan="3">${said}</td></tr>`;
}

/**
 * @param {number} number
 * @param {string | null} about
 * @param {readonly (number | null)[]} values
 * @param {Words} words
 * @returns {string} the numbers whose signs decide a condition
 */
function valued(number, about, values, words) {
  const [one, other] = values.map((value) => (value === null ? "—" : words.numbers.short(value)));
  if (about === null) return one;
  // Conditions (33) to (38) of the paper concern two fractions; earlier ones concern the quantities Pₖ and Qₖ.
  const k = subscript(about.slice(1));
  // A line may break only between the two equations.
  return number < 33 ? `P${k}\u00a0=\u00a0${one}; Q${k}\u00a0=\u00a0${other}` : `${one}; ${other}`;
}

/**
 * @param {string} key
 * @param {readonly [number, number | null]} range
 * @param {Words} words
 */
function ends(key, [from, to], words) {
  return words.text(key, { from: words.numbers.short(from), to: to === null ? words.text("map.without_end") : words.numbers.short(to) });
}
