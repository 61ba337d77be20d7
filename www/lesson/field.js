// Names of a document's fields in lessons. A dimension is named by its link or point, other numbers by their path.

/**
 * @param {string} name name of a field in a lesson; a dimension's name begins with its link or point, as in `FK.length`, `H.x`
 * @param {import("assur/state/state.js").State["document"]} document
 * @returns {string} the field's name in the controls, such as `links[5].length`
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

/**
 * @template T
 * @param {T} document
 * @param {string} field path of a number in the document, such as `wheels[0].z`
 * @param {number} value
 * @returns {T} the document with the value there
 */
export function withNumber(document, field, value) {
  return /** @type {T} */ (put(document, field.split(/[.[\]]+/).filter((key) => key !== ""), value));
}

/**
 * @param {unknown} part of a document
 * @param {readonly string[]} path within the part
 * @param {number} value
 * @returns {unknown} the part with the value at the path
 */
function put(part, [key, ...path], value) {
  if (key === undefined) return value;
  if (Array.isArray(part)) return part.with(Number(key), put(part[Number(key)], path, value));
  return { ...Object(part), [key]: put(Object(part)[key], path, value) };
}
