// Program that builds the page, run by `cargo xtask`. `site` writes the page to be served. `dist` writes the page in
// one file, the folder for a host and the npm package.
import { existsSync, readFileSync } from "node:fs";
import path from "node:path";
import { parseArgs } from "node:util";
import { bytes, read, replace, write } from "./files.js";
import { ELEMENT, hosted, packed } from "./host.js";
import { pack } from "./package.js";
import { single } from "./single.js";
import { ENGINE, WHOLE, filled, site } from "./site.js";

const string = Object.freeze({ type: /** @type {const} */ ("string"), default: "" });
const { positionals, values } = parseArgs({ allowPositionals: true, options: { root: string, target: string, version: string } });
const { root, target, version } = values;
const [what, more] = positionals;
const folder = path.join(target, more ? "site.more" : "site");

/** Writes the page. A page with additional lessons and kinds goes to a separate folder. */
async function writeSite() {
  replace(folder, await site({ root, more, version }));
  console.log(`==> page: built in ${folder}`);
}

/** Writes the page in one file, the element for other pages, the folder for a host, and the npm package. */
async function writeDist() {
  const to = path.join(root, "dist");
  const built = read(folder);
  const index = filled(root, built, version);
  const file = single(built, index, readFileSync(path.join(root, ENGINE, WHOLE)));
  write(to, new Map([["assur.html", Buffer.from(file)], [ELEMENT, bytes(built, ELEMENT)]]));
  const files = hosted(built, index);
  const place = path.join(to, "site");
  replace(place, await packed(files, existsSync(place) ? read(place) : new Map()));
  pack({ root, site: folder, staging: path.join(target, "npm"), to: path.join(to, "npm"), version });
  console.log(`==> one-file page: ${path.join(to, "assur.html")}, ${Buffer.byteLength(file)} bytes`);
  console.log(`==> folder for a host: ${place}, ${files.size} files`);
  console.log(`==> package for npm: ${path.join(to, "npm")}`);
}

try {
  await (what === "dist" ? writeDist() : writeSite());
} catch (error) {
  console.error(`error: ${error instanceof Error ? error.message : error}`);
  process.exitCode = 1;
}
