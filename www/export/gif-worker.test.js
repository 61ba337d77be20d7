// Tests of GIF files, which are decoded by the rules of the format.
import assert from "node:assert/strict";
import test, { afterEach } from "node:test";
import { Dice } from "assur/tests/random.js";
import { Worker, endWorkers } from "assur/tests/worker.js";

/** Time limit for the answers of a worker, in milliseconds. */
const PATIENCE = Object.freeze({ timeout: 60_000 });

afterEach(endWorkers);

/**
 * @param {number} width
 * @param {number} height
 * @param {number} delay
 * @param {readonly Uint8ClampedArray[]} pictures
 * @returns {Promise<{ file: Uint8Array, asked: number }>} the file, and the number of requests to write
 */
async function write(width, height, delay, pictures) {
  const worker = new Worker(import.meta.resolve("assur/export/gif-worker.js"));
  const ask = (message, transfer = []) => new Promise((done, fail) => {
    worker.onmessage = ({ data }) => done(data.file);
    worker.onerror = ({ message: why }) => fail(new Error(why));
    worker.postMessage(message, transfer);
  });
  assert.equal(await ask({ width, height }), null);
  for (const picture of pictures) {
    const { buffer } = picture.slice();
    assert.equal(await ask({ pixels: buffer, delay }, [buffer]), null);
  }
  let asked = 0;
  let file = null;
  while (!file) {
    asked += 1;
    file = await ask({ write: true });
  }
  return { file: new Uint8Array(file), asked };
}

/**
 * @param {Uint8Array} data packed by Lempel, Ziv and Welch
 * @param {number} least bits of a colour
 */
function unpacked(data, least) {
  const [clear, end] = [1 << least, (1 << least) + 1];
  let [table, size, buffer, bits, before] = [[], least + 1, 0, 0, null];
  const reset = () => {
    table = Array.from({ length: clear + 2 }, (_, i) => [i]);
    size = least + 1;
    before = null;
  };
  const out = [];
  reset();
  for (const byte of data) {
    buffer |= byte << bits;
    bits += 8;
    while (bits >= size) {
      const code = buffer & ((1 << size) - 1);
      buffer >>>= size;
      bits -= size;
      if (code === clear) reset();
      else if (code === end) return out;
      else {
        assert.ok(code < table.length || (code === table.length && before), `code ${code} of ${table.length}`);
        const entry = table[code] ?? [...before, before[0]];
        out.push(...entry);
        if (before && table.length < 4096) table.push([...before, entry[0]]);
        if (table.length === 1 << size && size < 12) size += 1;
        before = entry;
      }
    }
  }
  assert.fail("no end");
}

/** @param {Uint8Array} file */
function decoded(file) {
  const word = (at) => file[at] | (file[at + 1] << 8);
  assert.equal(String.fromCharCode(...file.subarray(0, 6)), "GIF89a");
  const [width, height] = [word(6), word(8)];
  // A table of 256 colours. The colour depth of the original, bits 4 to 6, is not given: readers do not use it.
  assert.equal(file[10], 0x87);
  const colours = Array.from({ length: 256 }, (_, i) => [...file.subarray(13 + 3 * i, 16 + 3 * i)]);
  let at = 13 + 768;
  const screen = new Uint8ClampedArray(4 * width * height);
  const frames = [];
  const delays = [];
  let [loops, through] = [null, -1];
  const blocks = () => {
    const parts = [];
    for (; file[at] > 0; at += file[at] + 1) parts.push(...file.subarray(at + 1, at + 1 + file[at]));
    at += 1;
    return parts;
  };
  for (;;) {
    const kind = file[at++];
    if (kind === 0x3b) break;
    if (kind === 0x21) {
      const label = file[at++];
      const data = blocks();
      if (label === 0xff) loops = data.at(-1) | data.at(-2);
      else {
        delays.push(data[1] | (data[2] << 8));
        through = data[0] & 1 ? data[3] : -1;
        // Disposal 1: the previous picture stays.
        assert.equal((data[0] >> 2) & 7, 1);
      }
      continue;
    }
    assert.equal(kind, 0x2c);
    const [left, top, wide, high] = [0, 2, 4, 6].map((off) => word(at + off));
    at += 9;
    const least = file[at++];
    const pixels = unpacked(blocks(), least);
    assert.equal(pixels.length, wide * high);
    for (const [i, colour] of pixels.entries()) {
      if (colour !== through) screen.set([...colours[colour], 255], 4 * ((top + Math.floor(i / wide)) * width + left + (i % wide)));
    }
    frames.push({ pixels: screen.slice(), area: wide * high });
  }
  assert.equal(at, file.length);
  return { width, height, frames, delays, loops };
}

