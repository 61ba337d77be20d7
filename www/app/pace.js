// What is read beside the drawing, while a pointer makes another mechanism in every frame: it is written as often as leaves the hand most
// of the time.

/** What takes no longer than this, in milliseconds, has its place in every frame. */
const BRIEF = 3;
/** What takes longer rests so many times as long as it took. */
const REST = 12;

export class Pace {
  /** Of which mechanism it was written last. */
  #revision = 0;
  /** Until when it rests, in milliseconds. */
  #rests = 0;
  /** Whether a pointer is down. */
  static #pressed = false;

  static {
    addEventListener("pointerdown", () => (Pace.#pressed = true), true);
    for (const end of ["pointerup", "pointercancel"]) addEventListener(end, () => (Pace.#pressed = false), true);
  }

  /**
   * @param {number} revision of the mechanism
   * @param {() => void} write
   * @returns {boolean} whether it was written; if not, it has to be tried again
   */
  keep(revision, write) {
    const begun = performance.now();
    if (Pace.#pressed && revision !== this.#revision && begun < this.#rests) return false;
    write();
    const written = performance.now();
    const took = written - begun;
    this.#revision = revision;
    this.#rests = took > BRIEF ? written + REST * took : 0;
    return true;
  }
}
