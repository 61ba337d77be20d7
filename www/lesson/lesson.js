// The part of the page that shows either the settings or a lesson. Modules for lessons are loaded when a lesson is first opened.
import { awaited } from "assur/app/busy.js";
import { byId, setData, write } from "assur/core/dom.js";
import { Words } from "assur/core/words.js";
import { OWN, next, offered, opened, readLesson, readPaper } from "assur/lesson/offer.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/lesson/offer.js").Entry} Entry
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 */

export class Lesson {
  #settings = byId("rail", HTMLElement);
  #container = byId("lesson", HTMLElement);
  #tabs = [byId("tab-settings", HTMLButtonElement), byId("tab-lesson", HTMLButtonElement)];
  #page;
  /** @type {import("assur/lesson/panel.js").LessonPanel | null} */
  #panel = null;
  /** Key of the lesson to show, which may still be loading; see `wantedOf`. */
  #wanted = "";
  /** Id of the lesson in the panel. */
  #shown = "";
  /** @type {import("assur/state/state.js").Written | undefined} the lecturer's lesson in the panel */
  #written;
  /** @type {import("assur/lesson/writer.js").Writer | null} form for lecturers */
  #writer = null;
  /** Whether the lecturer's own lesson is being written instead of read. */
  #writing = false;
  #open = false;
  /** @type {import("assur/state/state.js").View["lesson"]} lesson and step to return to */
  #last = null;
  /** Actions due once the lesson is open. `seen`: scroll it into view. `focused`: focus it, for example if it was opened by a key. */
  #called = { seen: false, focused: false };

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#tabs.forEach((tab, i) => tab.addEventListener("click", () => this.#turn(i === 1)));
  }

  /** Opens and focuses the lesson, or closes it. */
  toggle() {
    this.#called.focused = !this.#open;
    if (this.#open && this.#container.contains(document.activeElement)) this.#tabs[1].focus();
    this.#turn(!this.#open);
  }

  /** Scrolls the open lesson into view and focuses it. */
  call() {
    this.#called = { seen: true, focused: true };
    this.#page.redraw();
  }

  /** @returns {readonly import("assur/lesson/panel.js").Told[]} steps of the open lesson */
  steps() {
    return (this.#open && this.#panel?.steps()) || [];
  }

  /**
   * @param {string} step id of a step
   * @returns {HTMLElement[]} the items of the lesson's paper for this step
   */
  onPaper(step) {
    return this.#panel?.onPaper(step) ?? [];
  }

  /** @param {boolean} writing whether the lecturer's own lesson is being written instead of read */
  write(writing) {
    this.#writing = writing;
    this.#called.focused = true;
    this.#leave();
    this.#page.redraw();
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
    const writing = this.#writing && lesson.id === OWN;
    if (!writing && lesson.id === OWN && this.#written !== state.lesson) this.#leave();
    this.#written = state.lesson;
    if (this.#wanted !== wantedOf(lesson, writing, words)) this.#load(lesson, writing, words);
    const shown = writing ? this.#writer : this.#shown === lesson.id ? this.#panel : null;
    if (!shown) return;
    shown.render(snapshot);
    if (this.#called.seen) this.#container.scrollIntoView({ block: "nearest" });
    if (this.#called.focused) shown.focus();
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
    this.#container.hidden = !open;
    if (!open) this.#panel?.close();
    this.#tabs.forEach((tab, i) => tab.setAttribute("aria-pressed", String(open === (i === 1))));
    // Modules that failed to load are requested again.
    if (!this.#panel && !this.#writer) this.#wanted = "";
  }

  /** Ends the lesson that is shown. */
  #leave() {
    this.#panel?.end();
    this.#panel = this.#writer = null;
    this.#wanted = this.#shown = "";
  }

  /**
   * @param {Entry} entry
   * @param {boolean} writing
   * @param {Words} words words of the page, in the wanted language
   */
  async #load(entry, writing, words) {
    const wanted = wantedOf(entry, writing, words);
    this.#wanted = wanted;
    try {
      const { show } = await awaited(writing ? this.#bringWriter(words) : entry.id === OWN ? this.#bringWritten() : this.#bringOurs(entry, words));
      if (this.#wanted !== wanted) return;
      show();
      this.#page.redraw();
    } catch {
      if (this.#wanted !== wanted) return;
      this.#leave();
      this.#wanted = wanted;
      write(this.#container, words.text("lesson.failed"));
    }
  }

  /** @param {Words} words words of the page, in the wanted language */
  async #bringWriter(words) {
    // A lecturer's numbers may be masses and loads.
    const [{ Writer }] = await Promise.all([this.#page.withForces(import("assur/lesson/writer.js")), this.#page.withFurther()]);
    return { show: () => {
      this.#leave();
      this.#writer = new Writer(this.#container, this.#page, this.#page.words);
      this.#wanted = wantedOf({ id: OWN }, true, words);
    } };
  }

  async #bringWritten() {
    const parts = Promise.all([import("assur/lesson/panel.js"), import("assur/lesson/written.js")]);
    const [{ LessonPanel }, { WrittenLesson }] = await this.#page.withForces(parts);
    return { show: () => {
      const { lesson } = this.#page.store.get();
      if (!lesson) return;
      this.#panel?.end();
      this.#written = lesson;
      const { words } = this.#page;
      this.#panel = new LessonPanel(this.#container, this.#page, new WrittenLesson(lesson, this.#page, words), words);
      this.#shown = OWN;
    } };
  }

  /**
   * @param {Entry} entry
   * @param {Words} words
   */
  async #bringOurs(entry, { lang }) {
    const { id } = entry;
    const tables = ["lang/*", `lessons/${id}/words.*`, ...(entry.paper ? [`lessons/${id}/paper.*`] : [])];
    const [{ LessonPanel }, { FolderLesson }, { lesson, presets }, items, text] = await Promise.all([
      import("assur/lesson/panel.js"),
      import("assur/lesson/folder.js"),
      readLesson(entry),
      readPaper(entry),
      Words.load(lang, tables),
      entry.paper && import("assur/lesson/paper-style.js"),
    ]);
    return { show: () => {
      if (this.#shown !== id) {
        this.#panel?.end();
        this.#writer = null;
        this.#shown = id;
        this.#panel = new LessonPanel(this.#container, this.#page, new FolderLesson(id, lesson, presets, this.#page, next(id), items, entry.notes), text);
      }
      this.#panel?.setWords(text);
    } };
  }
}

/**
 * @param {Pick<Entry, "id">} entry
 * @param {boolean} writing
 * @param {Words} words
 * @returns {string} key of the lesson, of its language, and of whether it is written or read
 */
function wantedOf({ id }, writing, { lang }) {
  return `${writing ? "write " : ""}${id} ${lang}`;
}
