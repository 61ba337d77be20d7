// An animation as WebM, recorded by the browser in real time.
import { sheetOf } from "assur/export/beside.js";
import { inputs, moments, targetOn } from "assur/export/moments.js";
import { withDuration } from "assur/export/webm-duration.js";

const KINDS = Object.freeze(["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"]);

/** Bits per second and pixel, enough to keep lines sharp. */
const BITS = 8;

/**
 * @param {import("assur/app/page.js").Page} page
 * @param {import("assur/canvas/theme.js").Theme} theme
 * @param {import("assur/export/moments.js").Wishes} wishes
 * @param {import("assur/export/moments.js").Job} work
 * @returns {Promise<Blob>}
 */
export async function toWebm(page, theme, wishes, work) {
  const { moments: count, width, seconds } = wishes;
  const { size, begin } = sheetOf(page, wishes);
  const canvas = document.createElement("canvas");
  const target = targetOn(canvas, size, width);
  const { ground, moment } = begin(theme);
  const step = (1000 * seconds) / count;
  /** @type {ReturnType<typeof record> | null} */
  let recording = null;
  try {
    let number = 0;
    for await (const here of moments(page, inputs(page, count), work)) {
      ground(target);
      moment(target, here);
      // The recording begins only once the canvas shows the first picture.
      recording ??= record(canvas);
      number += 1;
      await until(recording.start + number * step, work.signal);
    }
  } finally {
    recording?.stop();
  }
  const file = new Blob(await recording?.parts);
  const bytes = new Uint8Array(await file.arrayBuffer());
  return new Blob([withDuration(bytes, recording?.lasts() ?? 0)], { type: "video/webm" });
}

/**
 * Starts to record a canvas.
 * @param {HTMLCanvasElement} canvas
 */
function record(canvas) {
  const stream = canvas.captureStream();
  const recorder = new MediaRecorder(stream, { mimeType: KINDS.find((kind) => MediaRecorder.isTypeSupported(kind)), videoBitsPerSecond: BITS * canvas.width * canvas.height });
  /** @type {Blob[]} */
  const recorded = [];
  recorder.addEventListener("dataavailable", ({ data }) => recorded.push(data));
  /** @type {Promise<Blob[]>} all recorded parts, once the recording is stopped */
  const parts = new Promise((resolve) => recorder.addEventListener("stop", () => resolve(recorded)));
  recorder.start();
  const start = performance.now();
  let end = start;
  const stop = () => {
    end = performance.now();
    recorder.stop();
    for (const track of stream.getTracks()) track.stop();
  };
  return { start, parts, stop, lasts: () => end - start };
}

/**
 * @param {number} time moment to wait for, on the clock of `performance.now`
 * @param {AbortSignal} signal
 */
async function until(time, signal) {
  await new Promise((resolve) => setTimeout(resolve, Math.max(time - performance.now(), 0)));
  signal.throwIfAborted();
}
