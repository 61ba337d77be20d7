// Tools of a lesson's step: controls and parts of the page, moved into the open step, and copies of read-outs.
import { byId, make, setData, write } from "assur/core/dom.js";
import { fieldOf } from "assur/lesson/field.js";

/**
 * @typedef {Readonly<{ controls?: readonly string[], readouts?: readonly string[], lends?: readonly string[] }>} Wanted
 * Tools of a step. `controls`: fields of the controls. `readouts`: ids of read-outs, without `out-`. `lends`: ids of parts of the page.
 * @typedef {import("assur/state/state.js").State["document"]} Document
 * @typedef {{ element: HTMLElement, home: Comment, open: boolean }} Borrowed
 * `element`: the borrowed element. `home`: placeholder where the element belongs. `open`: whether the element was unfolded.
 */

export class Tools {
  #controls = make("div", { class: "lesson-controls" });
  #readouts = make("dl", { class: "lesson-readouts" });
  #parts = make("div");
  /** @type {Borrowed[]} */
  #borrowed = [];
  /** @type {Wanted | null} */
  #step = null;
  /** @type {(() => Document) | null} */
  #document = null;
  /** @type {Map<string, { entry: HTMLElement, name: HTMLElement, value: HTMLElement }>} */
  #mirrors = new Map();
  // If the rail is rebuilt, its new controls are borrowed.
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

  /** Gives back all borrowed elements. */
  close() {
    this.#watch.disconnect();
    for (const one of this.#borrowed) giveBack(one);
    this.#borrowed = [];
    this.#step = null;
  }

  /** Borrows elements that are not borrowed yet. Copies the page's read-outs after the page has written them. */
  render() {
    this.#borrow();
    queueMicrotask(() => this.#mirror());
  }

  #borrow() {
    if (!this.#step || !this.#document) return;
    const { controls = [], lends = [] } = this.#step;
    // If a part of the page with a placeholder was rebuilt, the old element is dropped and its replacement is borrowed.
    this.#borrowed = this.#borrowed.filter((one) => one.home.isConnected || giveBack(one));
    const document = this.#document();
    for (const name of controls) {
      const selector = `[data-field="${CSS.escape(fieldOf(name, document))}"]`;
      for (const element of byId("rail", HTMLElement).querySelectorAll(selector)) {
        // A borrowed control is unfolded, so that it is visible at once.
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
   * @param {HTMLElement} container
   * @returns {boolean} whether the element was moved to the container; false if it was already there
   */
  #take(element, container) {
    if (!(element instanceof HTMLElement) || container.contains(element)) return false;
    const home = new Comment("in the lesson");
    element.replaceWith(home);
    container.append(element);
    this.#borrowed.push({ element, home, open: element instanceof HTMLDetailsElement && element.open });
    return true;
  }

  #mirror() {
    for (const [id, { entry, name, value }] of this.#mirrors) {
      const source = document.getElementById(`out-${id}`);
      const row = source?.closest("tr, .entry");
      // Read-outs of other kinds of mechanisms are also in the page, but hidden.
      entry.hidden = !row || row.matches("[hidden]") || row.closest(".elsewhere") !== null;
      write(name, source ? titleOf(source) : "");
      write(value, source?.textContent ?? "");
      setData(value, "value", source?.dataset.value ?? "");
    }
  }
}

/**
 * @param {HTMLElement} source read-out in the table of values, in the status line or in another table
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
 * @param {string} head heading of the column, which shows the notation of derivatives
 * @returns {string} the symbol of the derivative in that notation
 */
export function derived(symbol, order, head) {
  // A derivative with respect to time has a letter of its own: ω.
  return order > 0 && [...head].length === 1 ? head + symbol.slice(1) : symbol + ["", "′", "″"][order];
}

/**
 * @param {Borrowed} borrowed
 * @returns {false} always, because the element is no longer borrowed
 */
function giveBack({ element, home, open }) {
  if (element instanceof HTMLDetailsElement) element.open = open;
  if (home.isConnected) home.replaceWith(element);
  else element.remove();
  return false;
}
