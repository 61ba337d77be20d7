// Canvas with the resolution of the screen: the number of its pixels follows its size on the page and the device-pixel ratio.

export class Surface {
  /** Size in CSS pixels. */
  width = 0;
  height = 0;
  /** Device pixels per CSS pixel. */
  ratio = 1;
  #redraw;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {() => void} redraw called when the size or the resolution of the canvas has changed
   * @param {CanvasRenderingContext2DSettings} [settings]
   */
  constructor(canvas, redraw, settings) {
    const context = canvas.getContext("2d", settings);
    if (!context) throw new Error("no 2d context");
    this.canvas = canvas;
    this.context = context;
    this.#redraw = redraw;
    new ResizeObserver(() => this.#measure()).observe(canvas);
    this.#watchRatio();
  }

  /** Clears the canvas and makes a unit of the context one CSS pixel. */
  clear() {
    const { context, canvas } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    this.toPixels();
  }

  /** Makes a unit of the context one CSS pixel. */
  toPixels() {
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
  }

  /**
   * Resizes the canvas to its size on the page. The caller must paint at once, because a resized canvas is blank.
   * @returns {boolean} whether there is a visible area to paint on
   */
  begin() {
    if (!this.visible) return false;
    const { canvas } = this;
    const [width, height] = [this.width, this.height].map((pixels) => Math.max(Math.round(pixels * this.ratio), 1));
    if (canvas.width !== width) canvas.width = width;
    if (canvas.height !== height) canvas.height = height;
    return true;
  }

  get visible() {
    return this.width > 0 && this.height > 0;
  }

  #measure() {
    const ratio = globalThis.devicePixelRatio || 1;
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width === this.width && height === this.height && ratio === this.ratio) return;
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    this.#redraw();
  }

  /** Watches the resolution: a window that moves to another screen may keep its size and yet change its resolution. */
  #watchRatio() {
    matchMedia(`(resolution: ${globalThis.devicePixelRatio}dppx)`).addEventListener(
      "change",
      () => {
        this.#measure();
        this.#watchRatio();
      },
      { once: true },
    );
  }
}
