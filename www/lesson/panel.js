// A lesson step by step: a text, mechanisms to open, a question with a checked answer. Loaded with the first lesson.
import { make, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { marked, withSubscripts, writeSubscripted } from "assur/core/subscripts.js";
import { answerFields, NO_FIELDS } from "assur/lesson/answer-fields.js";
import { OwnMechanism } from "assur/lesson/own.js";
import { Paper } from "assur/lesson/paper.js";
import { Progress } from "assur/lesson/progress.js";
import { progressSaid, verdictSaid } from "assur/lesson/said.js";
import { Tools } from "assur/lesson/tools.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").AnySnapshot} Snapshot
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/core/words.js").Words} Words
 *
 * @typedef {"right" | "not_yet" | "unread" | "unanswered" | "none" | "stale"} Verdict
 * @typedef {import("assur/state/state.js").View} View
 * @typedef {Readonly<{ verdict: Verdict | "shown", brought: boolean, document: State["document"] }>} Judged `brought`: whether the page had shown another
 * mechanism, so that the step's was opened again. `document`: the document that the verdict is about
 *
 * @typedef {Readonly<{ id: string, text: string, open: (view?: Partial<View>) => void, opened?: (state: State) => boolean, href?: string }>} Shown a button. `open`: opens its
 * document. `opened`: whether a state holds that document. `href`: address of a page, if the button is a link instead
 * @typedef {Readonly<{
 *   text: string, unit: string, options: readonly Readonly<{ value: string, text: string }>[] | null, hides: readonly string[],
 *   judge: (given: string, snapshot: Snapshot) => Verdict, hint: () => string, right: (snapshot: Snapshot) => string,
 *   answer: (snapshot: Snapshot) => string | null, ofPage: boolean, reached?: (snapshot: Snapshot) => boolean,
 * }>} Question
 * `options`: answers to choose from, null if a number is to be typed. `hides`: quantities and read-outs that give the answer away, hidden until the reader
 * has answered or given up. `right`: comment on a right answer. `answer`: the right answer in words, null if there is none. `ofPage`: whether the question
 * is about the mechanism on the page, which must be the step's. `reached`: if given, nothing is typed; the answer is right as soon as this is true.
 * @typedef {{ readonly element: HTMLElement, render(snapshot: Snapshot, words: Words): void }} Figure figure of a step, made anew if the words change
 * @typedef {Readonly<{
 *   id: string, title: string, text: string, formula: string, shows: readonly Shown[], from: number | null, question: Question | null,
 *   tools: import("assur/lesson/tools.js").Wanted & { figure?: (engine: import("assur/engine.js").Engine) => Figure },
 * }>} Told a step in words. `id`: key of its progress. `from`: index of the step whose mechanism
 * this step shows, null if it shows none
 * @typedef {{
 *   readonly id: string, readonly name: string, readonly paper?: import("assur/lesson/paper.js").Printed, tell(words: Words): readonly Told[],
 *   frame?(step: HTMLElement[], progress: Progress, renew: () => Progress): HTMLElement[], answered?(): void,
 * }} Source
 * Source of a lesson. `id`: used in links. `name`: key of its progress. `paper`: items of its paper. `tell`: gives the steps. `frame`: puts
 * further elements around a step; its `renew` takes over the progress kept under another name. `answered`: called whenever an answer may have changed.
 */

/** Id of the end of a lesson, which does not count as a step. */
export const END = "end";

export class LessonPanel {
  #page;
  #source;
  /** @type {readonly Told[]} */
  #steps;
  #progress;
  /** @type {Words} */
  #words;
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** @type {Map<string, Judged>} verdicts by the id of the step */
  #judged = new Map();
  #shown = new Seen();
  #left = () => this.#leave();
  /** Whether the reader has just turned to another step, so that its beginning is scrolled into view. */
  #turned = false;
  /** Id of the step whose mechanism is followed. */
  #begun = "";
  #given = NO_FIELDS;

