// The page as a whole: the objects its parts share, and the work of each frame.
import { commands as makeCommands } from "assur/app/commands.js";
import { Header } from "assur/app/header.js";
import { listen } from "assur/app/keys.js";
import { chooseLanguage, writeTexts } from "assur/app/language.js";
import { Loop } from "assur/app/loop.js";
import { LOST, NO_PLOTS, Notices, UNKEPT } from "assur/app/notices.js";
import { takeAddress } from "assur/app/opening.js";
import { receive } from "assur/app/receiving.js";
import { Views } from "assur/app/views.js";
import { welcome } from "assur/app/welcome.js";
import { Theme } from "assur/canvas/theme.js";
import { Shown } from "assur/controls/shown.js";
import { byId, setData } from "assur/core/dom.js";
import { compiledWasm } from "assur/core/wasm.js";
import { Words } from "assur/core/words.js";
import { Lesson } from "assur/lesson/lesson.js";
import { ChartView } from "assur/plots/chart.js";
import { MechanismPointer } from "assur/stage/pointer.js";
import { MechanismView } from "assur/stage/view.js";
import { Address } from "assur/state/address.js";
import { choose } from "assur/state/change.js";
import { Drafts, INPUT } from "assur/state/drafts.js";
import { History } from "assur/state/history.js";
import { Model } from "assur/state/model.js";
import { Player, stoppedAt } from "assur/state/player.js";
import { PARTS, withView } from "assur/state/state.js";
import { persist } from "assur/state/storage.js";
import { Store } from "assur/state/store.js";

/** @typedef {import("assur/state/state.js").State} State */

/** Time for which a changing number must stay on the screen to be readable, in seconds. */
const WRITING_PERIOD = 0.2;

export class Page {
  #loop = new Loop((dt) => this.#play(dt), () => this.#render());
  #player = new Player();
  #views;
  #toLesson;
  /** Seconds since the numbers were last written. The initial value causes them to be written at the start. */
  #unwritten = WRITING_PERIOD;
  /** What the read-outs show. */
  shown = new Shown();
  /** @type {() => readonly import("assur/plots/pairs.js").Further[]} further choices for the list of plots, from a part that is loaded on demand */
  furtherPlots = () => [];
  /** @type {HTMLElement | null} element printed instead of the worksheet of the shown state */
  sheet = null;
  /** @type {Map<string, (figure: (picture: import("assur/export/pictures.js").Picture, said: string) => HTMLElement) => readonly HTMLElement[]>} what parts loaded on demand add to the worksheet, by their names */
  onPaper = new Map();
  /** @type {Promise<void> | null} words that a first view does not show, once asked for */
  #further = null;

