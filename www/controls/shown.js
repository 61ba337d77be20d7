// The read-outs as they are shown now, as data. Tables of values and the status line put their rows here and write them into the page; steps
// of lessons and worksheets take their read-outs from here.

/**
 * @typedef {Readonly<{ id: string, title: string, text: string, value?: number, asked?: string, wide?: boolean }>} Cell
 * A read-out. `id`: id of its element; empty for a cell without a value. `title`: its name where it stands alone. `value`: the number that the text
 * shows. `asked`: present if a lesson withholds the read-out; a text for screen readers. `wide`: whether the cell spans all columns.
 * @typedef {Readonly<{ title: string, cells: readonly Cell[] }>} Row
 * @typedef {"values" | "curvature" | "course" | "status"} Section
 */

export class Shown {
  /** @type {Map<Section, readonly Row[]>} */
  #sections = new Map();
  /** Called after a section has changed. */
  changed = () => {};

  /**
   * @param {Section} section
   * @param {readonly Row[]} rows its rows that are not hidden
   */
  put(section, rows) {
    this.#sections.set(section, rows);
    this.changed();
  }

  /** Forgets all rows, because a document of another kind is open. */
  clear() {
    this.#sections.clear();
    this.changed();
  }

  /**
   * @param {...Section} sections
   * @returns {readonly Row[]}
   */
  rows(...sections) {
    return sections.flatMap((section) => this.#sections.get(section) ?? []);
  }

  /**
   * @param {string} name of a read-out
   * @returns {Cell | undefined} undefined if the read-out is not shown
   */
  find(name) {
    const id = idOfOutput(name);
    for (const rows of this.#sections.values()) {
      for (const { cells } of rows) {
        const cell = cells.find((one) => one.id === id);
        if (cell) return cell;
      }
    }
    return undefined;
  }
}

/**
 * @param {string} name of a read-out
 * @returns {string} id of its element
 */
export function idOfOutput(name) {
  return `out-${name}`;
}

/**
 * @param {ReadonlySet<string>} withheld quantities as lessons name them, and names of read-outs
 * @param {string} name of a read-out
 * @param {RegExp} [reveals] names of further quantities, as lessons ask for them, that the read-out reveals
 * @returns {boolean} whether a lesson asks for what the read-out shows
 */
export function isAsked(withheld, name, reveals) {
  return withheld.has(name) || (reveals !== undefined && [...withheld].some((one) => reveals.test(one)));
}

/**
 * @template {Omit<Cell, "id"> & { id?: string }} C
 * @param {string} name of a read-out
 * @param {C} said content of the cell; with an `id` only if the cell is not the read-out itself, but, for example, a difference
 * @param {{ withheld: ReadonlySet<string>, words: import("assur/core/words.js").Words }} snapshot
 * @param {RegExp} [reveals] as in `isAsked`
 * @returns {C & { id: string } | Cell} the cell, or one with a question mark if a lesson asks for what it shows
 */
export function cellOf(name, said, { withheld, words }, reveals) {
  const cell = { id: idOfOutput(name), ...said };
  if (!isAsked(withheld, name, reveals)) return cell;
  const { id, title, wide } = cell;
  return { id, title, wide, text: "?", asked: words.text("lesson.asked") };
}
