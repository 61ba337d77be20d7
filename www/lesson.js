// The lesson beside the settings: which of the two is shown. What a lesson needs is loaded when it is first opened.
import { byId, setData, write } from "assur/dom.js";
import { withView } from "assur/state.js";
import { Words } from "assur/words.js";

/**
 * @typedef {import("assur/model.js").Snapshot} Snapshot
 * @typedef {import("assur/state.js").Kind} Kind
 * @typedef {import("assur/lessons/panel.js").Panel<Kind>} Panel
 * @typedef {import("assur/lessons/panel.js").Parts<Kind>} Parts
 */

/** The linkages of the gallery that have a lesson. */
const LINKAGES = Object.freeze(["class4-dwell"]);

export class Lesson {
  #settings = byId("rail", HTMLElement);
  #place = byId("lesson", HTMLElement);
  #tabs = [byId("tab-settings", HTMLButtonElement), byId("tab-lesson", HTMLButtonElement)];
  #parts;
  #changed;
  /** @type {Panel | null} */
  #panel = null;
  #engine;
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
   * @param {Omit<Parts, "presets">} parts
   * @param {import("assur/engine.js").Engine} engine
   * @param {() => void} changed
   */
  constructor(parts, engine, changed) {
    this.#parts = parts;
    this.#engine = engine;
    this.#changed = changed;
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
   * @param {import("assur/state.js").State} state
   * @returns {string} the lesson about its mechanism; empty where there is none
   */
  #of(state) {
    if (state.lesson === "mixer") return "mixer";
    const id = this.#engine.original(state.document)?.id ?? "";
    return LINKAGES.includes(id) ? id : "";
  }

  /** @param {boolean} open */
  #turn(open) {
    this.#parts.store.update((state) => withView(state, { step: open && this.#of(state) ? state.view.step || this.#last : 0 }));
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
      const [{ Panel }, { STEPS }, text] = await Promise.all([
        import("assur/lessons/panel.js"),
        import(`assur/lessons/${lesson}.js`),
        Words.load(lang, ["lessons/panel.*", `lessons/${lesson}.*`]),
      ]);
      if (this.#wanted !== wanted) return;
      if (this.#shown !== lesson) {
        this.#shown = lesson;
        const presets = lesson === "mixer" ? this.#engine.presets : this.#engine.gallery;
        this.#panel = new Panel(this.#place, STEPS, { ...this.#parts, presets }, text);
      }
      this.#panel?.speak(text);
      this.#changed();
    } catch {
      if (!this.#panel) write(this.#place, words.text("lesson.failed"));
    }
  }
}
