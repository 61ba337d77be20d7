// A canvas that is as sharp as the screen: its backing store follows its size and the device-pixel ratio.

export class Surface {
  /** Size in CSS pixels. */
  width = 0;
  height = 0;
  /** Device pixels per CSS pixel. */
  ratio = 1;
  #resized;

  /**
   * @param {HTMLCanvasElement} canvas
   * @param {() => void} resized called after the size changed, when the canvas is blank
   * @param {CanvasRenderingContext2DSettings} [settings]
   */
  constructor(canvas, resized, settings) {
    const context = canvas.getContext("2d", settings);
    if (!context) throw new Error("no 2d context");
    this.canvas = canvas;
    this.context = context;
    this.#resized = resized;
    new ResizeObserver(() => this.#measure()).observe(canvas);
    this.#watchRatio();
  }

  /** Blank, with one unit of the context being one CSS pixel. */
  clear() {
    const { context, canvas } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.clearRect(0, 0, canvas.width, canvas.height);
    this.toPixels();
  }

  /** One unit of the context is one CSS pixel. */
  toPixels() {
    this.context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
  }

  get visible() {
    return this.width > 0 && this.height > 0;
  }

  #measure() {
    const { canvas } = this;
    const ratio = globalThis.devicePixelRatio || 1;
    const { clientWidth: width, clientHeight: height } = canvas;
    if (width === this.width && height === this.height && ratio === this.ratio) return;
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    canvas.width = Math.max(Math.round(width * ratio), 1);
    canvas.height = Math.max(Math.round(height * ratio), 1);
    this.#resized();
  }

  /** A window moved to another screen keeps its size: only the resolution tells. */
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
