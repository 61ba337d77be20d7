// What is read beside the drawing, while a pointer makes another mechanism in every frame: it is written as often as leaves the hand most
// of the time.
import { whenReleased } from "assur/core/released.js";

/** What takes no longer than this, in milliseconds, has its place in every frame. */
const BRIEF = 3;
/** What takes longer rests so many times as long as it took. */
const REST = 12;

export class Pace {
  /** Of which mechanism it was written last. */
  #revision = 0;
  /** Whether it took long. */
  #long = false;
  /** Until when it rests, in milliseconds. */
  #rests = 0;
  /** @type {{ revision: number, write: () => void } | null} what is written when the frame is over */
  #due = null;
  /** Whether a pointer is down. */
  static #pressed = false;

  static {
    addEventListener("pointerdown", () => (Pace.#pressed = true), true);
    whenReleased(() => (Pace.#pressed = false));
  }

  /**
   * @param {number} revision of the mechanism
   * @param {() => void} write
   * @returns {boolean} whether it is written now, or when this frame is over; if not, it has to be tried again
   */
  keep(revision, write) {
    if (Pace.#pressed && revision !== this.#revision) {
      if (performance.now() < this.#rests) return false;
      if (this.#long) {
        // What is in hand is on the screen first.
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
