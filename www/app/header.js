// Buttons of the header: undo, redo, the menu, projector mode, and the settings that this mode folds away.
import { byId, setData } from "assur/core/dom.js";

/** Buttons that run the command of the same name. */
const BUTTONS = Object.freeze(["undo", "redo", "gallery", "new-drawing", "write-lesson", "open", "save", "copy", "export", "print", "reset", "projector"]);

export class Header {
  #undo = byId("undo", HTMLButtonElement);
  #redo = byId("redo", HTMLButtonElement);
  #projector = byId("projector", HTMLButtonElement);
  #settings = byId("settings", HTMLButtonElement);
  #menu = byId("menu", HTMLDetailsElement);
  #more = byId("transport-more", HTMLDetailsElement);
  #without = byId("copy-without", HTMLElement);
  #history;

  /**
   * @param {import("assur/state/history.js").History} history
   * @param {import("assur/app/commands.js").Commands} commands
   */
  constructor(history, commands) {
    this.#history = history;
    byId("draw", HTMLButtonElement).addEventListener("click", commands.draw);
    for (const name of BUTTONS) byId(name, HTMLButtonElement).addEventListener("click", commands[name]);
    const status = byId("status-more", HTMLButtonElement);
    status.addEventListener("click", () => {
      const open = status.ariaExpanded !== "true";
      status.setAttribute("aria-expanded", String(open));
      setData(byId("status", HTMLElement), "open", String(open));
    });
    this.#settings.addEventListener("click", () => this.fold(this.#settings.ariaExpanded !== "true"));
    // A click closes the menu, also a click on one of its entries. The menu's own button opens and closes it by itself.
    addEventListener("click", ({ target }) => {
      const kept = target instanceof Element && this.#menu.contains(target) && target.closest("summary, .lang");
      if (!kept) this.#closeMenu();
    });
    this.#menu.addEventListener("change", () => this.#closeMenu());
    addEventListener("click", ({ target }) => {
      if (target instanceof Node && !this.#more.contains(target)) this.#more.open = false;
    });
  }

  /** @param {boolean} open whether projector mode shows the settings beside the drawing */
  fold(open) {
    this.#settings.setAttribute("aria-expanded", String(open));
    const app = byId("app", HTMLElement);
    setData(app, "rail", open ? "open" : "folded");
    if (open) setData(app, "railColumn", "open");
  }

  /** Closes the menu and the further controls of the bottom bar, and folds the rail. */
  close() {
    this.fold(false);
    this.#closeMenu();
    this.#more.open = false;
  }

  /** Closes the menu. If one of its entries has the focus, the focus moves to the menu's button. */
  #closeMenu() {
    if (this.#menu.contains(document.activeElement)) this.#menu.querySelector("summary")?.focus();
    this.#menu.open = false;
  }

  /** @param {import("assur/state/model.js").AnySnapshot} snapshot */
  render({ state }) {
    this.#projector.setAttribute("aria-pressed", String(state.view.projector));
    this.#without.hidden = !state.picture;
    const { canUndo, canRedo } = this.#history;
    // If Undo has the focus and becomes disabled, the focus moves to Redo, and vice versa.
    const focused = document.activeElement;
    this.#undo.disabled = !canUndo;
    this.#redo.disabled = !canRedo;
    if (focused === this.#undo && !canUndo) this.#redo.focus();
    if (focused === this.#redo && !canRedo) this.#undo.focus();
  }
}
