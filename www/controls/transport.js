// The bottom bar: play and pause, direction, steps, scrubber, exact angle, speed.
import { NumberBox } from "assur/controls/number-box.js";
import { Scrubber } from "assur/controls/scrubber.js";
import { degrees } from "assur/core/angles.js";
import { byId, make } from "assur/core/dom.js";
import { placed, turned } from "assur/state/player.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/engine.js").Cycle} Cycle
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").View} View
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** The choice of speed with which the crank turns by ω₁. */
const TRUE_TIME = "true_time";

export const SPEEDS = Object.freeze([0.1, 0.25, 0.5, 1, 2, 4]);

export class Transport {
  #play = byId("play", HTMLButtonElement);
  #reverse = byId("reverse", HTMLButtonElement);
  #scrubber = byId("scrubber", HTMLInputElement);
  #bar;
  #speed = byId("speed", HTMLSelectElement);
  #angle;
  /** @type {View | null} the view the controls show */
  #view = null;
  /** @type {Cycle | null} the cycle the scrubber was made for */
  #cycle = null;
  /** @type {[number, number][] | null} the parts of the scrubber where it can be assembled, if not all of them */
  #arcs = null;
  #lang = "";

  /**
   * @param {import("assur/app/page.js").Page} page
   */
  constructor({ store, model, drafts, theme }) {
    this.#bar = new Scrubber(byId("scrubber-bar", HTMLCanvasElement), theme);
    const put = (/** @type {number} */ phiDeg) => store.update((state) => placed(state, phiDeg, model));
    const step = (/** @type {number} */ by) => {
      drafts.drop("phi_deg");
      put(store.get().view.phi_deg + by);
    };
    this.#play.addEventListener("click", () => {
      drafts.drop("phi_deg");
      store.update((state) => withView(state, { playing: !state.view.playing }));
    });
    this.#reverse.addEventListener("click", () => {
      store.update((state) => withView(state, { direction: turned(state.view.direction) }));
    });
    byId("step-back", HTMLButtonElement).addEventListener("click", () => step(-1));
    byId("step-forward", HTMLButtonElement).addEventListener("click", () => step(1));
    this.#scrubber.addEventListener("input", () => {
      drafts.drop("phi_deg");
      put(Number(this.#scrubber.value));
    });
    this.#angle = new NumberBox(byId("angle", HTMLInputElement), "phi_deg", drafts, (value) => {
      put(value);
      return store.get().view.phi_deg;
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
    const { summary, phiDeg, words, legible } = snapshot;
    if (this.#lang !== words.lang) this.#translate(words);
    if (this.#view !== snapshot.state.view) this.#controls(snapshot.state.view, words);
    if (this.#cycle !== summary.cycle) this.#fit(summary.cycle);
    const [start, end] = [degrees(summary.cycle.start), degrees(summary.cycle.end)];
    this.#bar.show((phiDeg - start) / (end - start), this.#arcs);
    if (legible) this.#write(snapshot);
  }

  /** @param {Snapshot} snapshot */
  #write({ state, words, phiDeg, problems, stale }) {
    const angle = `${words.numbers.fixed(phiDeg, 3)}°`;
    const { playing } = state.view;
    this.#scrubber.value = String(phiDeg);
    if (!playing) this.#scrubber.setAttribute("aria-valuetext", angle);
    if (playing && this.#angle.busy) return;
    const unplaced = problems.some(({ code, phi }) => phi !== undefined && code !== "dead_point");
    const written = { brief: angle, full: `${words.numbers.exact(phiDeg)}°` };
    this.#angle.show(state.view.phi_deg, written, unplaced && !stale);
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
   * A speed from a link may be none of the list: it joins it.
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
    for (const option of this.#speed.options) {
      const times = { value: words.numbers.upTo(Number(option.value), 2) };
      option.textContent = option.value === TRUE_TIME ? words.text("transport.true_time") : words.text("transport.times", times);
    }
    this.#view = null;
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
   * The scrubber shows the whole axis; where nothing can be assembled its track is broken.
   * @param {Cycle} cycle
   */
  #fit(cycle) {
    this.#cycle = cycle;
    const { start, end, full, arcs } = cycle;
    this.#scrubber.min = String(degrees(start));
    this.#scrubber.max = String(degrees(end));
    const part = (/** @type {number} */ phi) => (phi - start) / (end - start);
    this.#arcs = full ? null : arcs.map(([from, to]) => [part(from), part(to)]);
  }
}
