// The bottom bar: play and pause, direction, steps, scrubber, exact input, speed.
import { NumberBox } from "assur/controls/number-box.js";
import { Scrubber } from "assur/controls/scrubber.js";
import { byId, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { readable } from "assur/core/numbers.js";
import { INPUT } from "assur/state/drafts.js";
import { stoppedAt, turned } from "assur/state/player.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").View} View
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Entry for true time in the list of speeds: the input then moves at its rate ω₁. */
const TRUE_TIME = "true_time";

export const SPEEDS = Object.freeze([0.1, 0.25, 0.5, 1, 2, 4]);

export class Transport {
  #play = byId("play", HTMLButtonElement);
  #reverse = byId("reverse", HTMLButtonElement);
  #scrubber = byId("scrubber", HTMLInputElement);
  #bar;
  #speed = byId("speed", HTMLSelectElement);
  #symbol = byId("input-symbol", HTMLElement);
  #steps = Object.freeze([
    { button: byId("step-back", HTMLButtonElement), sense: /** @type {const} */ (-1) },
    { button: byId("step-forward", HTMLButtonElement), sense: /** @type {const} */ (1) },
  ]);
  #box;
  /** @type {View | null} view shown by the controls */
  #view = null;
  /** @type {import("assur/types/web.js").CycleSummary | null} cycle shown by the scrubber */
  #cycle = null;
  /** Start of the scrubber's axis, in the reader's unit. */
  #start = 0;
  /** @type {[number, number][] | null} parts of the axis, from 0 to 1, in which the linkage can be assembled; null for the whole axis */
  #arcs = null;
  /** Speeds to choose from, with every other speed that the page has had, for example from an address. */
  #speeds = new Set(SPEEDS);
  #lang = "";

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    const { store, model, drafts, theme } = page;
    this.#bar = new Scrubber(byId("scrubber-bar", HTMLCanvasElement), theme);
    this.#play.addEventListener("click", () => {
      drafts.drop(INPUT);
      store.update((state) => withView(state, { playing: !state.view.playing }));
    });
    this.#reverse.addEventListener("click", () => {
      store.update((state) => withView(state, { direction: turned(state.view.direction) }));
    });
    this.#steps.forEach(({ button, sense }) => button.addEventListener("click", () => page.step(sense)));
    this.#scrubber.addEventListener("input", () => page.drive(Number(this.#scrubber.value)));
    this.#box = new NumberBox(byId("angle", HTMLInputElement), INPUT, drafts, (value) => {
      store.update((state) => stoppedAt(state, value, model));
      return model.coordinate.of(store.get());
    });
    // A drawing that does not move yet shows the speeds too.
    this.#offer(store.get().view, model.coordinate.moves, page.words);
    this.#speed.addEventListener("change", () => {
      const { value } = this.#speed;
      const change = value === TRUE_TIME ? { true_time: true } : { speed: Number(value), true_time: false };
      store.update((state) => withView(state, change));
    });
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { summary, coordinate, inputShown, words, numbersDue } = snapshot;
    if (this.#lang !== words.lang) this.#translate(words);
    if (this.#view !== snapshot.state.view) this.#controls(snapshot.state.view, coordinate.moves, words);
    const { start, end } = coordinate.axis(inputShown);
    if (this.#cycle !== summary.cycle || this.#start !== start) this.#fit(snapshot, start);
    this.#bar.show(Math.min(Math.max((inputShown - start) / (end - start), 0), 1), this.#arcs);
    if (numbersDue) this.#write(snapshot);
  }

  /** @param {Snapshot} snapshot */
  #write({ state, words, coordinate, inputShown, stale, faded }) {
    const { playing } = state.view;
    const brief = coordinate.written(inputShown, words, readable(3, playing));
    this.#scrubber.value = String(inputShown);
    if (!playing) this.#scrubber.setAttribute("aria-valuetext", brief);
    if (playing && this.#box.busy) return;
    this.#box.show(inputShown, { brief, full: coordinate.exact(inputShown, words) }, faded && !stale);
  }

  /**
   * @param {View} view
   * @param {string} moves
   * @param {Words} words
   */
  #controls(view, moves, words) {
    const previous = this.#view;
    this.#view = view;
    if (previous?.playing !== view.playing) this.#name(words, view.playing);
    if (previous?.direction !== view.direction) this.#reverse.setAttribute("aria-pressed", String(view.direction < 0));
    if (previous?.speed !== view.speed || previous.true_time !== view.true_time) this.#offer(view, moves, words);
  }

  /**
   * @param {View} view
   * @param {string} moves
   * @param {Words} words
   */
  #offer({ speed, true_time: trueTime }, moves, words) {
    const speeds = [...this.#speeds.add(speed)].sort((one, other) => one - other);
    const times = (/** @type {number} */ value) => words.text("transport.times", { value: words.numbers.upTo(value, 2) });
    // A document whose input is time already plays in real time.
    render([
      ...speeds.map((value) => html`<option value=${value}>${times(value)}</option>`),
      html`<option value=${TRUE_TIME} ?hidden=${moves === "time"}>${words.text(`transport.true_time.${moves}`)}</option>`,
    ], this.#speed);
    this.#speed.value = trueTime ? TRUE_TIME : String(speed);
  }

  /** @param {Words} words */
  #translate(words) {
    this.#lang = words.lang;
    this.#view = null;
    this.#cycle = null;
  }

  /**
   * @param {Words} words
   * @param {boolean} playing
   */
  #name(words, playing) {
    this.#play.dataset.playing = String(playing);
    const name = words.text(playing ? "transport.pause" : "transport.play");
    this.#play.ariaLabel = name;
    this.#play.title = name;
  }

  /**
   * Sets the scrubber to the whole axis, and writes the names and step sizes of the controls. The bar has gaps where the linkage cannot be assembled.
   * @param {Snapshot} snapshot
   * @param {number} first start of the axis, in the reader's unit
   */
  #fit({ summary: { cycle }, coordinate, words, state: { view } }, first) {
    this.#cycle = cycle;
    this.#start = first;
    const { start, end, full, arcs } = cycle;
    this.#scrubber.min = String(first);
    this.#scrubber.max = String(coordinate.last(first));
    const part = (/** @type {number} */ input) => (input - start) / (end - start);
    // If the input is time, the bar has no gaps: every time up to the end can be reached.
    this.#arcs = full || coordinate.moves === "time" ? null : arcs.map(([from, to]) => [part(from), part(to)]);
    const { moves, step } = coordinate;
    write(this.#symbol, coordinate.symbol);
    const size = words.numbers.short(step) + (moves === "angle" ? "°" : "");
    for (const { button, sense } of this.#steps) {
      write(button, (sense < 0 ? "−" : "+") + size);
      const name = words.text(`transport.${sense < 0 ? "back" : "forward"}`, { n: size });
      button.ariaLabel = name;
      button.title = name;
    }
    for (const [element, key] of /** @type {const} */ ([[this.#scrubber, "scrubber"], [byId("angle", HTMLInputElement), "input"]])) {
      element.ariaLabel = words.text(`transport.${key}.${moves}`);
    }
    this.#offer(view, moves, words);
  }
}
