// The built page, as it is served: scripts bundled, style sheets joined, one table of words for each language, the
// engine in `pkg`.
import { readFileSync } from "node:fs";
import path from "node:path";
import { bundle as bundleStyles } from "lightningcss";
import { list } from "./files.js";
import { words } from "./folders.js";
import { MECHANISMS, linked } from "./mechanisms.js";
import { OF_LESSON, note, notes } from "./notes.js";
import { Page, fill } from "./page.js";
import { built } from "./papers.js";
import { bundle } from "./scripts.js";

const PAGE = "index.html";

/** Folder of the repository in which `cargo xtask` puts the engine and its types. */
export const ENGINE = "target/engine";

/** File name of the whole module of the engine. */
export const WHOLE = "assur_web_bg.wasm";

/** File names of the two parts of the engine's module: see `crates/xtask/src/parts`. */
const PARTS = Object.freeze(["first.wasm", "second.wasm"]);

/**
 * Sources that are not copied, because the build puts them into other files: scripts, parts of the first style sheet,
 * descriptions of lessons and kinds, words of kinds.
 */
const SOURCE = /\.js$|^styles\/|^lessons\/[^/]+\/lesson\.json$|^kinds\/[^/]+\/(kind|words\.\w+)\.json$/;

/** Items of papers. Their formulas are in LaTeX; the build converts them to MathML. */
const PAPER = /^lessons\/[^/]+\/paper\.json$/;

/**
 * @param {{ root: string, more?: string, version: string }} options `root`: the repository. `more`: a folder
 * with additional lessons and kinds
 * @returns {Promise<import("./files.js").Files>} the files of the site
 */
export async function site({ root, more, version }) {
  const sources = list(path.join(root, "www"));
  for (const name of ["assur_web.js", ...PARTS]) sources.set(`pkg/${name}`, path.join(root, ENGINE, name));
  if (more) for (const [name, file] of list(more)) sources.set(name, file);

  /** @type {import("./files.js").Files} */
  const files = new Map();
  const put = (/** @type {string} */ name, /** @type {string | Uint8Array} */ content) => files.set(name, Buffer.from(content));
  for (const [name, file] of list(path.join(root, "lang"))) {
    put(`lang/${name}`, JSON.stringify(words(sources, file, path.basename(name, ".json"))));
  }
  for (const [name, page] of notes(root, sources)) put(name, page);
  put(MECHANISMS, note(linked(root), "en"));
  for (const [name, script] of await bundle(sources)) put(name, script);
  for (const [name, file] of sources) {
    if (SOURCE.test(name) || OF_LESSON.test(name)) continue;
    if (PAPER.test(name)) put(name, built(readFileSync(file, "utf8")));
    else put(name, name.endsWith(".css") ? bundleStyles({ filename: file, minify: true }).code : readFileSync(file));
  }
  put(PAGE, new Page(filled(root, files, version), "site").text());
  return files;
}

/**
 * @param {string} root of the repository
 * @param {import("./files.js").Files} built files of the site, with the tables of words
 * @param {string} version
 * @returns {string} `index.html` with its words, and with the elements of all outputs
 */
export function filled(root, built, version) {
  const names = [...built.keys()].filter((name) => name.startsWith("lang/"));
  const tables = names.map((name) => /** @type {const} */ ([path.basename(name, ".json"), JSON.parse(String(built.get(name)))]));
  return fill(readFileSync(path.join(root, "www", PAGE), "utf8"), new Map(tables), version);
}
