// The lesson, in the place of the settings: which of the two is shown. What a lesson needs is loaded when it is first opened.
import { awaited } from "assur/app/busy.js";
import { byId, setData, write } from "assur/core/dom.js";
import { Words } from "assur/core/words.js";
import { offered, opened, readLesson } from "assur/lesson/offer.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/lesson/offer.js").Entry} Entry
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 */

export class Lesson {
  #settings = byId("rail", HTMLElement);
  #place = byId("lesson", HTMLElement);
  #tabs = [byId("tab-settings", HTMLButtonElement), byId("tab-lesson", HTMLButtonElement)];
  #page;
  /** @type {import("assur/lesson/panel.js").LessonPanel | null} */
  #panel = null;
  /** Lesson and language it has, or is waiting for. */
  #wanted = "";
  /** The lesson of the panel. */
  #shown = "";
  #open = false;
  /** @type {import("assur/state/state.js").View["lesson"]} lesson and step to come back to */
  #last = null;
  /** Whether the reader has just opened it, and is to see it: by a key or not. */
  #called = { seen: false, focused: false };

  /**
   * @param {import("assur/app/page.js").Page} page
   */
  constructor(page) {
    this.#page = page;
    this.#tabs.forEach((tab, i) => tab.addEventListener("click", () => this.#turn(i === 1)));
  }

  /** Opens it and takes the focus there, or closes it. */
  toggle() {
    this.#called.focused = !this.#open;
    if (this.#open && this.#place.contains(document.activeElement)) this.#tabs[1].focus();
    this.#turn(!this.#open);
  }

  /** Brings the open lesson where the eye is, and the focus there. */
  call() {
    this.#called = { seen: true, focused: true };
    this.#page.redraw();
  }

  /** @returns {readonly import("assur/lesson/panel.js").Asked[]} what the open lesson asks, step by step */
  questions() {
    return (this.#open && this.#panel?.questions()) || [];
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, words } = snapshot;
    setData(document.documentElement, "taught", String(offered(state) !== undefined));
    const lesson = opened(state);
    const open = lesson !== undefined;
    if (open !== this.#open) this.#reveal(open);
    if (!open) return;
    this.#last = state.view.lesson;
    if (this.#wanted !== `${lesson.id} ${words.lang}`) this.#load(lesson, words);
    if (!this.#panel || this.#shown !== lesson.id) return;
    this.#panel.render(snapshot);
    if (this.#called.seen) this.#place.scrollIntoView({ block: "nearest" });
    if (this.#called.focused) this.#panel.focus();
    this.#called = { seen: false, focused: false };
  }

  /** @param {boolean} open */
  #turn(open) {
    this.#called.seen = open;
    this.#page.store.update((state) => {
      const id = offered(state)?.id;
      if (!open || id === undefined) return withView(state, { lesson: null });
      if (opened(state)) return state;
      return withView(state, { lesson: this.#last?.id === id ? this.#last : { id, step: 1 } });
    });
  }

  /** @param {boolean} open */
  #reveal(open) {
    this.#open = open;
    this.#settings.hidden = open;
    this.#place.hidden = !open;
    if (!open) this.#panel?.close();
    this.#tabs.forEach((tab, i) => tab.setAttribute("aria-pressed", String(open === (i === 1))));
    // What did not arrive is asked for again.
    if (!this.#panel) this.#wanted = "";
  }

  /**
   * @param {Entry} entry
   * @param {Words} words of the page, in the language that is wanted
   */
  async #load(entry, words) {
    const { id } = entry;
    const { lang } = words;
    const wanted = `${id} ${lang}`;
    this.#wanted = wanted;
    try {
      const [{ LessonPanel }, { lesson, presets }, text] = await awaited(Promise.all([
        import("assur/lesson/panel.js"),
        readLesson(entry),
        Words.load(lang, ["lang/*", `lessons/${id}/words.*`]),
      ]));
      if (this.#wanted !== wanted) return;
      if (this.#shown !== id) {
        this.#panel?.close();
        this.#shown = id;
        this.#panel = new LessonPanel(this.#place, this.#page, id, lesson, presets, text);
      }
      this.#panel?.speak(text);
      this.#page.redraw();
    } catch {
      if (this.#wanted !== wanted) return;
      this.#panel = null;
      this.#shown = "";
      write(this.#place, words.text("lesson.failed"));
    }
  }
}
