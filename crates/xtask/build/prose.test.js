// Tests that the number of phrases that have to be read twice does not grow in any module.
import assert from "node:assert/strict";
import { readFileSync, readdirSync, writeFileSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { ROOT } from "./temporary.js";

/** Phrases that have to be read twice. A technical noun (offset, residual, bound, index) says the same in one reading. */
const PHRASES = /\b(told by|tells? (of|the|its|how|what)|is told|are told|so (many|much) of|hangs? on|by how much|has more than|no more than)\b/g;

const TABLE = path.join(ROOT, "tests/data/prose.json");

/** The modules of the engine; every other crate and the scripts of the page count as one each. */
const MODULE = /^(crates\/assur\/src\/[^/]+|crates\/[^/]+|www)/;

test("phrases that have to be read twice become fewer", () => {
  /** @type {Record<string, number>} */
  const counts = {};
  for (const file of ["crates", "www"].flatMap(sources)) {
    const found = readFileSync(path.join(ROOT, file), "utf8").match(PHRASES)?.length ?? 0;
    const [module] = MODULE.exec(file) ?? [];
    if (found > 0 && module) counts[module] = (counts[module] ?? 0) + found;
  }
  const allowed = /** @type {Record<string, number>} */ (JSON.parse(readFileSync(TABLE, "utf8")));
  for (const [module, count] of Object.entries(counts)) assert.ok(count <= (allowed[module] ?? 0), `${module}: ${count}, not more than ${allowed[module] ?? 0}`);
  const sorted = Object.fromEntries(Object.entries(counts).sort(([a], [b]) => (a < b ? -1 : 1)));
  if (process.env.ASSUR_WRITE) writeFileSync(TABLE, `${JSON.stringify(sorted, null, 2)}\n`);
  else assert.deepEqual(sorted, allowed, "fewer than noted: ASSUR_WRITE=1 notes it");
});

/**
 * @param {string} folder
 * @returns {string[]} paths of the source files in the folder and its subfolders, except this file
 */
function sources(folder) {
  return readdirSync(path.join(ROOT, folder), { withFileTypes: true }).flatMap((entry) => {
    const name = `${folder}/${entry.name}`;
    if (entry.isDirectory()) return ["target", "node_modules", "pkg"].includes(entry.name) ? [] : sources(name);
    return /\.(rs|js)$/.test(name) && !name.endsWith("/prose.test.js") ? [name] : [];
  });
}
