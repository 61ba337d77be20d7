// The page in one file, which opens by double-click, without server or network. A page opened from a file may not load
// modules or fetch files beside it. Scripts load everything by bare names, so the import map can use `data:` addresses.
import { gzipSync } from "node:zlib";
import { dataAddress, text } from "./files.js";
import { Page } from "./page.js";

/** Files that are left out: HTML pages, files for a host, the element for other pages, the engine's second part. */
const OUTSIDE = /\.html$|^offline\/|^assur-mechanism\.js$|^pkg\/second\.wasm$/;

/** Name by which the page loads the first part of the engine. Here it is the whole engine. */
const FIRST = "pkg/first.wasm";

/** Files that are compressed, to about a third of their size: the engine and tables. */
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
 * Makes a `data:` address of a compressed file. The page decompresses files of this media type.
 * @param {Buffer} content
 */
function packed(content) {
  return `data:application/gzip;base64,${gzipSync(content, { level: 9 }).toString("base64")}`;
}
