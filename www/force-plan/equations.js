// Equations of the steps of a force plan, in symbols and in numbers, and tables of forces.
import { degrees } from "assur/core/angles.js";
import { html, nothing } from "assur/core/html.js";
import { measured } from "assur/core/units.js";
import { amount } from "assur/polygons/equations.js";

/**
 * @typedef {import("assur/types/web.js").ForceStepHere} Step
 * @typedef {import("assur/types/web.js").ForceTermHere} Term
 * @typedef {import("assur/types/web.js").LeverHere} Lever
 * @typedef {import("assur/types/web.js").ActingHere} Acting
 * @typedef {import("assur/types/web.js").AddendHere} Addend
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {Readonly<{ force: string, torque: string, length: string }>} Units
 */

/** Sums of the equations of equilibrium; moments are about a point of the student's choice. */
export const SUMS = Object.freeze(["ΣX", "ΣY", "ΣM"]);
/** Addends smaller than this share of the largest are rounding errors. */
const NEGLIGIBLE = 1e-12;
/** Keys of the titles of steps. */
const TITLES = Object.freeze({
  moments: "force_plan.moments",
  along: "force_plan.along",
  polygon: "force_plan.polygon",
  group: "force_plan.group",
  indeterminate: "force_plan.indeterminate",
});

/**
 * @param {Words} words
 * @param {string} lengths unit of the document's lengths
 * @returns {Units} units of forces, torques and arms; empty in a consistent system without units
 */
export function unitsOf(words, lengths) {
  if (lengths === "none") return { force: "", torque: "", length: "" };
  return { force: words.text("unit.newton"), torque: words.text("unit.newton_metre"), length: words.unit };
}

/**
 * @param {Step} step
 * @param {Words} words
 */
export function titleOf({ kind, links, about, open }, words) {
  return words.text(TITLES[kind], { links: links.join(", "), n: about ?? "", names: open.join(", ") });
}

/**
 * @param {Step} step
 * @param {Units} units
 * @param {Words} words
 */
export function describeStep(step, units, words) {
  const title = html`<p>${titleOf(step, words)}</p>`;
  const { kind, terms } = step;
  if (kind === "moments" || kind === "along") return html`${title}${sumOf(step, units, words)}`;
  const forces = terms.filter(({ couple }) => !couple);
  const known = terms.filter((term) => term.known);
  const sum = forces.length > 0 ? html`<p>${symbols(forces, (term) => mark(term))} = 0</p>` : nothing;
  return html`${title}${kind === "indeterminate" ? nothing : sum}
    <p class="note">${listed(known, units, words)}</p>${terms.filter((term) => !term.known).map((term) => result(term, units, words))}`;
}

/**
 * A sum of moments or of components: in symbols, in numbers, and its result.
 * @param {Step} step
 * @param {Units} units
 * @param {Words} words
 */
function sumOf({ kind, about, terms: all }, units, words) {
  const largest = Math.max(...all.map(({ value }) => Math.abs(value)));
  // Forces through the point have no moment.
  const terms = all.filter(({ known, value }) => !known || Math.abs(value) > NEGLIGIBLE * largest);
  const isMoments = kind === "moments";
  const sign = isMoments ? html`Σ<i>M</i><sub>${about}</sub>` : html`Σ<i>F</i><sub>∥</sub>`;
  const symbol = (/** @type {Term} */ term) => (term.couple || !isMoments ? mark(term) : html`${mark(term)}·<i>h</i>`);
  const addend = (/** @type {Term} */ term) => {
    if (term.couple) return term.known ? amount(Math.abs(term.value), units.torque, words) : mark(term);
    if (!isMoments) return term.known ? amount(Math.abs(term.value), units.force, words) : mark(term);
    const arm = amount(Math.abs(term.arm ?? 0), units.length, words);
    return html`${term.known ? amount(term.size, units.force, words) : mark(term)}·${arm}`;
  };
  const numbers = terms.map((term, k) => {
    const minus = term.known && term.value < 0;
    return html`${k > 0 ? (minus ? " − " : " + ") : minus ? "−" : ""}${addend(term)}`;
  });
  const found = terms.filter((term) => !term.known);
  return html`<p>${sign} = ${symbols(terms, symbol)} = 0</p>${terms.length > 1 ? html`<p class="note">${numbers} = 0</p>` : nothing}
    ${found.map((term) => result({ ...term, size: term.couple ? term.value : Math.sign(term.value) * term.size }, units, words, false))}`;
}

/**
 * @param {readonly Term[]} terms
 * @param {(term: Term) => unknown} one
 */
function symbols(terms, one) {
  return terms.map((term, k) => html`${k > 0 ? " + " : ""}${one(term)}`);
}

/** @param {Term} term */
function mark({ symbol, known }) {
  return known ? symbol : html`<u>${symbol}</u>`;
}

/**
 * @param {readonly Term[]} terms
 * @param {Units} units
 * @param {Words} words
 */
function listed(terms, units, words) {
  return terms.map(({ symbol, couple, size }) => `${symbol} = ${amount(size, couple ? units.torque : units.force, words)}`).join("; ");
}

