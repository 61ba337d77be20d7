// The plane of the lengths l₂ of the output link and l₃ of the driver. A curve shows the family for two positions. For more
// positions, shades show the sum of squared gaps. Dots show the solutions and the drawn linkage.
import { Plane } from "assur/kinds/synthesis/plane.js";

/**
 * @typedef {import("assur/types/web.js").SynthesisSummary} Summary
 * @typedef {NonNullable<Summary["family"]>["curve"]["verdicts"][number]} Verdict
 * @typedef {import("assur/kinds/synthesis/positions.js").Snapshot} Snapshot
 */

/** Colour and dashes of the parts of the family, by verdict; dashes are for readers who do not see the colours. */
export const LOOKS = Object.freeze(/** @type {Readonly<Record<Verdict, { role: string, dash: readonly number[] }>>} */ ({
  turns: { role: "rocker", dash: [] },
  rocks: { role: "crank", dash: [] },
  disorder: { role: "coupler", dash: [7, 4] },
  branch: { role: "secondary", dash: [2, 4] },
}));

/** Greatest distance, in pixels, at which a pointer picks a point of the curve; unlimited while the pointer is held. */
const PICK_DISTANCE = 24;

export class FamilyMap {
  #plane;
  /** @type {Snapshot | null} */
  #snapshot = null;
  #held = false;

  /**
   * @param {import("assur/canvas/theme.js").Theme} theme
   * @param {(member: [number, number]) => void} choose called with l₂ and l₃ of the chosen member of the family
   */
  constructor(theme, choose) {
    this.#plane = new Plane("synthesis-map", theme, ["l₂", "l₃"], () => this.#paint());
    const { element } = this.#plane;
    this.element = element;
    const take = (/** @type {PointerEvent} */ event) => {
      const member = this.#member(event);
      if (member !== null) choose(member);
    };
    element.addEventListener("pointerdown", (event) => {
      if (event.button !== 0) return;
      element.setPointerCapture(event.pointerId);
      take(event);
      this.#held = true;
    });
    element.addEventListener("pointermove", (event) => {
      if (this.#held) take(event);
    });
    for (const end of ["pointerup", "pointercancel"]) element.addEventListener(end, () => (this.#held = false));
  }

  /** @param {Snapshot} snapshot */
  show(snapshot) {
    this.#snapshot = snapshot;
    const [, l2, l3] = snapshot.summary.drawn.lengths.map((length) => snapshot.words.numbers.short(length));
    this.element.ariaLabel = snapshot.words.text("map.label", { l2, l3 });
    this.#paint();
  }

  /**
   * @param {PointerEvent} event
   * @returns {[number, number] | null} l₂ and l₃ of the nearest member of the family; null if none is near enough
   */
  #member({ offsetX, offsetY }) {
    const curve = this.#snapshot?.summary.family?.curve;
    if (!curve) return null;
    let [nearest, least] = [/** @type {[number, number] | null} */ (null), this.#held ? Infinity : PICK_DISTANCE];
    for (let i = 0; i < curve.l2.length; i++) {
      const [x, y] = this.#plane.at([curve.l2[i], curve.l3[i]]);
      const off = Math.hypot(x - offsetX, y - offsetY);
      if (off < least) [nearest, least] = [[curve.l2[i], curve.l3[i]], off];
    }
    return nearest;
  }

  #paint() {
    if (!this.#snapshot) return;
    const { summary: { frame, family, found, solutions, drawn }, words } = this.#snapshot;
    if (!this.#plane.begin(frame, words)) return;
    if (found) {
      // The smaller the sum, the darker the shade.
      const all = found.sum.values.flat();
      const [low, high] = [Math.min(...all), Math.max(...all)];
      this.#plane.shade(found.sum, (value) => (high - value) / (high - low || 1));
      for (const path of found.paths) this.#plane.line(path, { role: "secondary" });
    }
    if (family) this.#curve(family.curve);
    for (const { lengths: [, l2, l3] } of solutions) this.#plane.dot([l2, l3], "paper");
    this.#plane.dot([drawn.lengths[1], drawn.lengths[2]], "ink");
    this.#plane.end();
  }

  /**
   * Paints the curve of the family, each part in the style of its verdict.
   * @param {NonNullable<Summary["family"]>["curve"]} curve
   */
  #curve({ l2, l3, verdicts }) {
    const points = l2.map((length, i) => [length, l3[i]]);
    for (let start = 0; start < points.length - 1; ) {
      let end = start + 1;
      while (end < points.length - 1 && verdicts[end] === verdicts[start]) end++;
      this.#plane.line(points.slice(start, end + 1), { ...LOOKS[verdicts[start]], width: 3 });
      start = end;
    }
  }
}
