// The status line: kind and properties of the mechanism, one entry for each.
import { withhold, writeReadout } from "assur/controls/readout.js";
import { byId, make, setData } from "assur/core/dom.js";

/** @typedef {{ text: string | readonly (Node | string)[], value?: number }} Entry */

/**
 * @template {{ words: import("assur/core/words.js").Words, revision: number, stale: boolean, withheld: ReadonlySet<string>, coordinate: import("assur/state/coordinate.js").Coordinate }} S
 * @typedef {Readonly<{ name: string, title: string, n?: string, class?: string, late?: boolean, say: (snapshot: S) => Entry | null }>} Item
 * `title`: key of the entry's title. `n`: text for {n} in the title, by default the input's symbol. `late`: whether
 * the content is slow to compute, and waits for a moment without changes. `say`: gives the content; null hides the
 * entry.
 */

/** Time without a change before late entries are computed, in milliseconds. */
const MOMENT = 150;

/** @template {{ words: import("assur/core/words.js").Words, revision: number, stale: boolean, withheld: ReadonlySet<string>, coordinate: import("assur/state/coordinate.js").Coordinate }} S */
export class StatusLine {
  #list = byId("status", HTMLElement);
  /** @type {{ name: string, n: string, late: boolean, say: Item<S>["say"], entry: HTMLElement, output: HTMLElement }[]} */
  #entries;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  #moment;
  /** Symbol of the input in the titles. */
  #symbol = "";
  #shown = "";
  /** @type {ReadonlySet<string> | null} */
  #withheld = null;

  /**
   * @param {string} kind of the documents that have the entries
   * @param {readonly Item<S>[]} items
   */
  constructor(kind, items) {
    this.#entries = items.map(({ name, title, n = "", class: more = "", late = false, say }) => {
      const output = make("dd", { id: `out-${name}` });
      const entry = make("div", { class: `entry ${more}`.trim(), "data-of": kind }, [make("dt", { "data-t": title, "data-n": n }), " ", output, " "]);
      this.#list.append(entry);
      return { name, n, late, say, entry, output };
    });
  }

  /**
   * Writes the titles. The {n} of a title is the entry's own, or else the symbol of the input.
   * @param {string} symbol
   * @param {import("assur/core/words.js").Words} words
   */
  #name(symbol, words) {
    this.#symbol = symbol;
    for (const { n, entry } of this.#entries) {
      entry.querySelector("dt")?.setAttribute("data-n", n || symbol);
      words.fill(entry);
    }
  }

  /** @param {S} snapshot */
  render(snapshot) {
    const { words, revision, stale, withheld, coordinate } = snapshot;
    setData(this.#list, "faded", String(stale));
    // After a refused state, the entries of the last mechanism stay.
    if (stale && this.#shown.endsWith(` ${words.lang}`)) return;
    const shown = `${revision} ${words.lang}`;
    if (shown === this.#shown && withheld === this.#withheld) return;
    this.#withheld = withheld;
    this.#shown = shown;
    if (coordinate.symbol !== this.#symbol) this.#name(coordinate.symbol, words);
    this.#write(false, snapshot);
    clearTimeout(this.#moment);
    this.#moment = setTimeout(() => this.#write(true, snapshot), MOMENT);
  }

  /**
   * @param {boolean} late whether to write the late entries or the others
   * @param {S} snapshot
   */
  #write(late, snapshot) {
    for (const { name, say, entry, output } of this.#entries.filter((one) => one.late === late)) {
      const said = say(snapshot);
      const text = said?.text ?? "";
      entry.hidden = said === null || text === "";
      if (snapshot.withheld.has(name)) withhold(output, snapshot.words);
      else writeReadout(output, text, said?.value);
    }
  }
}
