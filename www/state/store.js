// Store of the page's state. Nothing else holds the state.

/**
 * Holder of an immutable value; every change replaces the value.
 * @template T
 */
export class Store {
  /** @type {T} */
  #state;
  /** @type {Set<(state: T, previous: T) => void>} */
  #listeners = new Set();

  #limit;

  /**
   * @param {T} state
   * @param {(next: T, now: T) => T} [limit] returns the value to take, given the changed value and the current one
   */
  constructor(state, limit = (next) => next) {
    this.#state = state;
    this.#limit = limit;
  }

  /** @returns {T} */
  get() {
    return this.#state;
  }

  /** @param {(state: T) => T} change returns the same value if nothing changes */
  update(change) {
    this.put(this.#limit(change(this.#state), this.#state));
  }

  /** @param {T} next value from outside, taken without a limit */
  put(next) {
    const previous = this.#state;
    if (next === previous) return;
    this.#state = next;
    for (const listener of this.#listeners) listener(next, previous);
  }

  /**
   * @param {(state: T, previous: T) => void} listener
   * @returns {() => void} call it to unsubscribe
   */
  subscribe(listener) {
    this.#listeners.add(listener);
    return () => this.#listeners.delete(listener);
  }
}