/**
 * Result of a step: the size of a force or couple; for a force also its direction.
 * @param {Term} term
 * @param {Units} units
 * @param {Words} words
 * @param {boolean} [directed]
 */
function result({ symbol, couple, size, direction }, units, words, directed = true) {
  const angle = directed && !couple && size > 0 ? `, ${angleOf(direction, words)}` : "";
  return html`<p class="found" data-force=${symbol} data-value=${size}>${symbol} = ${amount(size, couple ? units.torque : units.force, words)}${angle}</p>`;
}

/**
 * @param {number} direction in radians
 * @param {Words} words
 */
function angleOf(direction, words) {
  return `∠\u00a0${words.numbers.fixed(degrees(direction), 1)}°`;
}

/**
 * @param {Lever} lever
 * @param {Units} units
 * @param {Words} words
 */
export function leverTable({ terms, sum, symbol, turns, by_lever: lever, by_reactions: reactions }, units, words) {
  const unit = turns ? units.torque : units.force;
  const arms = turns ? units.length : "";
  const rows = terms.map((term) => html`<tr><td>${term.symbol}</td><td>${amount(term.size, term.couple ? units.torque : units.force, words)}</td>
    <td>${term.arm === null ? "" : amount(term.arm, arms, words)}</td><td>${amount(term.value, unit, words)}</td></tr>`);
  const line = (/** @type {string} */ way, /** @type {string} */ said, /** @type {number | null} */ value) => (value === null ? nothing
    : html`<p data-lever=${way} data-value=${value}>${said} ${symbol} = ${amount(value, unit, words)}</p>`);
  const difference = lever !== null && reactions !== null ? html`<p data-lever="difference" data-value=${lever - reactions}>${words.text("force_plan.difference")} ${precise(lever - reactions, unit, words)}</p>` : nothing;
  return html`<div class="amounts"><table><thead><tr><th>${words.text("force_plan.force")}</th><th>${words.text("force_plan.size")}</th>
    <th>${words.text("force_plan.arm")}</th><th>${words.text("force_plan.moment")}</th></tr></thead><tbody>${rows}</tbody></table></div>
    <p>Σ<i>M</i><sub>p</sub> = ${amount(sum, unit, words)}</p>${line("lever", words.text("force_plan.by_lever"), lever)}${line("plan", words.text("force_plan.by_reactions"), reactions)}${difference}`;
}

/**
 * A number that may be a rounding error, which `amount` would write as zero.
 * @param {number} value
 * @param {string} unit
 * @param {Words} words
 */
function precise(value, unit, words) {
  return measured(value === 0 ? "0" : words.numbers.short(value), unit);
}

/**
 * @param {readonly Acting[]} acting
 * @param {Units} units
 * @param {Words} words
 */
export function freeBodyTable(acting, units, words) {
  const cell = (/** @type {number | null} */ value, /** @type {string} */ unit) => (value === null ? "?" : amount(value, unit, words));
  const rows = acting.map(({ symbol, couple, x, y, size, direction }) => html`<tr data-force=${symbol}><td>${symbol}</td>
    <td>${couple ? "" : cell(x, units.force)}</td><td>${couple ? "" : cell(y, units.force)}</td>
    <td>${cell(size, couple ? units.torque : units.force)}</td><td>${direction === null ? "" : angleOf(direction, words)}</td></tr>`);
  return html`<table><thead><tr><th>${words.text("force_plan.force")}</th><th>x</th><th>y</th><th>${words.text("force_plan.size")}</th><th>${words.text("force_plan.direction")}</th></tr></thead><tbody>${rows}</tbody></table>`;
}

/**
 * The equations of equilibrium in the chosen senses, and the unknowns that follow from them. A negative unknown acts in
 * the opposite sense.
 * @param {readonly Addend[]} addends
 * @param {string} about point of moments
 * @param {Units} units
 * @param {Words} words
 */
export function equilibriumOf(addends, about, units, words) {
  const equations = SUMS.map((sum, k) => {
    const terms = addends.filter(({ factors }) => factors[k] !== 0);
    const written = terms.map(({ symbol, direction, factors }, i) => {
      const [factor, size] = [factors[k], Math.abs(factors[k])];
      const by = Math.abs(size - 1) < NEGLIGIBLE ? "" : `·${amount(size, k === 2 && direction !== null ? units.length : "", words)}`;
      return `${factor < 0 ? (i > 0 ? " − " : "−") : i > 0 ? " + " : ""}${symbol}${by}`;
    });
    return html`<p>${sum}${k === 2 ? html`<sub>${about}</sub>` : nothing} = ${written.join("") || "0"}${written.length > 0 ? " = 0" : nothing}</p>`;
  });
  const sizes = addends.map(({ symbol, unknown, direction, size }) => {
    const unit = direction === null ? units.torque : units.force;
    const value = size === null ? "?" : amount(size, unit, words);
    return html`<p class=${unknown === null ? "note" : "found"} data-force=${symbol} data-value=${size ?? ""}>${symbol} = ${value}</p>`;
  });
  return html`${equations}${sizes}`;
}
