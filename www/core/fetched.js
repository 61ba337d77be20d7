// Files of the page other than scripts, fetched by their bare names.

const PACKED = "application/gzip";

/**
 * @param {string} name in the import map
 * @param {string} [type] its media type
 * @returns {Promise<Response>} the file; the one-file page has it compressed
 */
export async function fetched(name, type = "application/json") {
  const response = await fetch(import.meta.resolve(name));
  if (!response.ok) throw new Error(`${response.status} ${name}`);
  if (response.headers.get("Content-Type") !== PACKED || !response.body) return response;
  const unpacked = response.body.pipeThrough(new DecompressionStream("gzip"));
  return new Response(unpacked, { headers: { "Content-Type": type } });
}