/** A picture of one colour with a square of another. */
function square(width, height, ground, colour, left, top, side) {
  const pixels = new Uint8ClampedArray(4 * width * height);
  for (let i = 0; i < width * height; i++) {
    const [x, y] = [i % width, Math.floor(i / width)];
    const inside = x >= left && x < left + side && y >= top && y < top + side;
    pixels.set([...(inside ? colour : ground), 255], 4 * i);
  }
  return pixels;
}

test("pictures of few colours come back to the pixel, for ever and with their delay", PATIENCE, async () => {
  const pictures = [0, 3, 6, 9].map((left) => square(24, 16, [255, 255, 255], [0, 114, 178], left, 4, 5));
  const { file, asked } = await write(24, 16, 7, pictures);
  const { width, height, frames, delays, loops } = decoded(file);
  assert.deepEqual([width, height, asked, delays, loops], [24, 16, 4, [7, 7, 7, 7], 0]);
  for (const [i, { pixels }] of frames.entries()) assert.deepEqual(pixels, pictures[i]);
});

test("of a picture only what is another than before is written", PATIENCE, async () => {
  const pictures = [[0, 0], [1, 0], [1, 0]].map(([left, top]) => square(40, 30, [255, 255, 255], [213, 94, 0], left, top, 4));
  const { frames } = decoded((await write(40, 30, 2, pictures)).file);
  assert.deepEqual(frames.map(({ area }) => area), [1200, 5 * 4, 1]);
  assert.deepEqual(frames[2].pixels, pictures[2]);
});

test("a delay of more than a byte is written whole", PATIENCE, async () => {
  assert.deepEqual(decoded((await write(2, 2, 1000, [square(2, 2, [0, 0, 0], [0, 0, 0], 0, 0, 0)])).file).delays, [1000]);
});

test("pictures of noise, of any size, come back: the table of codes is begun anew when it is full", PATIENCE, async () => {
  const sizes = [[1, 1], [2, 100], [97, 89], [160, 120]];
  for (const [run, [width, height]] of sizes.entries()) {
    const dice = new Dice(run);
    // Fewer colours than the table holds, each in a bin of its own.
    const palette = Array.from({ length: 200 }, (_, i) => [(i % 32) * 8, Math.floor(i / 32) * 8, 40]);
    const pictures = [0, 1].map(() => {
      const pixels = new Uint8ClampedArray(4 * width * height);
      for (let i = 0; i < width * height; i++) pixels.set([...dice.one(palette), 255], 4 * i);
      return pixels;
    });
    const { frames } = decoded((await write(width, height, 4, pictures)).file);
    for (const [i, { pixels }] of frames.entries()) assert.deepEqual(pixels, pictures[i], `${width} × ${height}`);
  }
});

test("of more colours than a table has, the rare ones become the nearest", PATIENCE, async () => {
  const frequent = Array.from({ length: 255 }, (_, i) => [(i % 16) * 16, Math.floor(i / 16) * 16, 0]);
  // Each frequent colour has two pixels, each rare one a single pixel.
  const all = [...frequent, ...frequent, [16, 32, 16], [250, 15, 40]];
  const pixels = Uint8ClampedArray.from(all.flatMap((colour) => [...colour, 255]));
  const { frames: [{ pixels: found }] } = decoded((await write(all.length, 1, 4, [pixels])).file);
  const colour = (at) => [...found.subarray(4 * at, 4 * at + 3)];
  for (let at = 0; at < 510; at++) assert.deepEqual(colour(at), all[at]);
  assert.deepEqual([colour(510), colour(511)], [[16, 32, 0], [240, 16, 0]]);
});
