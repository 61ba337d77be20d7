// Folders as maps from paths to files, from which the outputs of the build are assembled. Paths in a folder have
// forward slashes on every system.
import { mkdirSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from "node:fs";
import path from "node:path";
import { lookup } from "mrmime";

/** @typedef {Map<string, Buffer>} Files contents of files by their paths in one folder */

/**
 * @param {string} folder
 * @returns {Map<string, string>} locations of the files by their paths in the folder, without hidden files and tests
 */
export function list(folder) {
  const entries = readdirSync(folder, { recursive: true, withFileTypes: true }).filter((entry) => entry.isFile());
  const places = entries.map((entry) => path.join(entry.parentPath, entry.name));
  const named = places.map((place) => /** @type {const} */ ([path.relative(folder, place).replaceAll(path.sep, "/"), place]));
  return new Map(named.filter(([name]) => !/(^|\/)\.|\.test\.js$/.test(name)).sort(([one], [other]) => (one < other ? -1 : 1)));
}

/**
 * @param {string} folder
 * @returns {Files}
 */
export function read(folder) {
  return new Map([...list(folder)].map(([name, place]) => [name, readFileSync(place)]));
}

/**
 * @param {Files} files
 * @param {string} name
 * @returns {Buffer}
 */
export function bytes(files, name) {
  const content = files.get(name);
  if (!content) throw new Error(`there is no ${name}`);
  return content;
}

/**
 * @param {Files} files
 * @param {string} name
 * @returns {string}
 */
export function text(files, name) {
  return bytes(files, name).toString();
}

/**
 * @param {string} folder
 * @param {ReadonlyMap<string, string | Uint8Array>} files
 */
export function write(folder, files) {
  for (const [name, content] of files) {
    const place = path.join(folder, name);
    mkdirSync(path.dirname(place), { recursive: true });
    writeFileSync(place, content);
  }
}

/**
 * Replaces a folder by a new one. The old folder stays until all files of the new one are written.
 * @param {string} folder
 * @param {ReadonlyMap<string, string | Uint8Array>} files
 */
export function replace(folder, files) {
  const fresh = `${folder}.new`;
  rmSync(fresh, { recursive: true, force: true });
  write(fresh, files);
  rmSync(folder, { recursive: true, force: true });
  renameSync(fresh, folder);
}

/**
 * @param {string} name
 * @param {Buffer} content
 * @returns {string} a `data:` address that holds the file
 */
export function dataAddress(name, content) {
  const type = lookup(name);
  if (!type) throw new Error(`no media type is known for ${name}`);
  return `data:${type}${type.startsWith("text/") ? ";charset=utf-8" : ""};base64,${content.toString("base64")}`;
}
