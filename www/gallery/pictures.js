// Small drawings of mechanisms, painted when they come into view, with the code and the colours of the large drawing.
import { Transform } from "assur/canvas/transform.js";
import { make } from "assur/core/dom.js";
import { attempt } from "assur/core/problem.js";
import { Figure } from "assur/stage/figure.js";
import { withoutExtras } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {() => Promise<State | null>} Source loads the state of a picture; null if its document does not exist
 * @typedef {{ figure: Figure, bounds: readonly number[] }} Sketch
 */

/** Free room around a drawing, in pixels. */
const MARGIN = 9;

export class Pictures {
  #page;
  /** @type {Map<Element, Source>} sources of pictures not yet in view */
  #coming = new Map();
  /** @type {Map<HTMLCanvasElement, Sketch>} drawn pictures */
  #drawn = new Map();
  #watch;
  /** Resolves when the last picture in the queue is drawn. One picture per frame keeps the page responsive. */
  #turn = Promise.resolve();

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {HTMLElement} window area in which the pictures scroll
   */
  constructor(page, window) {
    this.#page = page;
    this.#watch = new IntersectionObserver((entries) => {
      for (const { target, isIntersecting } of entries) {
        const source = this.#coming.get(target);
        if (isIntersecting && source && target instanceof HTMLCanvasElement) this.#bring(target, source);
      }
    }, { root: window, rootMargin: "120px" });
  }

  /**
   * @param {Source} source
   * @returns {HTMLCanvasElement}
   */
  add(source) {
    const canvas = make("canvas", { class: "picture", "aria-hidden": "true" });
    this.#coming.set(canvas, source);
    this.#watch.observe(canvas);
    return canvas;
  }

  /** Repaints the pictures drawn so far after the colours or the size change. */
  repaint() {
    for (const [canvas, sketch] of this.#drawn) this.#paint(canvas, sketch);
  }

  close() {
    this.#watch.disconnect();
    this.#coming.clear();
    this.#drawn.clear();
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Source} source
   */
  async #bring(canvas, source) {
    this.#coming.delete(canvas);
    this.#watch.unobserve(canvas);
    // A card whose mechanism does not load stays without a picture.
    const state = await source().catch(() => null);
    if (!state) return;
    this.#turn = this.#turn.then(() => new Promise(requestAnimationFrame)).then(() => this.#draw(canvas, state));
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {State} state
   */
  #draw(canvas, state) {
    if (!canvas.isConnected) return;
    const { engine, theme, words, model: { coordinate } } = this.#page;
    const { value } = attempt(() => engine.withScratchSimulator((other) => {
      const summary = other.set(withoutExtras(state));
      return { bounds: summary.bounds, scene: other.scene(), frame: other.at("home" in summary ? summary.home : 0).frame };
    }));
    if (!value) return;
    const { bounds, scene, frame } = value;
    const figure = new Figure(engine, theme);
    figure.take({ scene, frame, frameInput: 0, coordinate, readouts: null, revision: 1, words });
    this.#drawn.set(canvas, { figure, bounds });
    this.#paint(canvas, { figure, bounds });
  }

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {Sketch} sketch
   */
  #paint(canvas, { figure, bounds }) {
    const { clientWidth: width, clientHeight: height } = canvas;
    const context = canvas.getContext("2d");
    if (!context || width === 0) return;
    const ratio = globalThis.devicePixelRatio || 1;
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    const view = Transform.fit(bounds, width, height, MARGIN);
    figure.paintStill({ context, ratio }, view);
    figure.paintMoving({ context, ratio }, view);
    canvas.dataset.drawn = "true";
  }
}
