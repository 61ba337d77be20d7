// The views of the page, one after the other: one that breaks stops none of the others.

/** @typedef {import("assur/state/model.js").AnySnapshot} AnySnapshot */

export class Rendering {
  /** @type {WeakMap<object, number>} views that broke, by the revision of the mechanism they broke at: they are tried again with another */
  #broken = new WeakMap();
  #broke;

  /** @param {() => void} broke called when a view breaks */
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
