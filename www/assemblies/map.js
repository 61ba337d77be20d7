// Map of all branches: the output plotted against the input, with folds, crossings and the current assemblies.
import { makeSvg } from "assur/core/dom.js";
import { render, svg } from "assur/core/html.js";

/** @typedef {{ input: number, shown: number | null, angles: readonly number[] }} Now */

/** `SIZE`: side of the square with the branches, in units of the view box. `LEFT`, `BELOW`: space for its scales. */
const SIZE = 300;
const LEFT = 42;
const BELOW = 26;
/** `BEYOND`, `TOP`: space to the right and above, for half of the last number of each scale. */
const BEYOND = 18;
const TOP = 8;
const TURN = 2 * Math.PI;
/** Colour roles of the circuits in order, repeated for further circuits. */
const COLOURS = ["crank", "coupler", "rocker", "accent1", "accent2", "accent3", "accent4", "accent5", "accent6", "accent7"];

export class BranchMap {
  #branches = makeSvg("g");
  #now = makeSvg("g");
  #scale = makeSvg("g", { class: "map-scale" });
  /** Language of the drawn map. */
  lang = "";
  #from = 0;
  #to = TURN;

  /** @param {(input: number, output: number) => void} chosen called at a click, with the input and the output there */
  constructor(chosen) {
    this.element = makeSvg("svg", { id: "assembly-map", class: "assembly-map", viewBox: `0 0 ${LEFT + SIZE + BEYOND} ${TOP + SIZE + BELOW}`, role: "img" });
    this.element.append(this.#scale, this.#branches, this.#now);
    this.element.addEventListener("click", ({ clientX, clientY }) => {
      const { left, top, width, height } = this.element.getBoundingClientRect();
      const x = ((clientX - left) / width) * (LEFT + SIZE + BEYOND) - LEFT;
      const y = ((clientY - top) / height) * (TOP + SIZE + BELOW) - TOP;
      const [across, up] = [x / SIZE, 1 - y / SIZE];
      if (across >= 0 && across <= 1 && up >= 0 && up <= 1) chosen(this.#from + across * (this.#to - this.#from), up * TURN);
    });
  }

  /**
   * @param {import("assur/types/web.js").MotionsMap} map
   * @param {{ turns: boolean, range: readonly [number, number], input: string, output: string, numbers: import("assur/core/numbers.js").Numbers }} axis
   */
  draw(map, { turns, range, input, output, numbers }) {
    [this.#from, this.#to] = turns ? [0, TURN] : range;
    render(this.#scales(turns, input, output, numbers), this.#scale);
    const lines = map.branches.map(({ circuit, pieces }, branch) =>
      svg`<path d=${pieces.map((piece) => this.#path(piece)).join(" ")} data-branch=${branch} data-circuit=${circuit} .style=${`stroke: ${colour(circuit)}`}></path>`);
    const meetings = map.meetings.map(({ kind, branches, input: at, output: angle }) => {
      const [x, y] = this.#onMap(at, angle);
      const own = colour(map.branches[branches[0]].circuit);
      return svg`<circle cx=${x} cy=${y} r="4" class=${kind} .style=${`stroke: ${own}${kind === "fold" ? `; fill: ${own}` : ""}`}></circle>`;
    });
    render([lines, meetings], this.#branches);
  }

  /**
   * @param {Now} now
   * @param {number | null} branch index of the branch with the shown assembly; null if unknown
   */
  mark({ input, shown, angles }, branch) {
    for (const line of this.#branches.querySelectorAll("path")) line.classList.toggle("shown", branch !== null && line.getAttribute("data-branch") === String(branch));
    const along = this.#to - this.#from === TURN ? ((input % TURN) + TURN) % TURN : input;
    const [x] = this.#onMap(along, 0);
    render(svg`<line x1=${x} x2=${x} y1=${TOP} y2=${TOP + SIZE} class="map-now"></line>${angles.map((angle, k) =>
      svg`<circle cx=${x} cy=${this.#onMap(along, angle)[1]} r=${k === shown ? 6 : 3.5} class=${k === shown ? "map-shown" : "map-other"}></circle>`)}`, this.#now);
  }

  /** @param {readonly number[]} piece */
  #path(piece) {
    const points = [];
    for (let at = 0; at < piece.length; at += 2) points.push(this.#onMap(piece[at], piece[at + 1]).join(" "));
    return `M${points.join("L")}`;
  }

  /**
   * @param {number} input
   * @param {number} output
   */
  #onMap(input, output) {
    const x = LEFT + (SIZE * (input - this.#from)) / (this.#to - this.#from);
    const y = TOP + SIZE * (1 - output / TURN);
    return [x.toFixed(2), y.toFixed(2)];
  }

  /**
   * @param {boolean} turns
   * @param {string} input
   * @param {string} output
   * @param {import("assur/core/numbers.js").Numbers} numbers
   */
  #scales(turns, input, output, numbers) {
    const parts = [svg`<rect x=${LEFT} y=${TOP} width=${SIZE} height=${SIZE}></rect>`];
    const line = (/** @type {number} */ x1, /** @type {number} */ x2, /** @type {number} */ y1, /** @type {number} */ y2) => parts.push(svg`<line x1=${x1} x2=${x2} y1=${y1} y2=${y2}></line>`);
    const text = (/** @type {string} */ said, /** @type {number} */ x, /** @type {number} */ y, anchor = "middle") => parts.push(svg`<text x=${x} y=${y} text-anchor=${anchor}>${said}</text>`);
    for (let quarter = 0; quarter <= 4; quarter++) {
      const at = TOP + SIZE * (1 - quarter / 4);
      const left = LEFT + (SIZE * quarter) / 4;
      line(LEFT, LEFT + SIZE, at, at);
      line(left, left, TOP, TOP + SIZE);
      // At three quarters of each scale, the name of the axis stands in place of a number.
      const up = quarter === 3 ? output : `${90 * quarter}°`;
      const value = this.#from + ((this.#to - this.#from) * quarter) / 4;
      const across = turns ? `${90 * quarter}°` : numbers.upTo(value, 2);
      text(up, LEFT - 5, at + 5, "end");
      text(quarter === 3 ? input : across, left, TOP + SIZE + BELOW - 6);
    }
    return parts;
  }
}

/** @param {number} circuit */
function colour(circuit) {
  return `var(--role-${COLOURS[circuit % COLOURS.length]})`;
}
