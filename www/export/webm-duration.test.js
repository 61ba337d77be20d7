import assert from "node:assert/strict";
import test from "node:test";
import { withDuration } from "assur/export/webm-duration.js";

const UNKNOWN = [0x01, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff];
const HEADER = [0x1a, 0x45, 0xdf, 0xa3, 0x84, 0x42, 0x86, 0x81, 0x01];
const SCALE = [0x2a, 0xd7, 0xb1, 0x83, 0x0f, 0x42, 0x40];
const CLUSTER = [0x1f, 0x43, 0xb6, 0x75, ...UNKNOWN, 0xe7, 0x81, 0x00];

/** A file as browsers record it. */
const recorded = (info, size = UNKNOWN) => Uint8Array.from([...HEADER, 0x18, 0x53, 0x80, 0x67, ...size, 0x15, 0x49, 0xa9, 0x66, 0x80 | info.length, ...info, ...CLUSTER]);

const duration = (file) => {
  const at = file.findIndex((byte, i) => byte === 0x44 && file[i + 1] === 0x89 && file[i + 2] === 0x88);
  return at < 0 ? null : new DataView(file.buffer).getFloat64(at + 3);
};

test("the header gets the duration, and nothing else is changed", () => {
  const file = recorded(SCALE);
  const whole = withDuration(file, 4000);
  assert.equal(duration(whole), 4000);
  const info = [0x15, 0x49, 0xa9, 0x66, 0x01, 0, 0, 0, 0, 0, 0, SCALE.length + 11];
  assert.deepEqual([...whole.subarray(21, 33)], info);
  assert.deepEqual([...whole.subarray(0, 21)], [...file.subarray(0, 21)]);
  assert.deepEqual([...whole.subarray(33 + 11)], [...SCALE, ...CLUSTER]);
});

test("a duration is counted in the scale of the file, and replaces another", () => {
  const tens = [0x2a, 0xd7, 0xb1, 0x84, 0x00, 0x98, 0x96, 0x80];
  assert.equal(duration(withDuration(recorded(tens), 4000)), 400);
  const twice = withDuration(withDuration(recorded(SCALE), 1), 4000);
  assert.equal(duration(twice), 4000);
  assert.equal(twice.length, recorded(SCALE).length + 11 + 7);
});

test("what is not recorded so stays as it is", () => {
  const known = recorded(SCALE, [0x01, 0, 0, 0, 0, 0, 0, 0x30]);
  for (const file of [known, new Uint8Array(), Uint8Array.from([0]), new TextEncoder().encode("film"), recorded(SCALE).subarray(0, 30)]) assert.equal(withDuration(file, 1), file);
});
