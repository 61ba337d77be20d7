import assert from "node:assert/strict";
import { test } from "node:test";
import { note } from "./notes.js";

test("links lead from note to note", () => {
  const page = note("see [errata](errata.md), [code](../crates), [others](lessons.md)\n\n| a |\n|---|\n| b |\n");
  for (const part of ['href="errata.html"', 'href="../crates"', 'href="lessons.md"', "<td>b</td>"]) assert.ok(page.includes(part), page);
});