  /**
   * @param {import("assur/engine.js").Engine} engine
   * @param {import("assur/app/opening.js").Habits} habits
   * @param {Words} words of the state's language
   * @param {import("assur/app/opening.js").Opening} opening
   */
  constructor(engine, habits, words, { state, failures }) {
    const redraw = () => this.redraw();
    this.engine = engine;
    this.habits = habits;
    const { embedding } = habits;
    this.store = new Store(state, (next, now) => embedding?.limit(next, now) ?? next);
    this.address = new Address(engine, habits.lang);
    this.drafts = new Drafts(redraw);
    this.model = new Model(engine, this.drafts, state);
    this.words = words.measured(engine.lengths);
    this.history = new History(this.store, this.drafts);
    this.theme = new Theme(engine.roles, redraw);
    this.notices = new Notices(redraw);
    this.notices.tell(failures);
    // Canvases have a size only when they are shown.
    byId("app", HTMLElement).hidden = false;
    this.mechanism = new MechanismView(byId("mechanism", HTMLCanvasElement), engine, this.theme);
    const corner = byId("zoom", HTMLElement);
    const edge = () => 2 * Number.parseFloat(getComputedStyle(corner).bottom);
    new ResizeObserver(([{ contentRect: { width, height } }]) => this.mechanism.spare(width + edge(), height + edge())).observe(corner);
    this.chart = new ChartView(byId("charts", HTMLCanvasElement), engine, this.theme, () => this.notices.tell(NO_PLOTS));

    const commands = makeCommands(this);
    const header = new Header(this.history, commands);
    const lesson = new Lesson(this);
    this.lesson = lesson;
    this.#toLesson = () => {
      header.fold(true);
      lesson.call();
    };
    const pointer = new MechanismPointer(byId("mechanism", HTMLCanvasElement), this);
    this.pointer = pointer;
    this.#views = new Views(this, [this.mechanism, pointer], [lesson, header, this.notices]);
    byId("help-open", HTMLButtonElement).addEventListener("click", commands.help);
    const keys = {
      ...commands,
      trace: () => pointer.trace(),
      all: () => this.mechanism.fitAll(),
      lesson: () => {
        lesson.toggle();
        header.fold(this.store.get().view.lesson !== null);
      },
      settings: () => byId("settings", HTMLButtonElement).click(),
      close: () => {
        header.close();
        this.notices.clear();
        pointer.trace(false);
      },
    };
    listen(embedding?.commands(keys) ?? keys);
    this.store.subscribe(redraw);
    persist(this.store, this.address, (state) => this.model.takes(state), !embedding, (...what) => this.notices.tell(what.flatMap((one) => UNKEPT[one])));
    receive(this);
    // The address is taken from the event: the page may have replaced it in the address bar by now.
    addEventListener("hashchange", ({ newURL }) => this.take(takeAddress(newURL, engine, this.ofNow())));
    chooseLanguage(this);
    welcome(this, commands);
    writeTexts(this.words);
  }

  /** Draws the page for the first time. */
  show() {
    byId("boot", HTMLElement).hidden = true;
    this.#render();
    this.redraw();
    // The canvases get their sizes, and are drawn, at the end of the first frame.
    requestAnimationFrame(() => requestAnimationFrame(() => {
      setData(document.documentElement, "ready", "true");
      performance.mark("ready");
      this.#prepare();
    }));
  }

  /**
   * Opens the lesson of an embedded page, and loads in advance: the second part of the engine; the words that the first
   * view does not show; the gallery, which is often used; the worksheet, for which the browser's print command cannot
   * wait.
   */
  async #prepare() {
    this.habits.embedding?.begin(this).catch(() => this.notices.tell(LOST));
    await Promise.all([compiledWasm(), this.withFurther()]).catch(() => this.notices.tell(LOST));
    import("assur/gallery/gallery.js").catch(() => null);
    const part = await import("assur/export/worksheet.js").catch(() => null);
    part?.printWorksheets(this);
    performance.mark("printable");
    dispatchEvent(new Event("prepared"));
  }

  /** @returns {import("assur/app/opening.js").Habits} habits with the page's current language, for states without one, and its present mode */
  ofNow() {
    const { lang, projector } = this.store.get().view;
    return { ...this.habits, lang, projector };
  }

  redraw() {
    this.#loop.request();
  }

  /**
   * Calls a function while the drawing and the numbers show the same pose.
   * @template T
   * @param {readonly string[]} hidden quantities and read-outs hidden during the work
   * @param {() => T} work
   * @returns {T}
   */
  posed(hidden, work) {
    const { model } = this;
    const { withheld } = model;
    model.withheld = new Set(hidden);
    this.#unwritten = WRITING_PERIOD;
    this.#render();
    try {
      return work();
    } finally {
      model.withheld = withheld;
      this.redraw();
    }
  }

  /**
   * Takes in a state from outside, in one undo step.
   * @param {Promise<import("assur/app/opening.js").Taken | null>} coming
   */
  async take(coming) {
    const taken = await coming;
    if (!taken) return;
    this.notices.tell(taken.failure ? [taken.failure] : []);
    const { state } = taken;
    if (!state) return;
    this.#player.begin();
    this.history.step(() => this.store.put(state));
    this.mechanism.fit(true);
  }

  /**
   * Replaces the document with another, in one undo step. An open lesson stays open.
   * @param {State["kind"]} kind
   * @param {State["document"]} document of that kind
   * @param {readonly import("assur/state/change.js").Edit[]} edits changes that the engine makes to the document
   * @param {(summary: import("assur/state/details.js").Summary | null) => Partial<State["view"]>} look gives the view of the
   * document from the engine's summary, which is null if the engine refuses the document
   */
  choose(kind, document, edits = [], look = () => ({})) {
    const { store, model, address } = this;
    model.follow(store.get());
    const before = model.lastAccepted;
    this.#player.begin();
    choose(kind, document, edits, look, this);
    // A document that the engine refuses does not enter the address bar.
    model.follow(store.get());
    address.enter(before, model.lastAccepted);
  }

  /**
   * Sets the driver to a position chosen by the reader, and stops the motion there.
   * @param {number} inputShown of the driver, in the reader's unit
   */
  drive(inputShown) {
    this.drafts.drop(INPUT);
    this.store.update((state) => stoppedAt(state, inputShown, this.model));
  }

  /**
   * Moves the driver by small steps of its coordinate, and stops the motion there.
   * @param {number} count of steps; negative for steps back
   */
  step(count) {
    const { coordinate } = this.model;
    this.drive(coordinate.of(this.store.get()) + count * coordinate.step);
  }

  /** Scrolls the open lesson into view and focuses it. */
  attend() {
    this.#toLesson();
  }

  /** @param {Words} words words of the new language */
  setLanguage(words) {
    this.#applyWords(words);
    this.redraw();
  }

  /**
   * Adds the words of forces and of motion under load to those of the page.
   * @template T
   * @param {Promise<T>} part that needs the words of forces
   * @returns {Promise<T>} the part, once the words are there
   */
  withForces(part) {
    return this.withWords("forces/words.*", part);
  }

  /**
   * Adds the words that a first view does not show. If they do not load, the next call tries again.
   * @returns {Promise<void>}
   */
  withFurther() {
    this.#further ??= this.withWords("app/later.*", Promise.resolve()).then(() => this.redraw());
    this.#further.catch(() => { this.#further = null; });
    return this.#further;
  }

  /**
   * Adds words of a part to those of the page, in any language.
   * @template T
   * @param {string} files of the words, with an asterisk for the language
   * @param {Promise<T>} part that needs the words
   * @returns {Promise<T>} the part, once the words are there
   */
  async withWords(files, part) {
    const loaded = await part;
    let words;
    // Another language may have been chosen during the load.
    do words = await Words.extended(files, this.words.lang);
    while (words.lang !== this.words.lang);
    this.#applyWords(words);
    return loaded;
  }

  /** @param {import("assur/state/player.js").Course | null} course that the motion follows instead of its pace; null ends it */
  follow(course) {
    this.#player.course = course;
  }

  /** @param {Words} words words of the page; their unit of length is replaced by the document's */
  #applyWords(words) {
    const measured = words.measured(this.engine.lengths);
    if (measured === this.words) return;
    this.words = measured;
    writeTexts(measured);
  }

  /** @param {number} dt seconds */
  #play(dt) {
    this.#unwritten += dt;
    this.store.update((state) => this.#player.played(state, dt, this.engine, this.model));
    return this.store.get().view.playing;
  }

  #render() {
    this.model.follow(this.store.get());
    // The plotted quantity may have been removed along with a part of the mechanism.
    if (this.model.hasDanglingReference) {
      this.store.update((state) => withView(state, PARTS));
      this.model.follow(this.store.get());
    }
    const state = this.store.get();
    this.#applyWords(this.words);
    const numbersDue = !state.view.playing || this.#unwritten >= WRITING_PERIOD;
    if (numbersDue) this.#unwritten = 0;
    this.theme.project(state.view.projector);
    this.#views.render(this.model.snapshot(state, this.words, numbersDue));
  }
}
