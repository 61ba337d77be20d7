// Tests of the drawing with the plots beside it.
import assert from "node:assert/strict";
import test from "node:test";
import { Context, themeOf } from "assur/tests/canvas.js";
import { sheetOf } from "assur/export/beside.js";
import { inputs, moments } from "assur/export/moments.js";
import { Page } from "assur/tests/page.js";

test("plots stand to the right of the drawing, with the cursor where the mechanism is", async () => {
  const page = new Page("crank-rocker", { phi_deg: 30 });
  page.now();
  const painted = [];
  const size = { width: 300, height: 200 };
  page.mechanism.sheet = (_, tall = 0) => ({
    size: { width: 300, height: Math.max(200, tall) },
    begin: () => ({ ground: () => painted.push("ground"), moment: () => painted.push("moment") }),
  });
  page.chart = { size: { width: 400, height: 500 }, paintAt: (_, __, { frameInput, plotted }) => painted.push([frameInput, plotted.length]) };
  assert.deepEqual(sheetOf(page, {}).size, size);
  const sheet = sheetOf(page, { plots: true });
  assert.deepEqual(sheet.size, { width: 700, height: 500 });
  const theme = themeOf(page.engine.roles);
  const { ground, moment } = sheet.begin(theme);
  const target = { context: new Context(), ratio: 1 };
  const wanted = inputs(page, 4);
  ground(target);
  for await (const here of moments(page, wanted, { signal: new AbortController().signal, tell() {} })) moment(target, here);
  const series = page.now().plotted.length;
  assert.ok(series > 0);
  assert.deepEqual(painted, ["ground", ...wanted.flatMap((input) => ["moment", [input, series]])]);
});
