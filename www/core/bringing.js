// Parts of the page that are loaded when they are asked for: one that did not arrive is asked for again, but not in every frame.

/** After a failure a part is asked for again no sooner, in milliseconds. */
const PAUSE = 5000;

export class Bringing {
  #failed;
  #changed;
  #now;
  /** @type {Map<string, number>} when a part may be asked for again; Infinity while it is on its way or once it is there */
  #due = new Map();

  /**
   * @param {() => void} changed called when a part has arrived, or may be asked for again
   * @param {() => void} failed called when one has not arrived
   * @param {() => number} [now] milliseconds
   */
  constructor(changed, failed, now = () => performance.now()) {
    this.#changed = changed;
    this.#failed = failed;
    this.#now = now;
    addEventListener("online", () => this.#again());
  }

  /**
   * Loads a part, unless it is there, on its way or has just failed.
   * @param {string} name
   * @param {() => Promise<void>} load puts it in its place
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

  /** What has failed is asked for with the next state that is shown. */
  #again() {
    for (const [name, due] of this.#due) if (due !== Infinity) this.#due.delete(name);
    this.#changed();
  }
}
