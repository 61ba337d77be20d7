// Vector equations for the steps in which the polygons are drawn, with the values known so far.
import { html, nothing } from "assur/core/html.js";
import { measured } from "assur/core/units.js";

/**
 * @typedef {import("assur/types/web.js").PolygonStepHere} Step
 * @typedef {import("assur/types/web.js").LegHere} Leg
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Kinds of addends. `above`: superscript; `across`: whether the addend is perpendicular to its link or guide. */
const LEGS = Object.freeze({
  turning: { above: "", across: true },
  normal: { above: "n", across: false },
  tangential: { above: "t", across: true },
  sliding: { above: "", across: false },
  coriolis: { above: "k", across: true },
  relative: { above: "r", across: false },
});

/**
 * @param {Step} step
 * @param {boolean} done whether the result of the step is known
 * @param {readonly [string, string]} units of velocities and accelerations
 * @param {Words} words
 */
export function describeStep(step, done, units, words) {
  const names = step.found.map(({ name }) => name).join(", ");
  if (step.kind === "pole") return html`<p>${words.text("polygons.pole", { n: names })}</p>`;
  const values = step.found.flatMap((found) => [0, 1].map((order) => {
    const value = amount(found.rates[order], units[order], words);
    return html`<p data-point=${found.name} data-order=${order + 1} data-value=${found.rates[order]}>${letter(order, "", found.name)} = ${value}</p>`;
  }));
  if (step.kind === "group" || step.kind === "image") return html`<p>${words.text(step.kind === "group" ? "polygons.group" : "polygons.image", { n: names })}</p>${values}`;
  const equations = step.legs.map((legs, order) => html`<p>${equation(step, legs, order)}</p>
    <p class="addends">${legs.map((leg, k) => html`${k > 0 ? "; " : ""}${addend(step, leg, order, done, units[order], words)}`)}</p>`);
  return html`${equations}${done ? values : nothing}`;
}

/**
 * @param {number} value
 * @param {string} unit
 * @param {Words} words
 */
export function amount(value, unit, words) {
  const number = words.numbers.short(Math.abs(value) < 1e-12 ? 0 : value);
  return measured(number, unit);
}

/**
 * Makes the letter v or a, with superscript and subscript.
 * @param {number} order
 * @param {string} above
 * @param {string} below
 */
function letter(order, above, below) {
  return html`<i>${order === 0 ? "v" : "a"}</i>${above ? html`<sup>${above}</sup>` : nothing}<sub>${below}</sub>`;
}

/**
 * @param {Step} step
 * @param {readonly Leg[]} legs
 * @param {number} order
 */
function equation({ target, from }, legs, order) {
  const parts = legs.map(({ kind }) => html` + ${letter(order, LEGS[kind].above, `${target}${from}`)}`);
  return html`${letter(order, "", target ?? "")} = ${letter(order, "", from ?? "")}${parts}`;
}

/**
 * Makes the text of an addend: its symbol, its size, if known, and its direction.
 * @param {Step} step
 * @param {Leg} leg
 * @param {number} order
 * @param {boolean} done
 * @param {string} unit
 * @param {Words} words
 */
function addend({ target, from, link }, { kind, length, known }, order, done, unit, words) {
  const { above, across } = LEGS[kind];
  const turns = kind === "turning" || kind === "normal" || kind === "tangential";
  const line = turns ? `${target}${from}` : words.text("polygons.guide", { n: link ?? "" });
  const size = known || done ? ` = ${amount(length, unit, words)}` : "";
  return html`${letter(order, above, `${target}${from}`)}${size} ${across ? "⟂" : "∥"}\u00a0${line}`;
}
