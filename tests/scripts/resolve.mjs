// Resolves `assur/…` as the import map of the page does: the engine is that of the built page, all other modules are the sources, or lists that the
// build makes of them.
import { fileURLToPath, pathToFileURL } from "node:url";
import { list } from "../../crates/xtask/build/files.js";
import { lists } from "../../crates/xtask/build/folders.js";

const ROOT = new URL("../../", import.meta.url);
const WWW = new URL("www/", ROOT);
const SITE = process.env.ASSUR_SITE ? pathToFileURL(`${process.env.ASSUR_SITE}/`) : new URL("target/site/", ROOT);

/** Folders of the page that are elsewhere than in `www`; `tests` is for tests alone. */
const ELSEWHERE = new Map([
  ["pkg", new URL("pkg/", SITE)],
  ["lang", new URL("lang/", ROOT)],
  ["tests", new URL("./", import.meta.url)],
]);

/** The texts of the modules that the build makes, by their addresses. */
const MADE = new Map([...lists(list(fileURLToPath(WWW)))].map(([name, text]) => [place(name.replace("assur/", "")).href, text]));

export async function resolve(specifier, context, next) {
  const [, name] = /^assur\/(.*)$/.exec(specifier) ?? [];
  const url = name === undefined ? (await next(specifier, context)).url : place(name).href;
  // No package.json says that scripts of a browser are modules.
  const ours = name !== undefined || url.startsWith(WWW.href);
  return ours ? { url, format: "module", shortCircuit: true } : next(specifier, context);
}

export async function load(url, context, next) {
  const source = MADE.get(url);
  return source === undefined ? next(url, context) : { format: "module", source, shortCircuit: true };
}

/** @param {string} name after `assur/` */
function place(name) {
  const [, folder, rest] = /^([^/]+)\/(.*)$/.exec(name) ?? [];
  const elsewhere = ELSEWHERE.get(folder);
  return elsewhere ? new URL(rest, elsewhere) : new URL(name, WWW);
}
