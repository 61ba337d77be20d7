// Animation of a chain that falls open where a pair is cut.

/** @typedef {import("assur/state/model.js").OwnSnapshot<"scheme">} Snapshot */

/** Duration of the animation, in milliseconds. */
const LASTS = 700;

export class Opening {
  #page;
  /** @type {Snapshot["state"]["document"] | null} document shown last */
  #document = null;
  #begun = 0;
  #handle = 0;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
  }

  /** @param {Snapshot} snapshot */
  render({ state: { document } }) {
    const before = this.#document;
    if (before === document) return;
    this.#document = document;
    cancelAnimationFrame(this.#handle);
    const more = before !== null && before.pairs === document.pairs && document.cut.length === before.cut.length + 1 && before.cut.every((name, i) => name === document.cut[i]);
    if (!more || matchMedia("(prefers-reduced-motion: reduce)").matches) {
      this.#open(1);
      return;
    }
    this.#begun = performance.now();
    this.#open(0);
    this.#handle = requestAnimationFrame(this.#frame);
  }

  #frame = (/** @type {number} */ now) => {
    const share = Math.min(Math.max((now - this.#begun) / LASTS, 0), 1);
    // The motion is slow at both ends.
    this.#open(share * share * (3 - 2 * share));
    if (share < 1) this.#handle = requestAnimationFrame(this.#frame);
  };

  /** @param {number} share of the full opening, from 0 to 1 */
  #open(share) {
    this.#page.model.fallOpen(share);
    this.#page.redraw();
  }
}
