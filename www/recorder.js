// A canvas's context whose calls are written down, to be made elsewhere. It has what our painting, and plotters by way of the
// engine, use of one.

/**
 * @typedef {(number | string | readonly number[] | { readonly thing: number })[]} Calls
 * One after the other: what is called, as a place in METHODS; how many arguments it has; these. What is set has one, and its
 * place in PROPERTIES follows those of METHODS. A path or a canvas to paint with is a thing with a number.
 */

const PATH = ["moveTo", "lineTo", "arc", "roundRect", "closePath"];
export const METHODS = Object.freeze([
  ...PATH, "beginPath", "fill", "stroke", "fillText", "strokeText", "clearRect", "fillRect", "drawImage", "setTransform", "setLineDash",
]);
/** The last two are the canvas's own. */
export const PROPERTIES = Object.freeze([
  "fillStyle", "strokeStyle", "globalAlpha", "lineWidth", "lineJoin", "lineCap", "font", "textAlign", "textBaseline", "width", "height",
]);

/** A path, as Path2D builds one. */
export class Track {
  /** @type {Calls} */
  calls = [];

  static {
    PATH.forEach((name, code) => {
      /** @type {any} */ (this.prototype)[name] = /** @this {Track} */ function (/** @type {number[]} */ ...given) {
        this.calls.push(code, given.length, ...given);
      };
    });
  }
}

export class Recorder {
  /** @type {Record<string, any>} what was set last */
  #set = {};
  #write;
  #measure;

  /**
   * @param {(code: number, given: any[]) => void} write
   * @param {OffscreenCanvasRenderingContext2D} measure measures texts
   */
  constructor(write, measure) {
    this.#write = write;
    this.#measure = measure;
  }

  /** The canvas, of which there are width and height. */
  get canvas() {
    return this;
  }

  /** @param {string} text */
  measureText(text) {
    this.#measure.font = this.#set.font;
    return this.#measure.measureText(text);
  }

  static {
    METHODS.forEach((name, code) => {
      /** @type {any} */ (this.prototype)[name] = /** @this {Recorder} */ function (/** @type {any[]} */ ...given) {
        this.#write(code, given);
      };
    });
    PROPERTIES.forEach((name, i) => Object.defineProperty(this.prototype, name, {
      /** @this {Recorder} */
      get() {
        return this.#set[name];
      },
      /** @this {Recorder} @param {any} value */
      set(value) {
        this.#set[name] = value;
        this.#write(METHODS.length + i, [value]);
      },
    }));
  }
}
