// Tools within a step: controls and parts of the page, borrowed from the page as long as the step is open, and read-outs that
// repeat those of the page.
import { byId, make, setData, write } from "assur/core/dom.js";
import { fieldOf } from "assur/lesson/field.js";

/**
 * @typedef {Readonly<{ controls?: readonly string[], readouts?: readonly string[], lends?: readonly string[] }>} Wanted tools of a step: controls by their fields,
 * read-outs by their ids without `out-`, parts of the page by their ids
 * @typedef {import("assur/state/state.js").State["document"]} Document
 * @typedef {{ element: HTMLElement, home: Comment, open: boolean }} Loan borrowed element, placeholder at its home, whether it was unfolded
 */

export class Tools {
  #controls = make("div", { class: "lesson-controls" });
  #readouts = make("dl", { class: "lesson-readouts" });
  #parts = make("div");
  /** @type {Loan[]} */
  #lent = [];
  /** @type {Wanted | null} */
  #step = null;
  /** @type {(() => Document) | null} */
  #document = null;
  /** @type {Map<string, { entry: HTMLElement, name: HTMLElement, value: HTMLElement }>} */
  #mirrors = new Map();
  // A rail that is rebuilt has new controls.
  #watch = new MutationObserver(() => this.#borrow());

  element = make("div", { class: "lesson-tools" }, [this.#controls, this.#readouts, this.#parts]);

  /**
   * @param {Wanted} step
   * @param {() => Document} document returns the current document
   */
  show(step, document) {
    this.close();
    this.#step = step;
    this.#document = document;
    this.#mirrors = new Map((step.readouts ?? []).map((name) => {
      const [title, value] = [make("dt"), make("dd", { "data-out": name })];
      return [name, { entry: make("div", {}, [title, " ", value]), name: title, value }];
    }));
    this.#readouts.replaceChildren(...[...this.#mirrors.values()].map(({ entry }) => entry));
    this.#watch.observe(byId("rail", HTMLElement), { childList: true, subtree: true });
    this.render();
  }

  /** Returns all borrowed elements. */
  close() {
    this.#watch.disconnect();
    for (const loan of this.#lent) giveBack(loan);
    this.#lent = [];
    this.#step = null;
  }

  /** Borrows missing elements, and copies the page's read-outs after they are written. */
  render() {
    this.#borrow();
    queueMicrotask(() => this.#mirror());
  }

  #borrow() {
    if (!this.#step || !this.#document) return;
    const { controls = [], lends = [] } = this.#step;
    // An element rebuilt at its home replaces the borrowed one.
    this.#lent = this.#lent.filter((loan) => loan.home.isConnected || giveBack(loan));
    const document = this.#document();
    for (const name of controls) {
      const selector = `[data-field="${CSS.escape(fieldOf(name, document))}"]`;
      for (const element of byId("rail", HTMLElement).querySelectorAll(selector)) {
        // A borrowed element is unfolded to be visible at once.
        if (this.#take(element, this.#controls)) for (const details of element.querySelectorAll("details")) details.open = true;
      }
    }
    for (const id of lends) {
      const part = globalThis.document.getElementById(id);
      if (part && this.#take(part, this.#parts) && part instanceof HTMLDetailsElement) part.open = true;
    }
  }

  /**
   * @param {Element} element
   * @param {HTMLElement} place
   * @returns {boolean} whether the element was not there yet
   */
  #take(element, place) {
    if (!(element instanceof HTMLElement) || place.contains(element)) return false;
    const home = new Comment("in the lesson");
    element.replaceWith(home);
    place.append(element);
    this.#lent.push({ element, home, open: element instanceof HTMLDetailsElement && element.open });
    return true;
  }

  #mirror() {
    for (const [id, { entry, name, value }] of this.#mirrors) {
      const source = document.getElementById(`out-${id}`);
      const row = source?.closest("tr, .entry");
      // The read-out of another kind of mechanism exists, but is hidden with that kind.
      entry.hidden = !row || row.matches("[hidden]") || row.closest(".elsewhere") !== null;
      write(name, source ? titleOf(source) : "");
      write(value, source?.textContent ?? "");
      setData(value, "value", source?.dataset.value ?? "");
    }
  }
}

/**
 * @param {HTMLElement} source of the table of values, of the status line or of another table
 * @returns {string} name of the read-out
 */
function titleOf(source) {
  const title = source.closest("tr, .entry")?.querySelector("th, dt");
  const symbol = title?.querySelector("b")?.textContent;
  if (!symbol || !(source instanceof HTMLTableCellElement)) return title?.textContent?.trim() ?? "";
  const head = source.closest("table")?.tHead?.rows[0].cells[source.cellIndex].textContent ?? "";
  return `${derived(symbol, source.cellIndex - 1, head)} ${title?.querySelector("span")?.textContent ?? ""}`;
}

/**
 * @param {string} symbol of a quantity
 * @param {number} order of its derivative
 * @param {string} head head of the column, which has the column's notation of derivatives
 * @returns {string} the symbol of the derivative in that notation
 */
export function derived(symbol, order, head) {
  // A derivative with respect to time has a letter of its own: ω.
  return order > 0 && [...head].length === 1 ? head + symbol.slice(1) : symbol + ["", "′", "″"][order];
}

/**
 * @param {Loan} loan
 * @returns {false} the element is no longer borrowed
 */
function giveBack({ element, home, open }) {
  if (element instanceof HTMLDetailsElement) element.open = open;
  if (home.isConnected) home.replaceWith(element);
  else element.remove();
  return false;
}
