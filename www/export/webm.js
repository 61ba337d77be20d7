// An animation as WebM, as the browser records it: in as much time as it lasts.
import { inputs, moments, targetOn } from "assur/export/moments.js";

const KINDS = Object.freeze(["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"]);

/** Bits per second and pixel: lines stay sharp. */
const BITS = 8;

/**
 * @param {import("assur/app/page.js").Page} page
 * @param {import("assur/canvas/theme.js").Theme} theme
 * @param {import("assur/export/moments.js").Wishes} wishes
 * @param {import("assur/export/moments.js").Work} work
 * @returns {Promise<Blob>}
 */
export async function toWebm(page, theme, { moments: count, width, seconds }, work) {
  const { size, begin } = page.mechanism.sheet();
  const canvas = document.createElement("canvas");
  const target = targetOn(canvas, size, width);
  const { ground, moment } = begin(theme);
  ground(target);
  const stream = canvas.captureStream();
  const recorder = new MediaRecorder(stream, { mimeType: KINDS.find((kind) => MediaRecorder.isTypeSupported(kind)), videoBitsPerSecond: BITS * canvas.width * canvas.height });
  /** @type {Blob[]} */
  const parts = [];
  recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
  const ended = new Promise((resolve) => recorder.addEventListener("stop", resolve));
  const step = (1000 * seconds) / count;
  recorder.start();
  const start = performance.now();
  try {
    let number = 0;
    for await (const here of moments(page, inputs(page, count), work)) {
      ground(target);
      moment(target, here);
      number += 1;
      await until(start + number * step, work.signal);
    }
  } finally {
    recorder.stop();
    for (const track of stream.getTracks()) track.stop();
  }
  await ended;
  return new Blob(parts, { type: "video/webm" });
}

/**
 * @param {number} time of the page
 * @param {AbortSignal} signal
 */
async function until(time, signal) {
  await new Promise((resolve) => setTimeout(resolve, Math.max(time - performance.now(), 0)));
  signal.throwIfAborted();
}
