// Pacing of the views other than the drawing while a pointer or key changes the mechanism, so that the drawing keeps up with the pointer.
import { whenReleased } from "assur/core/released.js";

/** Least pause after a write, as a multiple of the time that the write took. */
const REST = 12;

export class Pace {
  /** Revision of the mechanism that the views show. */
  #revision = 0;
  /** Time at which the pause ends, in milliseconds on the clock of `performance.now`. */
  #rests = 0;
  #period;
  /** Whether a pointer or a repeating key is down. */
  static #held = false;

  static {
    addEventListener("pointerdown", () => (Pace.#held = true), true);
    addEventListener("keydown", ({ repeat }) => (Pace.#held ||= repeat), true);
    addEventListener("keyup", () => (Pace.#held = false), true);
    whenReleased(() => (Pace.#held = false));
  }

  /** @param {number} period least time from the end of one write to the next during a change by hand, in milliseconds */
  constructor(period) {
    this.#period = period;
  }

  /**
   * Writes the views, unless they are in a pause.
   * @param {number} revision of the mechanism
   * @param {() => void} write
   * @returns {boolean} false if the views are not written; the caller then tries again in the next frame
   */
  run(revision, write) {
    const begun = performance.now();
    if (Pace.#held && revision !== this.#revision && begun < this.#rests) return false;
    write();
    const written = performance.now();
    this.#revision = revision;
    this.#rests = written + Math.max(this.#period, REST * (written - begun));
    return true;
  }
}
