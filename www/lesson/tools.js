// Tools of a lesson's step: controls and parts of the page, moved into the open step, and copies of read-outs.
import { readoutText } from "assur/controls/readout.js";
import { byId, make } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { fieldOf } from "assur/lesson/field.js";

/**
 * @typedef {Readonly<{ controls?: readonly string[], readouts?: readonly string[], lends?: readonly string[] }>} Wanted
 * Tools of a step. `controls`: fields whose controls are moved into the step. `readouts`: names of read-outs that are copied into it. `lends`:
 * ids of parts of the page that are moved into it.
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
  #shown;
  // If the rail is rebuilt, its new controls are borrowed.
  #watch = new MutationObserver(() => this.borrow());

  element = make("div", { class: "lesson-tools" }, [this.#controls, this.#readouts, this.#parts]);

  /** @param {import("assur/controls/shown.js").Shown} shown */
  constructor(shown) {
    this.#shown = shown;
  }

  /**
   * @param {Wanted} step
   * @param {() => Document} document returns the current document
   */
  show(step, document) {
    this.close();
    this.#step = step;
    this.#document = document;
    this.#shown.changed = () => this.#write();
    this.#write();
    this.#watch.observe(byId("rail", HTMLElement), { childList: true, subtree: true });
    this.borrow();
  }

  /** Gives back all borrowed elements, and forgets the step. */
  close() {
    this.#watch.disconnect();
    this.#shown.changed = () => {};
    for (const one of this.#borrowed) giveBack(one);
    this.#borrowed = [];
    this.#step = null;
  }

  /** Borrows elements that are not borrowed yet. */
  borrow() {
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

  #write() {
    const entries = (this.#step?.readouts ?? []).map((name) => {
      const cell = this.#shown.find(name);
      return html`<div ?hidden=${!cell}><dt>${cell?.title}</dt> <dd data-out=${name} data-value=${cell?.value ?? nothing} data-asked=${cell?.asked ?? nothing}>${cell && readoutText(cell)}</dd></div>`;
    });
    render(entries, this.#readouts);
  }
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
