// The six transmission ratios with formulas and numbers, the identities between them, torques and powers of the shafts.
import { section } from "assur/controls/section.js";
import { make } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { subscript } from "assur/core/symbols.js";
import { SHAFTS, asksSpeed } from "assur/kinds/gear-train/drives.js";

/**
 * @typedef {import("assur/kinds/gear-train/drives.js").Snapshot} Snapshot
 * @typedef {import("assur/kinds/gear-train/drives.js").Shaft} Shaft
 * @typedef {Snapshot["summary"]["ratios"][number]} Ratio
 * @typedef {import("assur/core/words.js").Words} Words
 */

const HIGH = Object.freeze({ 1: "¹", 3: "³", 4: "⁴" });

/** Coefficients a, a + b, b of a ω₁ + b ω₄ − (a + b) ω₃ = 0, by number of shaft. `STEPPED`: for stepped satellites. */
const WEIGHTS = Object.freeze({ 1: "z₁", 3: "(z₁ + z₄)", 4: "z₄" });
const STEPPED = Object.freeze({ 1: "z₁z₂′", 3: "(z₁z₂′ + z₂z₄)", 4: "z₂z₄" });

export class RatiosView {
  #head = make("tr", {}, ["ratio", "formula", "numbers", "value"].map((name) => make("th", { scope: "col", "data-t": `ratios.${name}` })));
  #body = make("tbody");
  #identities = make("p", { id: "train-identities" });
  #shafts = make("tbody");
  #shown = new Seen();

  constructor() {
    section("gear-train", "ratios.heading", "ratios", [
      wide("ratios.heading", [make("table", { id: "train-ratios", class: "solutions", "data-t-label": "ratios.heading" }, [make("thead", {}, [this.#head]), this.#body])]),
      make("h3", { "data-t": "ratios.identities" }), this.#identities,
      make("h3", { "data-t": "powers.heading" }),
      wide("powers.heading", [make("table", { id: "train-powers", class: "solutions", "data-t-label": "powers.heading" }, [
        make("thead", {}, [make("tr", {}, ["shaft", "torque", "speed", "power"].map((name) => make("th", { scope: "col", "data-t": `powers.${name}` })))]),
        this.#shafts,
      ])]),
    ]);
  }

  /** @param {Snapshot} snapshot */
  render({ state, summary, words, withheld }) {
    if (this.#shown.same(summary, words, withheld)) return;
    const { numbers } = words;
    const weights = state.document.form === "stepped" ? STEPPED : WEIGHTS;
    const hidden = withheld.has("train-ratios");
    const marked = (/** @type {Ratio} */ { largest }) => largest && !withheld.has("train-largest");
    render(summary.ratios.map((ratio) => html`<tr class=${marked(ratio) ? "largest" : ""}>
      <th scope="row">${notation(ratio.name)}${marked(ratio) ? html`<small> ${words.text("ratios.largest")}</small>` : nothing}</th>
      <td>${formula(ratio, weights)}</td>
      <td>${hidden ? "?" : `${numbers.exact(ratio.numerator)}/${numbers.exact(ratio.denominator)}`}</td>
      <td>${hidden ? "?" : numbers.upTo(ratio.value, 5)}</td></tr>`), this.#body);
    const lines = summary.identities.map(({ terms, sum }) => `${terms.map(notation).join(" + ")} = ${numbers.exact(sum)}`);
    render(lines.map((line, i) => html`${i > 0 ? html`<br>` : nothing}${line}`), this.#identities);
    render(/** @type {Shaft[]} */ (Object.keys(SHAFTS)).map((shaft) => html`<tr .style=${`--accent: var(--role-${SHAFTS[shaft].role})`}>
      <th scope="row">${SHAFTS[shaft].number} ${called(shaft, words)}</th>
      ${[summary.torques[shaft], summary.speeds[shaft], summary.powers[shaft]].map((value, column) =>
        html`<td>${column > 0 && asksSpeed(shaft, withheld) ? "?" : numbers.upTo(value, 3)}</td>`)}</tr>`), this.#shafts);
  }
}

/**
 * Makes an area for a table that may be wider than the rail. The area scrolls sideways, also by keys.
 * @param {string} label key of the area's name
 * @param {readonly Node[]} content
 */
function wide(label, content) {
  return make("div", { class: "train-wide", role: "group", tabindex: "0", "data-t-label": label }, content);
}

/**
 * @param {string} name name of a ratio, such as 3/1(4)
 * @returns {string} notation of the ratio, such as U₃₁⁽⁴⁾
 */
export function notation(name) {
  const [, of, to, held] = /^(\d)\/(\d)\((\d)\)$/.exec(name) ?? [];
  return `U${subscript(of + to)}⁽${HIGH[/** @type {"1" | "3" | "4"} */ (held)]}⁾`;
}

/**
 * Writes the formula w_j/w_i of the ratio ω_i/ω_j, with its sign. `weights`: coefficients w without signs, by shaft.
 * @param {Ratio} ratio
 * @param {Readonly<Record<1 | 3 | 4, string>>} weights
 */
function formula({ of, to, numerator }, weights) {
  const [above, below] = [weights[/** @type {1 | 3 | 4} */ (to)], weights[/** @type {1 | 3 | 4} */ (of)]];
  const bare = (/** @type {string} */ text) => (text.includes("+") || text.length < 3 ? text : `(${text})`);
  return `${numerator < 0 ? "−" : ""}${bare(above)}/${bare(below)}`;
}
