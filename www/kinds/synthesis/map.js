// The plane of the output's and the input's length, both on logarithmic scales: the family of two positions as a curve, the sum of
// squares of more positions as a shade, the solutions and the one that is drawn as points.
import { Surface } from "assur/canvas/surface.js";
import { make } from "assur/core/dom.js";

/**
 * @typedef {import("assur/types/web.js").SynthesisSummary} Summary
 * @typedef {NonNullable<Summary["family"]>["curve"]["verdicts"][number]} Verdict
 * @typedef {import("assur/kinds/synthesis/positions.js").Snapshot} Snapshot
 * @typedef {import("assur/canvas/theme.js").Theme} Theme
 * @typedef {{ across: (length: number) => number, down: (length: number) => number }} Scales pixels of lengths
 */

/** Room for the numbers of the axes, in pixels. */
const MARGIN = Object.freeze({ left: 34, bottom: 30, top: 10, right: 10 });

/** Lengths relative to the frame at which lines are drawn. */
const LINES = Object.freeze([0.1, 0.3, 1, 3, 10]);

/** How the parts of the family are drawn, by their verdict: colour and dashes, as colour alone is not seen by all. */
export const LOOKS = Object.freeze(/** @type {Readonly<Record<Verdict, { role: string, dash: readonly number[] }>>} */ ({
  turns: { role: "rocker", dash: [] },
  rocks: { role: "crank", dash: [] },
  disorder: { role: "coupler", dash: [7, 4] },
  branch: { role: "secondary", dash: [2, 4] },
}));

/** So near the curve a pointer takes it, in pixels. */
const REACH = 24;
const DOT = 6;

/** In so many steps the sum of squares is shaded, up to this strength. */
const STEPS = 12;
const DARKEST = 0.75;

export class FamilyMap {
  #canvas = make("canvas", { id: "synthesis-map", class: "map", role: "img" });
  #surface;
  #theme;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #held = false;
  element = this.#canvas;

