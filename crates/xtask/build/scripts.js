// The scripts of the built page, bundled by Rolldown: those of the first view in one chunk, and one chunk for each part that is
// loaded later. Chunks keep the names of their modules and import each other by bare names (`assur/…`), so that an import map
// can give each file any address: no chunk changes because another one did.
import path from "node:path";
import { rolldown } from "rolldown";
import { lists } from "./folders.js";

/** @typedef {import("./folders.js").Sources} Sources */

/** The module that the first view begins with, and its chunk. */
const FIRST = "app/main.js";

/** Scripts that run outside the page, each bundled with all that it imports: workers, and the element for other pages. */
const ALONE = /(^|[/-])worker\.js$|^assur-mechanism\.js$/;

/** A chunk that is not kept. */
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
   */
  const generate = async (entry, options) => {
    const build = await rolldown({
      input: PREFIX + entry,
      plugins: [plugin],
      // Nothing is imported from the entry, so its chunk may be that of the whole first view.
      preserveEntrySignatures: false,
      onLog: (_, { message }) => {
        throw new Error(message);
      },
    });
    // Names of exports stay: short ones would change with what other chunks import.
    const { output } = await build.generate({ minify: true, comments: false, minifyInternalExports: false, ...options });
    return output.filter((file) => file.type === "chunk");
  };

  /** @param {import("rolldown").PreRenderedChunk} chunk */
  const named = ({ facadeModuleId, moduleIds }) => {
    const modules = moduleIds.map((id) => names.get(id));
    return modules.includes(FIRST) ? FIRST : (names.get(facadeModuleId ?? "") ?? modules.at(-1) ?? "chunk.js");
  };
  const chunks = await generate(FIRST, {
    codeSplitting: { groups: [{ name: "first", tags: ["$initial"] }] },
    chunkFileNames: named,
    entryFileNames: (chunk) => (chunk.moduleIds.length > 0 ? named(chunk) : ENTRY),
  });
  // Where something is loaded later, the entry is a chunk of its own that only imports the first view.
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
