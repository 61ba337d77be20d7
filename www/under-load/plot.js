// Plots of lines with scales, as templates.
import { html, svg } from "assur/core/html.js";

/**
 * @typedef {Readonly<{ points: readonly (readonly [number, number])[], role: string, name: string, dashed?: boolean }>} Line
 * `role`: colour; `name`: shown in the legend, unless it is empty
 * @typedef {Readonly<{ id: string, across: string, up: string, lines: readonly Line[], numbers: import("assur/core/numbers.js").Numbers, marks?: readonly (readonly [number, number])[] }>} Plot
 * `across`, `up`: names of the axes with their units; `marks`: points with a dot
 */

const [WIDTH, HEIGHT] = [340, 200];
const [LEFT, RIGHT, TOP, BELOW] = [46, 10, 10, 22];
/** Usual number of intervals of a scale. */
const INTERVALS = 4;

/**
 * @param {number} from
 * @param {number} to
 * @returns {number[]} round numbers of a scale, from `from` to `to`
 */
export function scale(from, to) {
  const rough = (to - from) / INTERVALS;
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((size) => size * power).find((size) => size >= rough * 0.999) ?? rough;
  const first = Math.ceil(from / step - 1e-9);
  const count = Math.floor(to / step + 1e-9) - first + 1;
  return Array.from({ length: Math.max(count, 0) }, (_, k) => (first + k) * step);
}

/**
 * @param {readonly number[]} values
 * @returns {[number, number]} least and greatest value, apart from each other
 */
function ends(values) {
  const known = values.filter(Number.isFinite);
  const from = known.reduce((least, value) => Math.min(least, value), Infinity);
  const to = known.reduce((most, value) => Math.max(most, value), -Infinity);
  if (known.length === 0) return [0, 1];
  const least = 1e-9 * Math.max(Math.abs(from), Math.abs(to), 1e-9);
  return to - from > least ? [from, to] : [from - Math.max(Math.abs(from), 1) / 2, to + Math.max(Math.abs(to), 1) / 2];
}

/** @param {Plot} plot */
export function plot({ id, across, up, lines, numbers, marks = [] }) {
  const all = [...lines.flatMap(({ points }) => points), ...marks];
  const [left, right] = ends(all.map(([x]) => x));
  const [low, high] = ends(all.map(([, y]) => y));
  const x = (/** @type {number} */ value) => LEFT + ((value - left) / (right - left)) * (WIDTH - LEFT - RIGHT);
  const y = (/** @type {number} */ value) => HEIGHT - BELOW - ((value - low) / (high - low)) * (HEIGHT - TOP - BELOW);
  const at = (/** @type {readonly [number, number]} */ [one, other]) => `${x(one).toFixed(1)} ${y(other).toFixed(1)}`;
  const colour = (/** @type {string} */ role) => `color: var(--role-${role})`;
  const named = lines.filter(({ name }) => name !== "");
  return html`<figure class="load-plot" id=${id}>
    <svg viewBox="0 0 ${WIDTH} ${HEIGHT}" role="img" aria-label="${up}; ${across}">
      ${scale(left, right).map((value) => svg`<line class="grid" x1=${x(value)} x2=${x(value)} y1=${TOP} y2=${HEIGHT - BELOW}></line><text x=${x(value)} y=${HEIGHT - 7} text-anchor="middle">${numbers.short(value)}</text>`)}
      ${scale(low, high).map((value) => svg`<line class="grid" x1=${LEFT} x2=${WIDTH - RIGHT} y1=${y(value)} y2=${y(value)}></line><text x=${LEFT - 4} y=${y(value) + 4} text-anchor="end">${numbers.short(value)}</text>`)}
      ${lines.map(({ points, role, dashed }) => svg`<path class=${dashed ? "dashed" : "line"} .style=${colour(role)} d=${points.length > 1 ? `M ${points.map(at).join(" L ")}` : ""}></path>`)}
      ${marks.map((mark) => svg`<circle cx=${x(mark[0])} cy=${y(mark[1])} r="4" fill="currentcolor"></circle>`)}
    </svg>
    <figcaption><span>${up}</span><span>${across}</span>${named.map(({ name, role }) => html`<span class="load-key" .style=${colour(role)}><span>${name}</span></span>`)}</figcaption>
  </figure>`;
}
