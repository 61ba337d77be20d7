// Files of the page other than scripts, fetched by their names in the import map.

const PACKED = "application/gzip";

/**
 * @param {string} name in the import map
 * @param {string} [type] media type of the file
 * @returns {Promise<Response>} the file, unpacked if it is compressed, as in the one-file page
 */
export async function fetched(name, type = "application/json") {
  const response = await fetch(import.meta.resolve(name));
  if (!response.ok) throw new Error(`${response.status} ${name}`);
  if (response.headers.get("Content-Type") !== PACKED || !response.body) return response;
  const unpacked = response.body.pipeThrough(new DecompressionStream("gzip"));
  return new Response(unpacked, { headers: { "Content-Type": type } });
}
