// The page `mechanisms.html`, with links that open the mechanisms of the tests in the page `index.html` beside it.
import { readFileSync, readdirSync } from "node:fs";
import path from "node:path";
import { list } from "./files.js";

/** File name of the page in the site. */
export const MECHANISMS = "mechanisms.html";

/** Mechanisms of the catalogue that have no file, because the engine makes them. */
const MIXERS = Object.freeze(["mixer-a", "mixer-b", "mixer-c"]);

/** Files of drawings that do not move. They would be refused as linkages, so they are opened as drafts. */
export const UNMOVING = Object.freeze(["lengths-alone", "undirected-line", "undirected-link", "nan-angle", "nan-line"].map((name) => `${name}.json`));

/** Fields of the view that every address must have. */
const VIEW = Object.freeze({ phi_deg: 0, playing: false, direction: 1, speed: 1, traces: true, lang: "en" });

/** @typedef {{ format?: number, kind?: string, lesson?: unknown, document: object, view?: object }} Whole */
/** @typedef {Whole & { from?: string }} Preset of a lesson; with `from`, only its differences from that preset */

/**
 * @param {Whole} state
 * @returns {string} part of the state's address after the #, with every value as JSON
 */
function address({ format = 2, kind, lesson, document, view }) {
  const encoded = (/** @type {unknown} */ value) => encodeURIComponent(JSON.stringify(value));
  const pairs = (/** @type {string} */ prefix, /** @type {object} */ values) => Object.entries(values).map(([key, value]) => `${prefix}${encodeURIComponent(key)}=${encoded(value)}`);
  const first = format === 1 ? `lesson=${encoded(lesson)}` : `kind=${encoded(kind)}`;
  return [format, first, ...pairs("d.", document), ...pairs("v.", { ...VIEW, ...view })].join("&");
}

/**
 * @param {string} name of a file
 * @param {object} value a state, or the document of a linkage alone
 * @returns {Whole}
 */
function whole(name, value) {
  if ("document" in value) return /** @type {Whole} */ (value);
  return { kind: UNMOVING.some((one) => one === name) ? "draft" : "linkage", document: value };
}

/**
 * @param {Readonly<Record<string, Preset>>} all presets of a lesson
 * @param {string} id
 * @returns {Whole} the preset, completed from the preset that it is based on
 */
function entire(all, id) {
  const { from, ...own } = all[id];
  if (from === undefined) return own;
  const base = entire(all, from);
  return { ...base, document: { ...base.document, ...own.document } };
}

/**
 * @param {string} root of the repository
 * @returns {{ title: string, rows: { name: string, hash: string }[] }[]} the mechanisms, grouped by origin. `hash`:
 * part of the address after the #
 */
export function mechanisms(root) {
  const read = (/** @type {string} */ place) => readFileSync(path.join(root, place), "utf8");
  const names = (/** @type {string} */ folder) => readdirSync(path.join(root, folder)).filter((name) => name.endsWith(".json")).sort();
  const files = (/** @type {string} */ folder) => names(folder).map((name) => ({ name, hash: address(whole(name, JSON.parse(read(`${folder}/${name}`)))) }));
  const catalogue = [...MIXERS, ...names("crates/assur-file/catalogue").map((name) => path.basename(name, ".json"))];
  const given = read("tests/links.txt").split("\n").filter((line) => line.startsWith("#") && !line.startsWith("# "));
  const presets = [...list(path.join(root, "www/lessons"))].filter(([name]) => name.endsWith("/presets.json"));
  const lessons = presets.flatMap(([name, place]) => {
    const all = /** @type {Record<string, Preset>} */ (JSON.parse(readFileSync(place, "utf8")));
    return Object.keys(all).map((id) => ({ name: `${path.dirname(name)}: ${id}`, hash: address(entire(all, id)) }));
  });
  return [
    { title: "Catalogue", rows: catalogue.map((name) => ({ name, hash: name })) },
    { title: "Lessons", rows: lessons },
    { title: "Linkages (`tests/data/linkages`)", rows: files("tests/data/linkages") },
    { title: "Drawings that were difficult (`tests/data/drawings`)", rows: files("tests/data/drawings") },
    { title: "Links that were given out (`tests/links.txt`)", rows: given.map((line, at) => ({ name: `link ${at + 1}`, hash: line.slice(1).split("\t")[0] })) },
  ];
}

/**
 * @param {string} root of the repository
 * @returns {string} the page as Markdown
 */
export function linked(root) {
  const parts = mechanisms(root).map(({ title, rows }) => `## ${title}\n\n${rows.map(({ name, hash }) => `- [${name}](<./#${hash}>)`).join("\n")}\n`);
  return `# Mechanisms of the tests\n\nEach link opens a mechanism on the page.\n\n${parts.join("\n")}`;
}
