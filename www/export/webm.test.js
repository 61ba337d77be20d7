// Tests of the pictures that the browser records for an animation.
import assert from "node:assert/strict";
import test from "node:test";
import { toWebm } from "assur/export/webm.js";
import { Page } from "assur/tests/page.js";

/** Stand-in for a canvas. `shown`: its content. `captured`: its content when the recording begins, and after each change. */
const canvas = {
  shown: [], captured: null,
  getContext: () => ({ setTransform() {} }),
  captureStream() {
    this.captured = [this.shown];
    return { getTracks: () => [] };
  },
};
globalThis.document = { createElement: () => canvas };
globalThis.MediaRecorder = class MediaRecorder extends EventTarget {
  static isTypeSupported = () => true;
  start() {}
  stop() {
    this.dispatchEvent(Object.assign(new Event("dataavailable"), { data: "film" }));
    this.dispatchEvent(new Event("stop"));
  }
};

/** Page whose drawing writes the painted inputs into the canvas. */
function begin() {
  const page = new Page("crank-rocker", { phi_deg: 30 });
  const show = (shown) => {
    canvas.shown = shown;
    canvas.captured?.push(shown);
  };
  page.now();
  page.mechanism.sheet = () => ({
    size: { width: 100, height: 50 },
    // Ground and moment are painted before the browser captures the canvas.
    begin: () => ({ ground: () => (canvas.shown = ["ground"]), moment: (_, { frameInput }) => show([...canvas.shown, frameInput]) }),
  });
  canvas.captured = null;
  return page;
}

test("a film has a picture of each moment, and no other", async () => {
  const page = begin();
  const film = await toWebm(page, null, { moments: 12, width: 320, seconds: 0.01 }, { signal: new AbortController().signal, tell() {} });
  assert.equal(await film.text(), "film");
  assert.equal(canvas.captured.length, 12);
  assert.ok(canvas.captured.every((shown) => shown.length === 2), JSON.stringify(canvas.captured));
});

test("a film that is given up before its first picture records nothing", async () => {
  const page = begin();
  await assert.rejects(toWebm(page, null, { moments: 12, width: 320, seconds: 0.01 }, { signal: AbortSignal.abort(), tell() {} }), { name: "AbortError" });
  assert.equal(canvas.captured, null);
});
