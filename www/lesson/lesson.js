// The lesson beside the settings: which of the two is shown. What a lesson needs is loaded when it is first opened.
import { byId, setData, write } from "assur/core/dom.js";
import { Words } from "assur/core/words.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 */

/** The linkages of the gallery that have a lesson. */
const LINKAGES = Object.freeze(["class4-dwell"]);

export class Lesson {
  #settings = byId("rail", HTMLElement);
  #place = byId("lesson", HTMLElement);
  #tabs = [byId("tab-settings", HTMLButtonElement), byId("tab-lesson", HTMLButtonElement)];
  #page;
  /** @type {import("assur/lesson/panel.js").LessonPanel<import("assur/state/state.js").Kind> | null} */
  #panel = null;
  /** Lesson and language it has, or is waiting for. */
  #wanted = "";
  /** The lesson of the panel. */
  #shown = "";
  #open = false;
  /** The step to come back to. */
  #last = 1;
  /** Whether the focus is to follow into it. */
  #called = false;

  /**
   * @param {import("assur/app/page.js").Page} page
   */
  constructor(page) {
    this.#page = page;
    this.#tabs.forEach((tab, i) => tab.addEventListener("click", () => this.#turn(i === 1)));
  }

  /** Opens it and takes the focus there, or closes it. */
  toggle() {
    this.#called = !this.#open;
    if (this.#open && this.#place.contains(document.activeElement)) this.#tabs[1].focus();
    this.#turn(!this.#open);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, words } = snapshot;
    const lesson = this.#of(state);
    setData(document.documentElement, "taught", String(lesson !== ""));
    const open = state.view.step > 0 && lesson !== "";
    if (open !== this.#open) this.#reveal(open);
    if (!open) return;
    this.#last = state.view.step;
    if (this.#wanted !== `${lesson} ${words.lang}`) this.#load(lesson, words);
    this.#panel?.render(snapshot);
    if (this.#panel && this.#called) {
      this.#called = false;
      this.#panel.focus();
    }
  }

  /**
   * @param {import("assur/state/state.js").State} state
   * @returns {string} the lesson about its mechanism; empty where there is none
   */
  #of(state) {
    if (state.lesson === "mixer") return "mixer";
    const id = this.#page.engine.original(state.document)?.id ?? "";
    return LINKAGES.includes(id) ? id : "";
  }

  /** @param {boolean} open */
  #turn(open) {
    this.#page.store.update((state) => withView(state, { step: open && this.#of(state) ? state.view.step || this.#last : 0 }));
  }

  /** @param {boolean} open */
  #reveal(open) {
    this.#open = open;
    this.#settings.hidden = open;
    this.#place.hidden = !open;
    this.#tabs.forEach((tab, i) => tab.setAttribute("aria-pressed", String(open === (i === 1))));
    // What did not arrive is asked for again.
    if (!this.#panel) this.#wanted = "";
  }

  /**
   * @param {string} lesson
   * @param {Words} words of the page, in the language that is wanted
   */
  async #load(lesson, words) {
    const { lang } = words;
    const wanted = `${lesson} ${lang}`;
    this.#wanted = wanted;
    try {
      const [{ LessonPanel }, { STEPS }, text] = await Promise.all([
        import("assur/lesson/panel.js"),
        import(`assur/lessons/${lesson}.js`),
        Words.load(lang, ["lessons/panel.*", `lessons/${lesson}.*`]),
      ]);
      if (this.#wanted !== wanted) return;
      if (this.#shown !== lesson) {
        this.#shown = lesson;
        const { store, model, history, engine } = this.#page;
        const presets = lesson === "mixer" ? engine.presets : engine.gallery;
        this.#panel = new LessonPanel(this.#place, STEPS, { store, model, history, presets }, text);
      }
      this.#panel?.speak(text);
      this.#page.redraw();
    } catch {
      if (!this.#panel) write(this.#place, words.text("lesson.failed"));
    }
  }
}
