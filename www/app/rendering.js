// Rendering of the page's views one by one: a view that breaks does not stop the others.

/** @typedef {import("assur/state/model.js").AnySnapshot} AnySnapshot */

export class Rendering {
  /** @type {WeakMap<object, number>} views that threw, with the revision of the mechanism at that time; they are tried again at another revision */
  #broken = new WeakMap();
  #broke;

  /** @param {() => void} broke called when a view throws */
  constructor(broke) {
    this.#broke = broke;
  }

  /**
   * @template {{ revision: number }} S
   * @param {Iterable<{ render(snapshot: S): void }>} views
   * @param {S} snapshot
   */
  all(views, snapshot) {
    for (const view of views) {
      if (this.#broken.get(view) === snapshot.revision) continue;
      try {
        view.render(snapshot);
      } catch (thrown) {
        console.error(thrown);
        this.#broken.set(view, snapshot.revision);
        this.#broke();
      }
    }
  }
}
