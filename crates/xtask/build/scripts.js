// The scripts of the built page, bundled by Rolldown into one chunk for the first view and one for each part that is
// loaded later. Chunks have the names of modules and import each other by bare names (`assur/…`), so that an import map
// can give each file any address. A change of one chunk then changes no other chunk.
import path from "node:path";
import { rolldown } from "rolldown";
import { lists } from "./folders.js";

/** @typedef {import("./folders.js").Sources} Sources */

/** Entry module of the first view, and name of its chunk. */
const FIRST = "app/main.js";

/** Script of the engine. It is a separate file, because the npm package contains it without the page. */
const ENGINE = "pkg/assur_web.js";

/**
 * Scripts that are bundled separately with everything they import: workers, the element for other pages, the engine.
 */
const ALONE = /(^|[/-])worker\.js$|^assur-mechanism\.js$|^pkg\/assur_web\.js$/;

/** Name of the entry chunk if it contains no module. This chunk is dropped. */
const ENTRY = "entry.js";

const PREFIX = "assur/";

/** A specifier of a static or a dynamic import, relative to the chunk. */
const RELATIVE = /(\bfrom|\bimport\(?)(["'`])(\.\.?\/[^"'`]+)\2/g;

/**
 * @param {Sources} sources of the page, its engine in `pkg/`
 * @returns {Promise<Map<string, string>>} the scripts of the built page by their paths
 */
export async function bundle(sources) {
  const names = new Map([...sources].map(([name, file]) => [file, name]));
  const listed = lists(sources);
  const used = new Set();
  const plugin = {
    name: "assur",
    resolveId: (/** @type {string} */ id) => {
      if (listed.has(id)) return id;
      return id.startsWith(PREFIX) ? sources.get(id.slice(PREFIX.length)) : undefined;
    },
    load: (/** @type {string} */ id) => listed.get(id),
    moduleParsed: (/** @type {{ id: string }} */ { id }) => void used.add(names.get(id)),
  };
  const scripts = new Map();
  /**
   * @param {string} entry
   * @param {import("rolldown").OutputOptions} options
   * @param {string} [external] a module that is not bundled
   */
  const generate = async (entry, options, external) => {
    const build = await rolldown({
      input: PREFIX + entry,
      external,
      plugins: [plugin],
      // Parts that are loaded later import from the chunk of the first view.
      preserveEntrySignatures: "allow-extension",
      // Warnings are treated as errors, except those about slow bundling, which depend on the machine.
      checks: { bundlerTimings: false },
      onLog: (level, { message }) => {
        if (level === "warn") throw new Error(message);
      },
    });
    // Exports keep their names, because short names would change with the imports of other chunks. Only comments with
    // notices of licences are kept.
    const comments = { legal: true, annotation: false, jsdoc: false };
    const { output } = await build.generate({ minify: true, comments, minifyInternalExports: false, ...options });
    return output.filter((file) => file.type === "chunk");
  };

  /** @param {import("rolldown").PreRenderedChunk} chunk */
  const named = ({ facadeModuleId, moduleIds }) => {
    const modules = moduleIds.map((id) => names.get(id));
    return modules.includes(FIRST) ? FIRST : (names.get(facadeModuleId ?? "") ?? modules.at(-1) ?? "chunk.js");
  };
  const chunks = await generate(
    FIRST,
    {
      codeSplitting: { groups: [{ name: "first", tags: ["$initial"] }] },
      chunkFileNames: named,
      entryFileNames: (chunk) => (chunk.moduleIds.length > 0 ? named(chunk) : ENTRY),
    },
    PREFIX + ENGINE,
  );
  // If a part is loaded later, the entry is a separate chunk that only imports the first view. This chunk is dropped.
  for (const { fileName, code } of chunks.filter(({ fileName }) => fileName !== ENTRY)) {
    const absolute = (/** @type {string} */ name) => PREFIX + path.posix.join(path.posix.dirname(fileName), name);
    scripts.set(fileName, code.replace(RELATIVE, (_, before, quote, name) => `${before}${quote}${absolute(name)}${quote}`));
  }
  for (const name of sources.keys()) {
    if (!ALONE.test(name)) continue;
    const [{ code }] = await generate(name, { codeSplitting: false });
    scripts.set(name, code);
  }
  const unused = [...sources.keys()].find((name) => name.endsWith(".js") && !used.has(name));
  if (unused) throw new Error(`${unused} is imported by no other script`);
  return scripts;
}