  /**
   * @param {Theme} theme
   * @param {(member: [number, number]) => void} choose a member of the family, by l₂ and l₃
   */
  constructor(theme, choose) {
    this.#theme = theme;
    this.#surface = new Surface(this.#canvas, () => this.#paint());
    const take = (/** @type {PointerEvent} */ event) => {
      const member = this.#member(event);
      if (member !== null) choose(member);
    };
    this.#canvas.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      this.#held = true;
      this.#canvas.setPointerCapture(event.pointerId);
      take(event);
    });
    this.#canvas.addEventListener("pointermove", (event) => {
      if (this.#held) take(event);
    });
    for (const end of ["pointerup", "pointercancel"]) this.#canvas.addEventListener(end, () => (this.#held = false));
  }

  /** @param {Snapshot} snapshot */
  show(snapshot) {
    this.#snapshot = snapshot;
    const [, l2, l3] = snapshot.summary.drawn.lengths.map((length) => snapshot.words.numbers.short(length));
    this.#canvas.ariaLabel = snapshot.words.text("map.label", { l2, l3 });
    this.#paint();
  }

  /** @returns {Scales | null} */
  #scales() {
    if (!this.#snapshot) return null;
    const { frame } = this.#snapshot.summary;
    const [least, most] = [LINES[0], LINES[LINES.length - 1]].map(Math.log);
    const { width, height } = this.#surface;
    const [wide, high] = [width - MARGIN.left - MARGIN.right, height - MARGIN.top - MARGIN.bottom];
    const part = (/** @type {number} */ length) => (Math.log(length / frame) - least) / (most - least);
    return {
      across: (length) => MARGIN.left + wide * part(length),
      down: (length) => MARGIN.top + high * (1 - part(length)),
    };
  }

  /**
   * @param {PointerEvent} event
   * @returns {[number, number] | null} l₂ and l₃ of the member of the family that is drawn next to a place
   */
  #member({ offsetX: x, offsetY: y }) {
    const scales = this.#scales();
    const curve = this.#snapshot?.summary.family?.curve;
    if (!scales || !curve) return null;
    let [nearest, least] = [/** @type {[number, number] | null} */ (null), this.#held ? Infinity : REACH];
    for (let i = 0; i < curve.l2.length; i++) {
      const off = Math.hypot(scales.across(curve.l2[i]) - x, scales.down(curve.l3[i]) - y);
      if (off < least) [nearest, least] = [[curve.l2[i], curve.l3[i]], off];
    }
    return nearest;
  }

  #paint() {
    const [snapshot, scales] = [this.#snapshot, this.#scales()];
    if (!snapshot || !scales || !this.#surface.begin()) return;
    this.#surface.clear();
    const { context, width, height } = this.#surface;
    const { colours, font, weight } = this.#theme;
    const { summary, words } = snapshot;
    const { frame } = summary;
    const bottom = height - MARGIN.bottom;
    context.font = `12px ${font}`;
    context.lineWidth = weight;
    context.strokeStyle = colours.line;
    context.fillStyle = colours.secondary;
    for (const line of LINES) {
      const [x, y] = [scales.across(line * frame), scales.down(line * frame)];
      stroke(context, [[x, MARGIN.top], [x, bottom]]);
      stroke(context, [[MARGIN.left, y], [width - MARGIN.right, y]]);
      const text = words.numbers.short(line * frame);
      context.textAlign = "center";
      context.textBaseline = "top";
      context.fillText(text, x, bottom + 3);
      context.textAlign = "right";
      context.textBaseline = "middle";
      context.fillText(text, MARGIN.left - 4, y);
    }
    context.textAlign = "right";
    context.textBaseline = "bottom";
    context.fillText("l₂", width - MARGIN.right, height);
    context.textAlign = "left";
    context.textBaseline = "top";
    context.fillText("l₃", MARGIN.left + 4, MARGIN.top);
    context.save();
    context.beginPath();
    context.rect(MARGIN.left, MARGIN.top, width - MARGIN.left - MARGIN.right, bottom - MARGIN.top);
    context.clip();
    this.#surfaceOf(summary, scales);
    this.#curve(context, scales, summary);
    for (const path of summary.found?.paths ?? []) {
      context.strokeStyle = colours.secondary;
      context.setLineDash([]);
      stroke(context, path.map(([l2, l3]) => [scales.across(l2), scales.down(l3)]));
    }
    const dot = (/** @type {readonly number[]} */ [, l2, l3], /** @type {string} */ fill) => {
      context.beginPath();
      context.arc(scales.across(l2), scales.down(l3), DOT * weight, 0, 2 * Math.PI);
      context.fillStyle = fill;
      context.fill();
      context.strokeStyle = colours.ink;
      context.stroke();
    };
    for (const { lengths } of summary.solutions) dot(lengths, colours.paper);
    dot(summary.drawn.lengths, colours.ink);
    context.restore();
  }

  /**
   * ΣJ in steps, the darker the less.
   * @param {Summary} summary
   * @param {Scales} scales
   */
  #surfaceOf({ found }, { across, down }) {
    if (!found) return;
    const { bounds: [least, most], surface } = found;
    const all = surface.flat();
    const [low, high] = [Math.min(...all), Math.max(...all)];
    const { context } = this.#surface;
    context.fillStyle = this.#theme.colours.crank;
    const at = (/** @type {number} */ part) => least * (most / least) ** (part / surface.length);
    surface.forEach((row, i) => row.forEach((value, j) => {
      const step = Math.floor((STEPS * (high - value)) / (high - low || 1));
      context.globalAlpha = (DARKEST * Math.min(step, STEPS - 1)) / STEPS;
      const [left, right, bottom, top] = [across(at(i)), across(at(i + 1)), down(at(j)), down(at(j + 1))].map(Math.round);
      context.fillRect(left, top, right - left, bottom - top);
    }));
    context.globalAlpha = 1;
  }

  /**
   * The family, each part by its verdict.
   * @param {CanvasRenderingContext2D} context
   * @param {Scales} scales
   * @param {Summary} summary
   */
  #curve(context, { across, down }, { family }) {
    if (!family) return;
    const { l2, l3, verdicts } = family.curve;
    context.lineWidth = 3 * this.#theme.weight;
    for (let start = 0; start < l2.length - 1; ) {
      let end = start + 1;
      while (end < l2.length - 1 && verdicts[end] === verdicts[start]) end++;
      const { role, dash } = LOOKS[verdicts[start]];
      context.strokeStyle = this.#theme.colours[role];
      context.setLineDash([...dash]);
      stroke(context, Array.from({ length: end - start + 1 }, (_, i) => [across(l2[start + i]), down(l3[start + i])]));
      start = end;
    }
    context.setLineDash([]);
    context.lineWidth = this.#theme.weight;
  }
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {readonly (readonly number[])[]} points
 */
function stroke(context, points) {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  context.stroke();
}
