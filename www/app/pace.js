// Pacing of the views other than the drawing. During a drag that changes the mechanism, the drawing gets most of the
// time.
import { whenReleased } from "assur/core/released.js";

/** Longest writing time of the views, in milliseconds, at which they are written in every frame of a drag. */
const BRIEF = 3;
/** Pause after views that took longer than `BRIEF` to write, as a multiple of their writing time. */
const REST = 12;

export class Pace {
  /** Revision of the mechanism that the views show. */
  #revision = 0;
  /** Whether the views last took longer than `BRIEF` to write. */
  #long = false;
  /** Time at which the pause ends, in milliseconds on the clock of `performance.now`. */
  #rests = 0;
  /** @type {{ revision: number, write: () => void } | null} views to be written after the frame */
  #due = null;
  /** Whether a pointer is down. */
  static #pressed = false;

  static {
    addEventListener("pointerdown", () => (Pace.#pressed = true), true);
    whenReleased(() => (Pace.#pressed = false));
  }

  /**
   * Writes the views now, after this frame, or not yet.
   * @param {number} revision of the mechanism
   * @param {() => void} write
   * @returns {boolean} false if the views are not written yet; the caller then tries again
   */
  run(revision, write) {
    if (Pace.#pressed && revision !== this.#revision) {
      if (performance.now() < this.#rests) return false;
      if (this.#long) {
        // The dragged drawing reaches the screen first.
        if (!this.#due) setTimeout(() => this.#end());
        this.#due = { revision, write };
        return true;
      }
    }
    this.#due = null;
    this.#write(revision, write);
    return true;
  }

  #end() {
    const due = this.#due;
    this.#due = null;
    if (due) this.#write(due.revision, due.write);
  }

  /**
   * @param {number} revision
   * @param {() => void} write
   */
  #write(revision, write) {
    const begun = performance.now();
    write();
    const written = performance.now();
    const took = written - begun;
    this.#revision = revision;
    this.#long = took > BRIEF;
    this.#rests = this.#long ? written + REST * took : 0;
  }
}