  #back = make("button", { id: "lesson-back", class: "control icon", type: "button", onclick: () => this.#go(-1) }, ["‹"]);
  #on = make("button", { id: "lesson-on", class: "control icon", type: "button", onclick: () => this.#go(1) }, ["›"]);
  #walked = make("p", { id: "lesson-progress", role: "status" });
  #body = make("div", { class: "lesson-body" });
  #title = make("h2", { id: "lesson-title", tabindex: "-1" });
  #text = make("div", { class: "lesson-text" });
  #shows = make("div", { class: "segments" });
  #legend = make("legend", { id: "lesson-question" });
  #fields = make("div", { class: "choices" });
  #check = make("button", { id: "lesson-check", class: "control", form: "lesson-form" });
  #reveal = make("button", { id: "lesson-reveal", class: "control", type: "button", onclick: () => this.#showAnswer() });
  /** Goes to the first step that is neither solved nor shown. Offered on the first step, if the reader has been further before. */
  #resume = make("button", { id: "lesson-resume", class: "control", type: "button", hidden: "", onclick: () => this.#resumeStep() });
  #form;
  #said = make("p", { id: "lesson-said", role: "status" });
  #tools;
  /** @type {Figure | undefined} */
  #figure;
  #drawn = make("div", { class: "lesson-figure" });
  /** @type {Paper | undefined} */
  #paper;
  #own;

