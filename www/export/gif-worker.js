// A worker that writes a GIF by the library omggif. It receives the size, then all pictures, and then writes one picture per
// message. All pictures share one table of their most frequent colours. Only the changed part of a picture is written.
/*! The script contains omggif, https://github.com/deanm/omggif
(c) Dean McNamee <dean@gmail.com>, 2013.

Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation
files (the "Software"), to deal in the Software without restriction, including without limitation the rights to use, copy,
modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the Software
is furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES
OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS BE
LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR
IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE. */
import { GifWriter } from "omggif";

/** `COLOURS`: number of colours in the table. `SAME`: index of an unchanged pixel, after the last colour. */
const COLOURS = 255;
const SAME = 255;

/** Number of bins of colours, with five bits each for red, green and blue. */
const BINS = 1 << 15;

/** @type {{ width: number, height: number } | null} size of the pictures */
let sheet = null;
/** @type {Uint16Array[]} for each picture, the colour bins of its pixels */
const pictures = [];
/** @type {number[]} for each picture, the time for which it is shown, in hundredths of a second */
const delays = [];
const counts = new Float64Array(BINS);
/** Sums of red, green and blue over the pixels in each bin. */
const sums = new Float64Array(3 * BINS);
/** @type {{ gif: GifWriter, indices: Uint8Array } | null} writer of the file, and the index in the table for each bin */
let begun = null;
let written = 0;
/** @type {Uint8Array | null} the previous picture, as indices in the table */
let before = null;
/** @type {number[]} bytes of the file */
const file = [];

addEventListener("message", ({ data }) => {
  if (data.pixels) {
    take(new Uint8ClampedArray(data.pixels));
    delays.push(data.delay);
  } else if (data.write) writeNext();
  else sheet = data;
  if (begun && written === pictures.length) {
    begun.gif.end();
    const { buffer } = Uint8Array.from(file);
    postMessage({ file: buffer }, { transfer: [buffer] });
  } else postMessage({ file: null });
});

/** @param {Uint8ClampedArray} pixels red, green, blue and opacity of each pixel */
function take(pixels) {
  const bins = new Uint16Array(pixels.length / 4);
  for (let i = 0, at = 0; i < bins.length; i++, at += 4) {
    const bin = ((pixels[at] >> 3) << 10) | ((pixels[at + 1] >> 3) << 5) | (pixels[at + 2] >> 3);
    bins[i] = bin;
    counts[bin] += 1;
    for (let part = 0; part < 3; part++) sums[3 * bin + part] += pixels[at + part];
  }
  pictures.push(bins);
}

function writeNext() {
  if (!sheet || written === pictures.length) return;
  begun ??= begin(sheet);
  const { gif, indices } = begun;
  const { width, height } = sheet;
  const now = Uint8Array.from(pictures[written], (bin) => indices[bin]);
  const [left, top, right, bottom] = before ? changed(now, before, width, height) : [0, 0, width, height];
  const part = [];
  for (let y = top; y < bottom; y++) {
    for (let x = left; x < right; x++) {
      const i = y * width + x;
      part.push(before && before[i] === now[i] ? SAME : now[i]);
    }
  }
  // Disposal 1: the previous picture stays visible under the transparent pixels of the next.
  gif.addFrame(left, top, right - left, bottom - top, part, { delay: delays[written], disposal: 1, transparent: SAME });
  pictures[written] = new Uint16Array();
  before = now;
  written += 1;
}

/**
 * Begins the file, an animation that repeats endlessly, with the table of the most frequent colours.
 * @param {{ width: number, height: number }} size
 */
function begin({ width, height }) {
  const used = [...counts.keys()].filter((bin) => counts[bin] > 0).sort((a, b) => counts[b] - counts[a]);
  const colours = used.map((bin) => [0, 1, 2].map((part) => sums[3 * bin + part] / counts[bin]));
  const table = colours.slice(0, COLOURS);
  const indices = new Uint8Array(BINS);
  for (const [at, bin] of used.entries()) indices[bin] = at < COLOURS ? at : closest(colours[at], table);
  const palette = Array(COLOURS + 1).fill(0);
  for (const [at, colour] of table.entries()) palette[at] = colour.reduce((packed, part) => (packed << 8) | Math.round(part), 0);
  return { gif: new GifWriter(file, width, height, { loop: 0, palette }), indices };
}

/**
 * @param {readonly number[]} colour
 * @param {readonly (readonly number[])[]} table
 */
function closest(colour, table) {
  const distances = table.map((one) => one.reduce((sum, part, at) => sum + (part - colour[at]) ** 2, 0));
  return distances.indexOf(Math.min(...distances));
}

/**
 * @param {Uint8Array} now
 * @param {Uint8Array} then
 * @param {number} width
 * @param {number} height
 * @returns {[number, number, number, number]} left, top, right, bottom of the changed part, which has at least one pixel
 */
function changed(now, then, width, height) {
  let [left, top, right, bottom] = [width, height, 0, 0];
  for (let i = 0; i < now.length; i++) {
    if (now[i] === then[i]) continue;
    const [x, y] = [i % width, Math.floor(i / width)];
    left = Math.min(left, x);
    right = Math.max(right, x + 1);
    top = Math.min(top, y);
    bottom = y + 1;
  }
  return right === 0 ? [0, 0, 1, 1] : [left, top, right, bottom];
}
