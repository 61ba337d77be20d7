// An animation as GIF: the page paints, a worker writes the file.
import { sheetOf } from "assur/export/beside.js";
import { inputs, moments, targetOn } from "assur/export/moments.js";

/** Shortest time for which programs show a picture, in hundredths of a second, the unit of GIF. */
const MIN_DELAY = 2;

/** Share of the progress bar for painting; the rest is for writing the file. */
const PAINTING = 1 / 3;

/**
 * @param {import("assur/app/page.js").Page} page
 * @param {import("assur/canvas/theme.js").Theme} theme
 * @param {import("assur/export/moments.js").Wishes} wishes
 * @param {import("assur/export/moments.js").Job} work
 * @returns {Promise<Blob>}
 */
export async function toGif(page, theme, wishes, { signal, tell }) {
  const { moments: count, width, seconds } = wishes;
  const { size, begin } = sheetOf(page, wishes);
  const canvas = new OffscreenCanvas(1, 1);
  const target = targetOn(canvas, size, width, { alpha: false, willReadFrequently: true });
  const { ground, moment } = begin(theme);
  // Called before waiting for the worker, because the page may show another mechanism by the time the wait ends.
  const all = moments(page, inputs(page, count), { signal, tell: (share) => tell(PAINTING * share) });
  const worker = new Worker(import.meta.resolve("assur/export/gif-worker.js"), { type: "module" });
  const stop = () => worker.terminate();
  signal.addEventListener("abort", stop);
  try {
    await answer(worker, signal, { width: canvas.width, height: canvas.height });
    let number = 0;
    for await (const here of all) {
      ground(target);
      moment(target, here);
      const { data } = target.context.getImageData(0, 0, canvas.width, canvas.height);
      await answer(worker, signal, { pixels: data.buffer, delay: delayOf(number, count, seconds) }, [data.buffer]);
      number += 1;
    }
    let file = null;
    let written = 0;
    do {
      ({ file } = await answer(worker, signal, { write: true }));
      written += 1;
      tell(PAINTING + (1 - PAINTING) * Math.min(written / count, 1));
    } while (!file);
    return new Blob([file], { type: "image/gif" });
  } finally {
    signal.removeEventListener("abort", stop);
    worker.terminate();
  }
}

/**
 * @param {number} number of the picture, from 0
 * @param {number} count of pictures
 * @param {number} seconds duration of all
 * @returns {number} time for which the picture is shown, in hundredths of a second, so that all together last as long as they should
 */
export function delayOf(number, count, seconds) {
  const [begin, end] = [number, number + 1].map((at) => Math.round((100 * seconds * at) / count));
  return Math.max(end - begin, MIN_DELAY);
}

/**
 * @param {Worker} worker
 * @param {AbortSignal} signal
 * @param {object} message
 * @param {Transferable[]} [transferred]
 * @returns {Promise<{ file: ArrayBuffer | null }>}
 */
function answer(worker, signal, message, transferred = []) {
  return new Promise((resolve, reject) => {
    const stop = () => reject(signal.reason);
    worker.onmessage = ({ data }) => {
      signal.removeEventListener("abort", stop);
      resolve(data);
    };
    worker.onerror = (event) => reject(new Error(event.message));
    signal.addEventListener("abort", stop);
    worker.postMessage(message, transferred);
  });
}
