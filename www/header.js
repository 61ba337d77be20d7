// The buttons of the header: undo, redo, and the menu.
import { byId } from "assur/dom.js";

/** Buttons that do what a command of their name does. */
const BUTTONS = Object.freeze(["undo", "redo", "open", "save", "copy", "export", "reset"]);

export class Header {
  #undo = byId("undo", HTMLButtonElement);
  #redo = byId("redo", HTMLButtonElement);
  #history;

  /**
   * @param {import("assur/history.js").History} history
   * @param {import("assur/commands.js").Commands} commands
   */
  constructor(history, commands) {
    this.#history = history;
    for (const name of BUTTONS) byId(name, HTMLButtonElement).addEventListener("click", commands[name]);
    const menu = byId("menu", HTMLDetailsElement);
    // It closes when something in it, or anything else, is pressed.
    addEventListener("click", ({ target }) => {
      if (target instanceof Node && !menu.querySelector("summary")?.contains(target)) menu.open = false;
    });
  }

  /** Closes the menu. */
  close() {
    const menu = byId("menu", HTMLDetailsElement);
    if (menu.contains(document.activeElement)) menu.querySelector("summary")?.focus();
    menu.open = false;
  }

  render() {
    const { canUndo, canRedo } = this.#history;
    // A button that can do no more gives the focus to its twin, else it would be lost.
    const focused = document.activeElement;
    this.#undo.disabled = !canUndo;
    this.#redo.disabled = !canRedo;
    if (focused === this.#undo && !canUndo) this.#redo.focus();
    if (focused === this.#redo && !canRedo) this.#undo.focus();
  }
}
