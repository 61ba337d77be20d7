// Where canvases are painted: by a worker beside the page, so that the page is free for the hands at it; on the page where no
// worker starts.
import { METHODS, PROPERTIES, Recorder, Track } from "assur/recorder.js";

/**
 * @typedef {import("assur/recorder.js").Calls} Calls
 * @typedef {{ made: [number, Calls][], painted: [number, Calls][], gone: number[] }} Painting
 * Paths that are used for the first time, calls of canvases in the order in which they were made, the paths used no more.
 */

export class Studio {
  #worker;
  #measure = new OffscreenCanvas(1, 1).getContext("2d");
  /** @type {Map<object, number>} the canvases */
  #canvases = new Map();
  /** @type {Map<object, number>} the paths of the last painting: the worker has them still */
  #kept = new Map();
  /** @type {Map<object, number>} those of this one */
  #used = new Map();
  /** @type {Painting} */
  #painting = { made: [], painted: [], gone: [] };
  #numbers = 0;

  /** Paintings on their way to being seen. */
  unseen = 0;
  /** @type {Set<() => void>} what waits until another can be sent */
  #waiting = new Set();

  /** @param {Worker | null} worker that knows what is called */
  constructor(worker) {
    this.#worker = worker;
    /** Kept when what was painted first is to be seen. */
    this.seen = worker && new Promise((resolve) => {
      worker.addEventListener("message", () => {
        this.unseen -= 1;
        if (this.unseen === 0) resolve(undefined);
        const waiting = [...this.#waiting];
        this.#waiting.clear();
        for (const paint of waiting) paint();
      });
    });
  }

  /** @returns {Promise<Studio>} */
  static async open() {
    try {
      const worker = new Worker(import.meta.resolve("assur/brush.js"));
      await new Promise((resolve, reject) => {
        worker.addEventListener("message", resolve, { once: true });
        worker.addEventListener("error", reject);
        worker.postMessage({ methods: METHODS, properties: PROPERTIES });
      });
      return new Studio(worker);
    } catch {
      return new Studio(null);
    }
  }

  /**
   * @param {HTMLCanvasElement | OffscreenCanvas} canvas from now on the studio's
   * @param {CanvasRenderingContext2DSettings} [settings]
   * @returns {any} its context
   */
  context(canvas, settings) {
    if (!this.#worker) return canvas.getContext("2d", settings);
    const number = ++this.#numbers;
    const offscreen = canvas instanceof OffscreenCanvas ? canvas : canvas.transferControlToOffscreen();
    this.#worker.postMessage({ number, canvas: offscreen, settings }, [offscreen]);
    const recorder = new Recorder((code, given) => this.#write(number, code, given), this.#measure);
    this.#canvases.set(recorder, number);
    return recorder;
  }

  /**
   * One painting may be on its way while another is made; what is more would only wait behind them.
   * @param {() => void} paint called when there is room again, if there is none
   * @returns {boolean} whether there is
   */
  takes(paint) {
    const room = this.unseen < 2;
    if (!room) this.#waiting.add(paint);
    return room;
  }

  /** @returns {any} an empty path */
  path() {
    return this.#worker ? new Track() : new Path2D();
  }

  /**
   * @param {number} number of the canvas
   * @param {number} code
   * @param {any[]} given
   */
  #write(number, code, given) {
    const { painted } = this.#painting;
    // All that the page paints without a pause is seen at once.
    if (painted.length === 0) queueMicrotask(() => this.#send());
    if (painted.at(-1)?.[0] !== number) painted.push([number, []]);
    const [first] = given;
    if (first instanceof Track || first instanceof Recorder) given[0] = { thing: this.#canvases.get(first) ?? this.#name(first) };
    painted.at(-1)?.[1].push(code, given.length, ...given);
  }

  /**
   * @param {Track} path
   * @returns {number}
   */
  #name(path) {
    const known = this.#used.get(path) ?? this.#kept.get(path);
    const number = known ?? ++this.#numbers;
    if (!known) this.#painting.made.push([number, path.calls]);
    this.#used.set(path, number);
    return number;
  }

  #send() {
    for (const [path, number] of this.#kept) if (!this.#used.has(path)) this.#painting.gone.push(number);
    this.#worker?.postMessage(this.#painting);
    this.unseen += 1;
    [this.#kept, this.#used] = [this.#used, new Map()];
    this.#painting = { made: [], painted: [], gone: [] };
  }
}
