// Lists of the lessons and of the kinds of document. The build finds both by their folders in `www/lessons` and
// `www/kinds`, so no script has to list them.
import { readFileSync } from "node:fs";

/** @typedef {ReadonlyMap<string, string>} Sources locations of the page's source files by their paths in `www` */
/** @typedef {Record<string, string>} Table texts by their keys */

/** Id of a lecturer's lesson, which is stored in the state. No folder may have this name. */
const OWN = "own";

/** Keys of a lesson's words that the page shows before the lesson is opened; `lessons.ID.KEY` in the page's table. */
const CALLED = Object.freeze(["title", "line"]);

/**
 * @param {string | undefined} file
 * @param {string} name
 */
function json(file, name) {
  try {
    return JSON.parse(readFileSync(file ?? name, "utf8"));
  } catch (error) {
    throw new Error(`${name} cannot be read: ${error}`);
  }
}

/**
 * @param {Sources} sources
 * @param {string} folder
 * @returns {string[]} the names of the folders in a folder
 */
function within(sources, folder) {
  const names = [...sources.keys()].filter((name) => name.startsWith(`${folder}/`)).map((name) => name.split("/"));
  return [...new Set(names.filter((parts) => parts.length > 2).map((parts) => parts[1]))].sort();
}

/**
 * @param {Record<string, unknown>} facts
 * @param {readonly string[]} known
 * @param {string} place
 */
function onlyKnown(facts, known, place) {
  const odd = Object.keys(facts).find((key) => !known.includes(key));
  if (odd) throw new Error(`${place} has an unknown field ${odd}`);
}

/**
 * @param {Sources} sources
 * @returns {{ id: string, about: string[], presets: boolean, paper: boolean, notes: boolean }[]}
 * the lessons in the order of their `place`. A lesson without `place` comes last
 */
export function lessons(sources) {
  const found = within(sources, "lessons").map((id) => {
    // A state with any other id of a lesson is refused.
    if (!/^[a-z0-9-]+$/.test(id)) throw new Error(`the lesson ${id}: a name has small letters, digits and hyphens only`);
    if (id === OWN) throw new Error(`the lesson ${id}: this is the name of one that is saved in the state`);
    for (const file of ["lesson.js", "words.en.json"]) {
      if (!sources.has(`lessons/${id}/${file}`)) throw new Error(`the lesson ${id} has no ${file}`);
    }
    const place = `lessons/${id}/lesson.json`;
    const facts = json(sources.get(place), place);
    onlyKnown(facts, ["about", "place"], place);
    const { about, place: rank = Infinity } = facts;
    const strings = Array.isArray(about) && about.every((origin) => typeof origin === "string");
    if (!strings || typeof rank !== "number") throw new Error(`${place} does not say what it is about`);
    const has = (/** @type {string} */ file) => sources.has(`lessons/${id}/${file}`);
    return { id, about, presets: has("presets.json"), paper: has("paper.json"), notes: has("notes.en.md"), rank };
  });
  const ordered = found.sort((one, other) => (one.rank === other.rank ? 0 : one.rank - other.rank));
  return ordered.map(({ rank, ...lesson }) => lesson);
}

/**
 * @param {Sources} sources
 * @returns {{ id: string, first: boolean }[]} the kinds. `first`: whether the first view includes the kind, because a
 * first visit shows it
 */
export function kinds(sources) {
  return within(sources, "kinds").map((id) => {
    if (!sources.has(`kinds/${id}/kind.js`)) throw new Error(`the kind ${id} has no kind.js`);
    const place = `kinds/${id}/kind.json`;
    const facts = sources.has(place) ? json(sources.get(place), place) : { first: false };
    onlyKnown(facts, ["first"], place);
    if (typeof facts.first !== "boolean") throw new Error(`${place} does not say whether it is first`);
    return { id, first: facts.first };
  });
}

/**
 * @param {Sources} sources
 * @returns {Map<string, string>} source texts of the modules that list the folders, by the names of the modules
 */
export function lists(sources) {
  const found = lessons(sources);
  const scripts = found.map(({ id }) => `"${id}": () => import("assur/lessons/${id}/lesson.js")`);
  const all = kinds(sources);
  const here = all.filter(({ first }) => first);
  const imports = here.map(({ id }, number) => `import { views as first${number} } from "assur/kinds/${id}/kind.js";`);
  const later = all.filter(({ first }) => !first).map(({ id }) => `["${id}", () => import("assur/kinds/${id}/kind.js")]`);
  return new Map([
    ["assur/lessons/index.js", `export const LESSONS = ${JSON.stringify(found)};\nexport const SCRIPTS = { ${scripts} };`],
    [
      "assur/kinds/index.js",
      `${imports.join("")}\nexport const HERE = new Map([${here.map(({ id }, number) => `["${id}", first${number}]`)}]);
      export const LATER = new Map([${later}]);`,
    ],
  ]);
}

/**
 * Collects the words of the page in one language: from `lang`, from the kinds, and for the gallery from the lessons.
 * @param {Sources} sources
 * @param {string} own location of the language's file in `lang`
 * @param {string} language
 * @returns {Table} sorted by key, the order that compresses best
 */
export function words(sources, own, language) {
  const table = json(own, own);
  for (const { id } of kinds(sources)) {
    const place = `kinds/${id}/words.${language}.json`;
    if (sources.has(place)) Object.assign(table, json(sources.get(place), place));
  }
  for (const { id } of lessons(sources)) {
    const place = `lessons/${id}/words.${language}.json`;
    const called = json(sources.get(place), place);
    for (const key of CALLED) {
      if (!(key in called)) throw new Error(`the lesson ${id} has no ${key} in its words of ${language}`);
      table[`lessons.${id}.${key}`] = called[key];
    }
  }
  return Object.fromEntries(Object.entries(table).sort(([one], [other]) => (one < other ? -1 : 1)));
}
