// Parts of the page that are loaded on demand. A part that failed to load is requested again, but not in every frame.

/** Shortest time between a failure and the next request, in milliseconds. */
const PAUSE = 5000;

export class Bringing {
  #failed;
  #changed;
  #now;
  /** @type {Map<string, number>} earliest time of the next request for each part; Infinity once the part is loading or loaded */
  #due = new Map();

  /**
   * @param {() => void} changed called when a part has loaded or may be requested again
   * @param {() => void} failed called when a part has failed to load
   * @param {() => number} [now] clock, in milliseconds
   */
  constructor(changed, failed, now = () => performance.now()) {
    this.#changed = changed;
    this.#failed = failed;
    this.#now = now;
    addEventListener("online", () => this.#again());
  }

  /**
   * Loads a part, unless it has loaded, is loading or has just failed to load.
   * @param {string} name
   * @param {() => Promise<void>} load loads the part and puts it in its place
   */
  async bring(name, load) {
    if (this.#now() < (this.#due.get(name) ?? 0)) return;
    this.#due.set(name, Infinity);
    try {
      await load();
      this.#changed();
    } catch {
      this.#due.set(name, this.#now() + PAUSE);
      this.#failed();
    }
  }

  /** Forgets failures, so that the parts that failed to load are requested again with the next state shown. */
  #again() {
    for (const [name, due] of this.#due) if (due !== Infinity) this.#due.delete(name);
    this.#changed();
  }
}
