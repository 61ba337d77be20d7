// Fields of a document as lessons name them: a dimension by the link or point that has it.

/**
 * @param {string} name of a field; of a dimension of a link or point by its name, as `FK.length`, `H.x`
 * @param {import("assur/state/state.js").State["document"]} document
 * @returns {string} as the controls have it: `links[5].length`
 */
export function fieldOf(name, document) {
  const [, of, part] = /^(.+)\.(length|x|y)$/.exec(name) ?? [];
  for (const list of /** @type {const} */ (["links", "points"])) {
    /** @type {readonly { name: string }[]} */
    const entries = Object(document)[list] ?? [];
    const index = entries.findIndex((entry) => entry.name === of);
    if (index >= 0 && of) return `${list}[${index}].${part}`;
  }
  return name;
}