  /**
   * @param {HTMLElement} container
   * @param {import("assur/app/page.js").Page} page
   * @param {Source} source
   * @param {Words} words words of the page and of the lesson
   */
  constructor(container, page, source, words) {
    this.#page = page;
    this.#source = source;
    this.#words = words;
    this.#steps = source.tell(words);
    this.#progress = new Progress(source.name, this.steps());
    const form = this.#form = make("form", { id: "lesson-form", autocomplete: "off" }, [make("fieldset", {}, [this.#legend, this.#fields]), this.#said]);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this.#answer();
    });
    this.#tools = new Tools(page.shown);
    this.#own = new OwnMechanism(page, this.#tools.element);
    addEventListener("pagehide", this.#left);
    const walk = make("div", { class: "lesson-walk" }, [this.#back, this.#check, this.#on]);
    const state = make("div", { class: "lesson-state" }, [this.#walked, this.#reveal]);
    const paper = this.#paper = source.paper && new Paper(page.engine, source.paper);
    const step = [this.#title, this.#resume, this.#text, ...(paper ? [paper.main] : []), this.#shows, this.#drawn, this.#tools.element, ...(paper ? [paper.fold] : [])];
    this.#body.replaceChildren(...(source.frame?.(step, this.#progress, () => this.#renew()) ?? step));
    container.replaceChildren(this.#body, make("div", { class: "lesson-foot" }, [form, walk, state]));
  }

  /** Keeps the digest of the step's mechanism, because the reader may leave the page. */
  #leave() {
    if (this.#begun) this.#progress.leave(this.#begun, this.#own.digest);
  }

  /**
   * Takes over the progress kept under the name just typed. All buttons stay in the page: the typing may have ended with a press on one of
   * them, whose click follows.
   * @returns {Progress}
   */
  #renew() {
    this.#leave();
    this.#progress = new Progress(this.#source.name, this.steps());
    this.#judged.clear();
    this.#begun = "";
    this.#begin(this.#step);
    this.#given.fill(this.#progress.given(this.#step.id));
    this.#withhold();
    this.#count();
    this.#said.dataset.verdict = "past";
    this.#page.redraw();
    return this.#progress;
  }

  /** Ends the lesson. The panel cannot be used again. */
  end() {
    this.#leave();
    this.close();
    removeEventListener("pagehide", this.#left);
    this.#own.close();
  }

  /** Returns borrowed parts to the page, and shows hidden read-outs. */
  close() {
    this.#tools.close();
    this.#shown = new Seen();
    this.#setWithheld([]);
  }

  /** @param {Words} words */
  setWords(words) {
    this.#words = words;
    this.#steps = this.#source.tell(words);
  }

  /** @returns {readonly Told[]} steps without the end of the lesson */
  steps() {
    return this.#steps.filter(({ id }) => id !== END);
  }

  /**
   * @param {string} step id of a step
   * @returns {HTMLElement[]} the items of the lesson's paper for this step
   */
  onPaper(step) {
    return this.#paper?.onPaper(step, this.#words) ?? [];
  }

  /** Focuses the title, for a reader who opened the lesson by a key. */
  focus() {
    this.#title.focus();
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    this.#snapshot = snapshot;
    const number = this.#number(snapshot.state);
    const step = this.#steps[number - 1];
    // A verdict on another mechanism is outdated.
    const judged = this.#judged.get(step.id);
    const outdated = judged !== undefined && judged.document !== snapshot.state.document;
    if (outdated) this.#judged.delete(step.id);
    if (!this.#shown.same(number, this.#words)) this.#write(number);
    if (snapshot.numbersDue) {
      this.#tools.borrow();
      this.#paper?.render(snapshot);
      this.#figure?.render(snapshot, this.#words);
    }
    if (outdated) this.#say();
    if (step.question?.reached?.(snapshot) && !this.#progress.isSolved(step.id)) this.#answer();
  }

  /**
   * Returns the number of the open step. A link to a step that no longer exists opens the last step.
   * @param {State} state
   */
  #number({ view }) {
    return Math.min(view.lesson?.step ?? 1, this.#steps.length);
  }

  get #step() {
    return this.#steps[this.#number(this.#page.store.get()) - 1];
  }

  /** @param {number} by */
  #go(by) {
    this.#goTo(this.#number(this.#page.store.get()) + by);
  }

  /** Goes to the first step that is neither solved nor shown. */
  #resumeStep() {
    this.#goTo(this.#progress.next + 1);
    this.#title.focus();
  }

  /** Begins the lesson anew: at its first step, without the answers given. */
  #again() {
    this.#progress.forget();
    this.#judged.clear();
    this.#goTo(1);
    this.#title.focus();
  }

  /**
   * Goes to another step and shows its mechanism. A single undo brings back the mechanism shown before.
   * @param {number} wanted number of the step
   */
  #goTo(wanted) {
    const { store } = this.#page;
    const { lesson } = store.get().view;
    const number = this.#number(store.get());
    // A button pressed twice in one frame may lead past the last step.
    const next = Math.min(Math.max(wanted, 1), this.#steps.length);
    if (!lesson || next === number) return;
    const step = this.#steps[next - 1];
    const view = { lesson: { ...lesson, step: next } };
    this.#begin(step);
    this.#turned = true;
    if (step.from === null || step.from === this.#steps[number - 1].from) store.update((state) => withView(state, view));
    else this.#own.open(step.shows[0].open, view);
  }

  /** @param {Told} step step whose mechanism is followed */
  #begin({ id, shows }) {
    if (id === this.#begun) return;
    this.#own.begin(shows, this.#progress.mechanism(id));
    this.#begun = id;
  }

  /** @param {number} number */
  #write(number) {
    const words = this.#words;
    const step = this.#steps[number - 1];
    const { title, text, formula, shows, question } = step;
    this.#back.ariaLabel = this.#back.title = words.text("lesson.back");
    this.#on.title = words.text("lesson.on");
    write(this.#on, `${words.text("lesson.next")} ›`);
    // A button that becomes disabled passes the focus to the opposite button.
    const focused = document.activeElement;
    this.#back.disabled = number === 1;
    this.#on.disabled = number === this.#steps.length;
    if (focused === this.#back && this.#back.disabled) this.#on.focus();
    if (focused === this.#on && this.#on.disabled) this.#back.focus();

    write(this.#title, title);
    const { next } = this.#progress;
    this.#resume.hidden = number !== 1 || next < 1;
    write(this.#resume, words.text("lesson.resume", { number: words.numbers.exact(next + 1) }));
    const paragraphs = text.split("\n").map((one) => make("p", {}, marked(one)));
    const lines = formula === "" ? [] : [make("p", { class: "formula" }, withSubscripts(formula))];
    this.#text.replaceChildren(...paragraphs, ...lines);
    const again = make("button", { id: "lesson-again", class: "segment", type: "button", onclick: () => this.#again() }, [words.text("lesson.again")]);
    this.#shows.replaceChildren(...shows.map(({ id, text: said, open, href }) => {
      if (href !== undefined) return make("a", { id, href, target: "_blank", rel: "noopener" }, [said]);
      return make("button", { id, class: "segment", type: "button", onclick: () => this.#own.open(open) }, [said]);
    }), ...(step.id === END ? [again] : []));
    this.#paper?.show(step.id, step.id === END, words);
    this.#figure = step.tools.figure?.(this.#page.engine);
    this.#drawn.replaceChildren(...(this.#figure ? [this.#figure.element] : []));
    this.#begin(step);
    this.#form.hidden = !question;
    this.#check.hidden = !question || question.reached !== undefined;
    writeSubscripted(this.#legend, question?.text ?? "");
    this.#given = question ? answerFields(question, (given) => this.#give(step.id, given)) : NO_FIELDS;
    this.#fields.replaceChildren(...this.#given.elements);
    this.#given.fill(this.#progress.given(step.id));
    write(this.#check, words.text("lesson.check"));
    write(this.#reveal, words.text("lesson.reveal"));
    this.#tools.show(step.tools, () => this.#page.store.get().document);
    this.#withhold();
    this.#say();
    if (this.#turned) {
      this.#body.scrollTop = 0;
      this.#title.scrollIntoView({ block: "nearest" });
    }
    this.#turned = false;
  }

  /** Hides read-outs that give the answer away, until the question is answered or the answer is shown. */
  #withhold() {
    const step = this.#step;
    const solved = this.#progress.isSolved(step.id);
    const { hides = [], reached } = step.question ?? {};
    this.#setWithheld(solved || this.#progress.isShown(step.id) ? [] : hides);
    this.#reveal.hidden = !step.question || solved || reached !== undefined;
  }

  /** @param {readonly string[]} hides quantities and read-outs to hide */
  #setWithheld(hides) {
    const { model } = this.#page;
    if (hides.join() === [...model.withheld].join()) return;
    model.withheld = new Set(hides);
    this.#page.redraw();
  }

  /**
   * Keeps an answer given by hand; it is not judged yet.
   * @param {string} id of its step
   * @param {string} given
   */
  #give(id, given) {
    this.#progress.give(id, given);
    this.#judged.delete(id);
    this.#say();
  }

  #answer() {
    const { id, question } = this.#step;
    if (!question) return;
    const brought = this.#bringOwn(question);
    const given = this.#progress.given(id);
    const again = !brought && this.#judged.get(id)?.document === this.#page.store.get().document;
    const verdict = question.judge(given, this.#now());
    if (!again && (verdict === "right" || verdict === "not_yet")) this.#progress.countTry(id, verdict === "right");
    this.#judge({ verdict, brought });
  }

  /** Shows the right answer, and records that it was shown. */
  #showAnswer() {
    const { id, question } = this.#step;
    if (!question) return;
    const brought = this.#bringOwn(question);
    const verdict = question.answer(this.#now()) === null ? "none" : "shown";
    if (verdict === "shown") this.#progress.show(id);
    this.#judge({ verdict, brought });
    this.#check.focus();
  }

  /**
   * Shows the step's mechanism again, if the question is about it and the page shows another.
   * @param {Question} question
   * @returns {boolean} whether the mechanism had to be opened again
   */
  #bringOwn({ ofPage }) {
    if (!ofPage || this.#own.there) return false;
    this.#own.bringBack();
    return true;
  }

  /** @returns {Snapshot} snapshot of the current state, even if it is not yet drawn */
  #now() {
    const { model, store } = this.#page;
    model.follow(store.get());
    return this.#snapshot = model.snapshot(store.get(), this.#page.words, true);
  }

  /** @param {Pick<Judged, "verdict" | "brought">} judged */
  #judge(judged) {
    this.#judged.set(this.#step.id, { ...judged, document: this.#page.store.get().document });
    this.#withhold();
    this.#say();
    this.#said.scrollIntoView({ block: "nearest" });
  }

  /** Writes the reader's progress: the number of the open step, and the numbers of solved and shown steps. */
  #count() {
    const number = this.#step.id === END ? null : this.#steps.indexOf(this.#step) + 1;
    write(this.#walked, progressSaid(number, this.steps().length, this.#progress, this.#words));
  }

  /** Writes the progress and the comment on the answer. */
  #say() {
    const step = this.#step;
    this.#count();
    const judged = this.#judged.get(step.id);
    this.#said.dataset.verdict = judged?.verdict ?? "";
    writeSubscripted(this.#said, judged ? verdictSaid(step.question, judged, this.#snapshot, this.#words) : "");
    this.#source.answered?.();
  }
}
