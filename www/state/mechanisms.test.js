// Tests of the page of links to the test mechanisms: it lists all of them, and each link opens one.
import assert from "node:assert/strict";
import { test } from "node:test";
import { attempt } from "assur/core/problem.js";
import { fromAddress } from "assur/state/codec.js";
import { usualView } from "assur/state/state.js";
import { newEngine } from "assur/tests/engine.js";
import { UNMOVING, linked, mechanisms } from "../../crates/xtask/build/mechanisms.js";
import { note } from "../../crates/xtask/build/notes.js";
import { ROOT } from "../../crates/xtask/build/temporary.js";

const engine = newEngine();
const view = usualView({ lang: "en" });
const preset = (id) => {
  const found = engine.catalogue.preset(id);
  return found && { kind: found.kind, document: found.document, view };
};
/** Problems on opening an address, given the part after the #; none if it opens. */
const opened = (hash) => attempt(() => engine.set(engine.functions.readState(fromAddress(hash, preset)))).problems;
const parts = mechanisms(ROOT);

test("the page links to the whole catalogue and to every file", () => {
  const [catalogue, ...others] = parts.map(({ rows }) => rows.map(({ name }) => name).sort());
  assert.deepEqual(catalogue, engine.catalogue.presets.map(({ id }) => id).sort());
  const counts = others.map((rows) => rows.length);
  assert.ok(counts[1] >= 15 && counts[2] >= 26 && counts[3] >= 10 && counts[0] > 0, `${counts}`);
});

test("each link of the page opens a mechanism, through the address bar of a browser", () => {
  const page = note(linked(ROOT), "en");
  const hashes = [...page.matchAll(/href="\.\/#([^"]*)"/g)].map(([, hash]) => hash.replaceAll("&amp;", "&"));
  const rows = parts.flatMap(({ rows: part }) => part);
  assert.equal(hashes.length, rows.length);
  const refused = [];
  for (const [at, { name }] of rows.entries()) {
    const url = new URL("https://assur.test/");
    url.hash = hashes[at];
    const problems = opened(url.hash.slice(1));
    if (problems.length > 0) refused.push({ name, problems });
  }
  assert.deepEqual(refused, []);
});

test("what is linked as a draft does not move", () => {
  const rows = parts.flatMap(({ rows: part }) => part);
  for (const name of UNMOVING) {
    const row = rows.find((one) => one.name === name);
    const hash = row.hash.replace("%22draft%22", "%22linkage%22");
    assert.ok(hash !== row.hash && opened(hash).length > 0, name);
  }
});
