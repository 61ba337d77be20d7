// The page in one file, which opens by double-click: no server, no network. A page opened from a file may load no module and fetch no
// file beside it. But scripts name all that they load by bare names, so it is enough that the import map says `data:` addresses.
import { gzipSync } from "node:zlib";
import { dataAddress, text } from "./files.js";
import { Page } from "./page.js";

/** Not for a page from the disk: notes, which are documents of their own, what a host needs, the element for other pages, the second part of the engine. */
const OUTSIDE = /\.html$|^offline\/|^assur-mechanism\.js$|^pkg\/second\.wasm$/;

/** Name by which the page loads the first part of the engine. Here it is the whole engine. */
const FIRST = "pkg/first.wasm";

/** What is three times as small packed: the engine, and tables, most of them in four languages. */
const PACKED = /\.(wasm|json)$/;

/**
 * @param {import("./files.js").Files} built
 * @param {string} index the page
 * @param {Buffer} engine the whole module, instead of its two parts
 * @returns {string}
 */
export function single(built, index, engine) {
  const page = new Page(index, "file");
  /** @type {Record<string, string>} */
  const imports = {};
  page.putStylesInside((name) => text(built, name));
  for (const [name, content] of built) {
    if (OUTSIDE.test(name) || (name.endsWith(".css") && !name.includes("/"))) continue;
    imports[`assur/${name}`] = PACKED.test(name) ? packed(content) : dataAddress(name, content);
  }
  imports[`assur/${FIRST}`] = packed(engine);
  page.setImportMap(imports);
  return page.text();
}

/**
 * The page unpacks it by its media type.
 * @param {Buffer} content
 */
function packed(content) {
  return `data:application/gzip;base64,${gzipSync(content, { level: 9 }).toString("base64")}`;
}
