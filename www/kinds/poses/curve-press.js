// A press on a curve of four poses: the pressed point of the curve replaces the nearer hinge.
import { byId } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { inputNow, take } from "assur/state/change.js";

/** Name by which the engine takes a press on a curve. */
const CURVE = "curve";

/** `STILL`: greatest movement of a press. `CLEAR`: least distance of a press from a handle. In pixels. */
const STILL = 4;
const CLEAR = 18;

/** Number of poses that have curves. */
const POSES = 4;

export class CurvePress {
  #page;
  /** Whether the document has curves. */
  #has = false;
  /** @type {{ x: number, y: number } | null} */
  #from = null;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    const canvas = byId("mechanism", HTMLCanvasElement);
    canvas.addEventListener("pointerdown", ({ button, offsetX: x, offsetY: y }) => {
      this.#from = button === 0 && page.store.get().kind === "poses" && this.#has && !page.mechanism.near({ x, y }, CLEAR) ? { x, y } : null;
    });
    canvas.addEventListener("pointerup", ({ offsetX: x, offsetY: y }) => {
      const from = this.#from;
      this.#from = null;
      if (from && Math.hypot(x - from.x, y - from.y) <= STILL) this.#press(x, y);
    });
  }

  /** @param {import("assur/kinds/poses/task.js").Snapshot} snapshot */
  render({ state: { document: { poses } }, summary: { repeated } }) {
    this.#has = poses.length - repeated.length === POSES;
  }

  /**
   * @param {number} left pixels
   * @param {number} top
   */
  #press(left, top) {
    const page = this.#page;
    const [x, y] = page.mechanism.view.toModel(left, top);
    const change = attempt(() => page.engine.simulator.drag(CURVE, inputNow(page), x, y)).value;
    if (change?.document) take(change, page);
  }
}
