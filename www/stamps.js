// Texts that stay the same while all moves, as small pictures: to copy one costs a browser a fraction of what it costs
// to write it anew with its halo.

/** So many are kept; then all are made anew. */
const MOST = 64;

export class Stamps {
  /** @type {Map<string, ImageBitmap>} */
  #made = new Map();

  /**
   * @param {string} key what tells the picture from others
   * @param {number} width device pixels
   * @param {number} height
   * @param {(context: OffscreenCanvasRenderingContext2D) => void} paint called where the picture has to be made
   * @returns {ImageBitmap}
   */
  get(key, width, height, paint) {
    const made = this.#made.get(key);
    if (made) return made;
    const canvas = new OffscreenCanvas(width, height);
    const context = canvas.getContext("2d");
    if (!context) throw new Error("no 2d context");
    paint(context);
    const picture = canvas.transferToImageBitmap();
    if (this.#made.size >= MOST) this.#made.clear();
    this.#made.set(key, picture);
    return picture;
  }
}
