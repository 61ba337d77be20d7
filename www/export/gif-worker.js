// A worker that writes a GIF (version 89a). It receives the size, then all pictures, and then writes one picture per
// message. All pictures share one table of their most frequent colours. Only the changed part of a picture is written.

/** `COLOURS`: number of colours in the table. `SAME`: index of an unchanged pixel, after the last colour. */
const COLOURS = 255;
const SAME = 255;

/** Number of bins of colours, with five bits each for red, green and blue. */
const BINS = 1 << 15;

/** @type {{ width: number, height: number, delay: number } | null} size of the pictures, and delay between them in hundredths of a second */
let sheet = null;
/** @type {Uint16Array[]} for each picture, the colour bins of its pixels */
const pictures = [];
const counts = new Float64Array(BINS);
/** Sums of red, green and blue over the pixels in each bin. */
const sums = new Float64Array(3 * BINS);
/** @type {Uint8Array | null} index in the table for each bin */
let indices = null;
let written = 0;
/** @type {Uint8Array | null} the previous picture, as indices in the table */
let before = null;
/** @type {(number | Uint8Array)[]} single bytes and lists of bytes */
const file = [];

addEventListener("message", ({ data }) => {
  if (data.pixels) take(new Uint8ClampedArray(data.pixels));
  else if (data.write) writeNext();
  else sheet = data;
  const whole = written > 0 && written === pictures.length;
  const bytes = whole ? ended() : null;
  if (bytes) postMessage({ file: bytes }, { transfer: [bytes] });
  else postMessage({ file: null });
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
  indices ??= begun(sheet);
  const { width, height, delay } = sheet;
  const picture = pictures[written].map((bin) => /** @type {Uint8Array} */ (indices)[bin]);
  const now = Uint8Array.from(picture);
  const [left, top, right, bottom] = before ? changed(now, before, width, height) : [0, 0, width, height];
  const part = new Uint8Array((right - left) * (bottom - top));
  for (let y = top, at = 0; y < bottom; y++) {
    for (let x = left; x < right; x++, at++) {
      const i = y * width + x;
      part[at] = before && before[i] === now[i] ? SAME : now[i];
    }
  }
  // The previous picture stays visible under the transparent pixels of the next.
  file.push(0x21, 0xf9, 4, (1 << 2) | 1, ...short(delay), SAME, 0);
  file.push(0x2c, ...short(left), ...short(top), ...short(right - left), ...short(bottom - top), 0);
  pack(part);
  pictures[written] = new Uint16Array();
  before = now;
  written += 1;
}

/**
 * Writes the head of the file and the table of the most frequent colours.
 * @param {{ width: number, height: number }} size
 * @returns {Uint8Array} index in the table for each bin
 */
function begun({ width, height }) {
  const used = [...counts.keys()].filter((bin) => counts[bin] > 0).sort((a, b) => counts[b] - counts[a]);
  const colours = used.map((bin) => [0, 1, 2].map((part) => sums[3 * bin + part] / counts[bin]));
  const table = colours.slice(0, COLOURS);
  const nearest = new Uint8Array(BINS);
  for (const [at, bin] of used.entries()) nearest[bin] = at < COLOURS ? at : closest(colours[at], table);
  file.push(...[..."GIF89a"].map((letter) => letter.charCodeAt(0)), ...short(width), ...short(height), 0xf7, 0, 0);
  const bytes = new Uint8Array(3 * 256);
  bytes.set(table.flat().map(Math.round));
  file.push(bytes);
  // The Netscape extension makes the animation repeat endlessly.
  file.push(0x21, 0xff, 11, ...[..."NETSCAPE2.0"].map((letter) => letter.charCodeAt(0)), 3, 1, 0, 0, 0);
  return nearest;
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

/**
 * Compresses the indices of a picture by the Lempel–Ziv–Welch (LZW) method of GIF, in blocks of at most 255 bytes.
 * @param {Uint8Array} pixels
 */
function pack(pixels) {
  const [clear, end, most, slots] = [256, 257, 4096, 1 << 13];
  const keys = new Int32Array(slots).fill(-1);
  const codes = new Uint16Array(slots);
  let [size, next, buffer, bits] = [9, 258, 0, 0];
  /** @type {number[]} */
  let block = [];
  const flush = () => {
    if (block.length > 0) file.push(block.length, Uint8Array.from(block));
    block = [];
  };
  const put = (/** @type {number} */ code) => {
    buffer |= code << bits;
    bits += size;
    for (; bits >= 8; bits -= 8, buffer >>>= 8) {
      block.push(buffer & 0xff);
      if (block.length === 255) flush();
    }
  };
  const longer = () => {
    if (next === 1 << size && size < 12) size += 1;
  };
  file.push(8);
  put(clear);
  let prefix = pixels[0];
  for (let i = 1; i < pixels.length; i++) {
    const key = (prefix << 8) | pixels[i];
    let slot = Math.imul(key, 0x9e3779b1) >>> 19;
    while (keys[slot] !== -1 && keys[slot] !== key) slot = (slot + 1) % slots;
    if (keys[slot] === key) {
      prefix = codes[slot];
      continue;
    }
    put(prefix);
    if (next < most) {
      longer();
      keys[slot] = key;
      codes[slot] = next;
      next += 1;
    } else {
      put(clear);
      keys.fill(-1);
      [size, next] = [9, 258];
    }
    prefix = pixels[i];
  }
  put(prefix);
  longer();
  put(end);
  if (bits > 0) block.push(buffer & 0xff);
  flush();
  file.push(0);
}

/** @returns {ArrayBuffer} the whole file */
function ended() {
  file.push(0x3b);
  const bytes = new Uint8Array(file.reduce((/** @type {number} */ length, one) => length + (typeof one === "number" ? 1 : one.length), 0));
  let at = 0;
  for (const one of file) {
    if (typeof one === "number") bytes[at++] = one;
    else {
      bytes.set(one, at);
      at += one.length;
    }
  }
  return bytes.buffer;
}

/** @param {number} value */
function short(value) {
  return [value & 0xff, value >> 8];
}
