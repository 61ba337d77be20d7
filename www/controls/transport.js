// The bottom bar: play and pause, direction, steps, scrubber, exact input, speed.
import { NumberBox } from "assur/controls/number-box.js";
import { Scrubber } from "assur/controls/scrubber.js";
import { byId, make, write } from "assur/core/dom.js";
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
    for (const speed of [...SPEEDS, TRUE_TIME]) this.#speed.append(make("option", { value: String(speed) }));
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
    if (this.#view !== snapshot.state.view) this.#controls(snapshot.state.view, words);
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
   * @param {Words} words
   */
  #controls(view, words) {
    const previous = this.#view;
    this.#view = view;
    if (previous?.playing !== view.playing) this.#name(words, view.playing);
    if (previous?.direction !== view.direction) this.#reverse.setAttribute("aria-pressed", String(view.direction < 0));
    if (previous?.speed !== view.speed || previous.true_time !== view.true_time) this.#hasten(view, words);
  }

  /**
   * Shows a speed. A speed that the list lacks, such as a speed from a URL, is added to the list.
   * @param {View} view
   * @param {Words} words
   */
  #hasten({ speed, true_time: trueTime }, words) {
    const value = String(speed);
    const options = [...this.#speed.options];
    if (!options.some((option) => option.value === value)) {
      const next = options.find((option) => !(Number(option.value) <= speed)) ?? null;
      const text = words.text("transport.times", { value: words.numbers.upTo(speed, 2) });
      this.#speed.insertBefore(make("option", { value }, [text]), next);
    }
    this.#speed.value = trueTime ? TRUE_TIME : value;
  }

  /** @param {Words} words */
  #translate(words) {
    this.#lang = words.lang;
    this.#view = null;
    this.#cycle = null;
  }

  /**
   * @param {Words} words
   * @param {string} moves
   */
  #translateSpeeds(words, moves) {
    for (const option of this.#speed.options) {
      const times = { value: words.numbers.upTo(Number(option.value), 2) };
      option.textContent = option.value === TRUE_TIME ? words.text(`transport.true_time.${moves}`) : words.text("transport.times", times);
      // A document whose input is time already plays in real time.
      if (option.value === TRUE_TIME) option.hidden = moves === "time";
    }
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
   * Sets the scrubber to the whole axis. Its bar has gaps where the linkage cannot be assembled.
   * @param {Snapshot} snapshot
   * @param {number} first start of the axis, in the reader's unit
   */
  #fit({ summary: { cycle }, coordinate, words }, first) {
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
    this.#translateSpeeds(words, moves);
  }
}
