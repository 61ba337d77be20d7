// The duration in the header of a WebM file. Browsers omit it from recordings, and players then cannot seek.

/** Identifiers of elements of EBML (RFC 8794) and of Matroska. */
const SEGMENT = 0x18538067;
const INFO = 0x1549a966;
const TIMESTAMP_SCALE = 0x2ad7b1;
const DURATION = 0x4489;

/** Timestamp scale if the file gives none, in nanoseconds. */
const USUAL_SCALE = 1_000_000;

/** Length of a duration element: identifier, size, and a number of 8 bytes. */
const LENGTH = 11;

/**
 * @typedef {{ id: number, from: number, body: number, size: number | null }} Element `from`, `body`: where it and its content begin;
 * `size`: of its content, null if unknown
 */

/**
 * @param {Uint8Array<ArrayBuffer>} file
 * @param {number} milliseconds
 * @returns {Uint8Array<ArrayBuffer>} the file with this duration; the unchanged file if it lacks the form of a recording by a browser
 */
export function withDuration(file, milliseconds) {
  const segment = elements(file, 0, file.length).find(({ id }) => id === SEGMENT);
  // In a segment of known size, other elements may hold positions that would shift.
  if (!segment || segment.size !== null) return file;
  const info = elements(file, segment.body, file.length).find(({ id }) => id === INFO);
  if (!info || info.size === null) return file;
  const end = info.body + info.size;
  if (end > file.length) return file;
  const parts = elements(file, info.body, end);
  const scale = parts.find(({ id }) => id === TIMESTAMP_SCALE);
  const nanoseconds = scale?.size ? file.subarray(scale.body, scale.body + scale.size).reduce((value, byte) => 256 * value + byte, 0) : USUAL_SCALE;
  const kept = parts.filter(({ id }) => id !== DURATION).map(({ from, body, size }) => file.subarray(from, body + (size ?? 0)));
  const size = kept.reduce((sum, part) => sum + part.length, 0) + LENGTH;
  const head = new DataView(new ArrayBuffer(4 + 8 + LENGTH));
  head.setUint32(0, INFO);
  // The size is written in 8 bytes. The first byte marks this length.
  head.setBigUint64(4, (1n << 56n) | BigInt(size));
  head.setUint16(12, DURATION);
  head.setUint8(14, 0x88);
  head.setFloat64(15, (milliseconds * 1e6) / nanoseconds);
  return joined([file.subarray(0, info.from), new Uint8Array(head.buffer), ...kept, file.subarray(end)]);
}

/**
 * @param {Uint8Array} file
 * @param {number} from
 * @param {number} to
 * @returns {Element[]} the elements between `from` and `to`, up to the first one of unknown size
 */
function elements(file, from, to) {
  /** @type {Element[]} */
  const found = [];
  let at = from;
  while (at < to) {
    const id = number(file, at, false);
    const size = id && number(file, at + id.length, true);
    if (!id || !size) break;
    const body = at + id.length + size.length;
    found.push({ id: /** @type {number} */ (id.value), from: at, body, size: size.value });
    if (size.value === null) break;
    at = body + size.value;
  }
  return found;
}

/**
 * Reads a number of variable length. The leading zero bits of its first byte give the length.
 * @param {Uint8Array} file
 * @param {number} at
 * @param {boolean} bare whether the bit that marks the length is left out, as in sizes
 * @returns {{ value: number | null, length: number } | null} `value`: null if unknown; null beyond the end of the file
 */
function number(file, at, bare) {
  const length = Math.clz32(file[at] ?? 0) - 23;
  if (length > 8 || at + length > file.length) return null;
  const [first, ...rest] = file.subarray(at, at + length);
  const mark = 1 << (8 - length);
  const value = rest.reduce((sum, byte) => 256 * sum + byte, bare ? first - mark : first);
  const unknown = bare && first === 2 * mark - 1 && rest.every((byte) => byte === 255);
  return { value: unknown ? null : value, length };
}

/** @param {readonly Uint8Array[]} parts */
function joined(parts) {
  const whole = new Uint8Array(parts.reduce((sum, part) => sum + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}
