import assert from "node:assert/strict";
import { test } from "node:test";
import { note } from "./notes.js";

test("links lead from note to note", () => {
  const page = note("see [errata](errata.md), [code](../crates), [others](lessons.md), [from a lesson](../../../docs/errata.md)\n\n| a |\n|---|\n| b |\n", "kk");
  assert.equal(page.match(/href="errata.html"/g)?.length, 2);
  for (const part of ['<html lang="kk">', 'href="../crates"', 'href="lessons.md"', "<td>b</td>"]) assert.ok(page.includes(part), page);
});
