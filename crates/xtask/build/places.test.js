// Tests that every module, function and file that a document names exists in the code.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { ROOT } from "./temporary.js";

const DOCUMENTS = ["ARCHITECTURE.md", "CONTRIBUTING.md", "docs/glossary.md", "docs/decisions.md"];

/** A path of modules of the engine, with or without a type or function at its end. */
const MODULES = /^[a-z_]\w*(::\w+)+$/;

/** Names that begin a path outside the engine. */
const OTHERS = new Set(["assur_file", "assur_draw", "assur_edit", "assur_import", "assur_web", "assur_tests", "crate", "std", "nalgebra"]);


for (const document of DOCUMENTS) {
  test(`places in the code that ${document} names`, () => {
    const names = [...readFileSync(path.join(ROOT, document), "utf8").matchAll(/`([^`\n]+)`/g)].map(([, name]) => name.replace(/\(.*$/, ""));
    const lost = names.filter((name) => (MODULES.test(name) ? !isIn(name.split("::")) : /^[\w/]+\.rs$/.test(name) && !isFile(name)));
    assert.deepEqual(lost, []);
  });
}

/** All Rust sources and tests, by their paths. */
const FILES = ["crates", "tests"].flatMap((folder) => readdirSync(path.join(ROOT, folder), { recursive: true, encoding: "utf8" }).map((file) => `/${folder}/${file}`));

/** @param {string} name */
function isFile(name) {
  return FILES.some((file) => file.endsWith(`/${name}`));
}

/**
 * @param {readonly string[]} parts of a path
 * @returns {boolean} whether the engine has these modules, and the last part in them
 */
function isIn(parts) {
  if (OTHERS.has(parts[0])) return true;
  const modules = parts[0] === "assur" ? parts.slice(1) : parts;
  const last = modules.at(-1) ?? "";
  if (/^[A-Z]/.test(modules[0])) return true;
  const place = modules.join("/");
  if (isFile(`assur/src/${place}.rs`) || isFile(`assur/src/${place}/mod.rs`)) return true;
  const type = modules.findIndex((part) => /^[A-Z]/.test(part));
  const [owner, name, member] = type < 0 ? [modules.slice(0, -1), last, ""] : [modules.slice(0, type), modules[type], modules[type + 1] ?? ""];
  const folder = `/crates/assur/src/${owner.join("/")}`;
  const owners = FILES.filter((file) => file === `${folder}.rs` || (file.startsWith(`${folder}/`) && file.endsWith(".rs")));
  const defined = new RegExp(`\\b(struct|enum|union|trait|fn|type|const|static) ${name}\\b|\\bpub use [^;]*\\b${name}\\b`);
  const belongs = new RegExp(`^    .*\\b${member}\\b\\s*[:({,<]`, "m");
  const texts = owners.map((file) => readFileSync(path.join(ROOT, file), "utf8"));
  return texts.some((text) => defined.test(text)) && (member === "" || texts.some((text) => belongs.test(text)));
}
