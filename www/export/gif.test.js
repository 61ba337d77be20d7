// Tests of the delays of the pictures of an animation.
import assert from "node:assert/strict";
import test from "node:test";
import { delayOf } from "assur/export/gif.js";

test("an animation lasts as long as it should, whatever the number of its pictures", () => {
  for (const seconds of [2, 3, 4, 6, 12]) {
    for (const count of [12, 24, 36, 48, 72]) {
      const delays = Array.from({ length: count }, (_, number) => delayOf(number, count, seconds));
      assert.equal(delays.reduce((sum, delay) => sum + delay), 100 * seconds, `${count} in ${seconds} s`);
      assert.ok(Math.max(...delays) - Math.min(...delays) <= 1);
    }
  }
});
