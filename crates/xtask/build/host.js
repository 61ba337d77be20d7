// The page as a folder for any host of static files. Most files are named by the hash of their content, so that
// browsers may keep them for ever. Only `index.html` and the service worker contain these names. The service worker
// stores the page for use without a network. A Content-Security-Policy allows only the page's own scripts. All
// addresses in the page are relative, so that the folder works below any path.
import { hash } from "node:crypto";
import path from "node:path";
import { promisify } from "node:util";
import { brotliCompress, constants, gzip } from "node:zlib";
import { text } from "./files.js";
import { FOLDER as NOTES } from "./notes.js";
import { Page, inline } from "./page.js";

/** Script of the element for other pages. It keeps its name, because those pages load it by name. */
export const ELEMENT = "assur-mechanism.js";

/** Service worker. It is in the same folder as the page, because it controls only pages in its own folder and below. */
const WORKER = "service-worker.js";

/** Folder of the files that are named by hash and so never change. One rule of the headers covers them all. */
const FIXED = "files/";

/** File of the HTTP headers, in the format that several hosts read. */
const HEADERS = "_headers";

/** Files not named by hash: they keep their names, are written anew below or, like `mechanisms.html`, are left out. */
const NAMED = new RegExp(`\\.html$|^offline/|^${ELEMENT}$`);

/**
 * @param {import("./files.js").Files} built
 * @param {string} index the page
 * @returns {Map<string, string | Buffer>}
 */
export function hosted(built, index) {
  /** @type {Map<string, string | Buffer>} */
  const files = new Map();
  /** @type {Map<string, string>} */
  const addresses = new Map();
  for (const [name, content] of built) {
    if (name.startsWith(`${NOTES}/`) || name === ELEMENT) files.set(name, content);
    if (NAMED.test(name)) continue;
    const fixed = `${FIXED}${hash("sha256", content).slice(0, 8)}${path.extname(name)}`;
    const other = files.get(fixed);
    if (other && !content.equals(Buffer.from(other))) throw new Error(`${name} has the hash of another file: change any of its bytes`);
    files.set(fixed, content);
    addresses.set(name, fixed);
  }

  const page = new Page(index, "host");
  page.setImportMap(Object.fromEntries([...addresses].map(([name, fixed]) => [`assur/${name}`, `./${fixed}`])));
  page.setLinks((name) => {
    const fixed = addresses.get(name);
    if (!fixed) throw new Error(`index.html links to ${name}, which the site does not hold`);
    return fixed;
  });
  const worker = text(built, `offline/${WORKER}`);
  const names = [...files.keys()].sort();
  const contents = [page.text(), worker, ...names.flatMap((name) => [name, files.get(name) ?? ""])].map((content) => Buffer.from(content));
  const build = hash("sha256", Buffer.concat(contents)).slice(0, 20);
  const pages = [page.text(), ...names.filter((name) => name.endsWith(".html")).map((name) => String(files.get(name)))];
  const policy = contentSecurityPolicy(pages);
  page.setMeta('http-equiv="Content-Security-Policy"', policy);
  page.setMeta('name="build"', build);

  files.set("index.html", page.text());
  files.set(WORKER, `self.version=${JSON.stringify([build, "./", ...names].join(" "))};${worker}`);
  files.set(HEADERS, headers(policy));
  return files;
}

const LEVEL = Object.freeze({ params: { [constants.BROTLI_PARAM_QUALITY]: constants.BROTLI_MAX_QUALITY } });

/** Methods of compression, by the ending of the compressed file. */
const PACKERS = Object.freeze({
  br: (/** @type {string | Buffer} */ content) => promisify(brotliCompress)(content, LEVEL),
  gz: (/** @type {string | Buffer} */ content) => promisify(gzip)(content, { level: constants.Z_BEST_COMPRESSION }),
});

/**
 * Adds a compressed copy of each file, if it is smaller, for hosts that send such copies. Compressing the engine takes
 * seconds, so copies of files named by hash are taken from an earlier build if it has them.
 * @param {ReadonlyMap<string, string | Buffer>} files
 * @param {ReadonlyMap<string, Buffer>} earlier
 * @returns {Promise<Map<string, string | Buffer>>}
 */
export async function packed(files, earlier) {
  const all = new Map(files);
  const packing = [...files].filter(([name]) => name !== HEADERS).flatMap(([name, content]) =>
    Object.entries(PACKERS).map(async ([ending, pack]) => {
      const place = `${name}.${ending}`;
      const small = (name.startsWith(FIXED) && earlier.get(place)) || (await pack(content));
      if (small.length < Buffer.byteLength(content)) all.set(place, small);
    }),
  );
  await Promise.all(packing);
  return all;
}

/**
 * Makes the Content-Security-Policy. It allows the page's files, and inline scripts and style sheets by their hashes.
 * @param {readonly string[]} pages
 */
function contentSecurityPolicy(pages) {
  const sources = (/** @type {"script" | "style"} */ element) => {
    const hashes = pages.flatMap((page) => inline(page, element)).map((content) => ` 'sha256-${hash("sha256", content, "base64")}'`);
    return [...new Set(hashes)].sort().join("");
  };
  return (
    "default-src 'none'; base-uri 'none'; form-action 'none'; connect-src 'self'; img-src 'self' data:; " +
    `script-src 'self' 'wasm-unsafe-eval'${sources("script")}; style-src 'self'${sources("style")}; worker-src 'self'`
  );
}

/**
 * Makes the content of `_headers`. The headers do not restrict framing, because the page is meant to be embedded.
 * @param {string} policy
 */
function headers(policy) {
  return `/*
  Content-Security-Policy: ${policy}
  X-Content-Type-Options: nosniff
  Referrer-Policy: no-referrer
  Cache-Control: no-cache
/${FIXED}*
  ! Cache-Control
  Cache-Control: public, max-age=31536000, immutable
`;
}
