// The selected parts of a drawing: points and links, by name.

/** @typedef {Pick<import("assur/state/state.js").Documents["linkage"], "points" | "links" | "tracers">} Parts */

export class Selection {
  /** @type {ReadonlySet<string>} */
  points = new Set();
  /** @type {ReadonlySet<string>} */
  links = new Set();

  get empty() {
    return this.points.size + this.links.size === 0;
  }

  clear() {
    this.points = new Set();
    this.links = new Set();
  }

  /**
   * @param {string | null} point
   * @param {string | null} link used if there is no point
   * @param {boolean} more whether to add to the selection instead of replacing it
   */
  choose(point, link, more) {
    const [points, links] = more ? [this.points, this.links] : [new Set(), new Set()];
    this.points = point ? other(points, point) : points;
    this.links = link && !point ? other(links, link) : links;
  }

  /**
   * @param {Iterable<string>} points
   * @param {Iterable<string>} links
   */
  set(points, links) {
    this.points = new Set(points);
    this.links = new Set(links);
  }

  /** @param {Parts} parts parts of the drawing; points and links that are not among them are deselected */
  keep({ points, links, tracers = [] }) {
    const named = new Set([...points, ...tracers].map(({ name }) => name));
    const linked = new Set(links.map(({ name }) => name));
    this.points = new Set([...this.points].filter((name) => named.has(name)));
    this.links = new Set([...this.links].filter((name) => linked.has(name)));
  }

  /**
   * @param {Parts} parts of the drawing
   * @returns {string[]} all selected points, and the points of selected links
   */
  all({ links }) {
    const of = links.filter(({ name }) => this.links.has(name)).flatMap(({ points }) => points);
    return [...new Set([...this.points, ...of])];
  }
}

/**
 * @param {ReadonlySet<string>} names
 * @param {string} name
 * @returns {ReadonlySet<string>} the set with the name added, or removed if it was there
 */
function other(names, name) {
  return names.has(name) ? new Set([...names].filter((one) => one !== name)) : new Set([...names, name]);
}
