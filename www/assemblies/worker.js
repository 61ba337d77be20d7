// All motions of a linkage, found beside the page: the map of their branches, and where the assemblies at an input belong. The
// import map of the page does not hold here, so that the page says where the engine is.

/** @type {Promise<typeof import("assur/pkg/assur_web.js")> | null} */
let engine = null;
/** @type {import("assur/pkg/assur_web.js").AllMotions | null} */
let motions = null;

addEventListener("message", async ({ data }) => {
  try {
    engine ??= load(data);
    const { AllMotions } = await engine;
    if (data.state) {
      motions?.free();
      motions = null;
      motions = new AllMotions(data.state);
      postMessage({ revision: data.revision, map: motions.map() });
    } else if (motions) {
      const { input, number } = data;
      postMessage({ revision: data.revision, input, number, belonging: motions.belonging(input, number) });
    }
  } catch (thrown) {
    // Problems are told of what is asked; anything else has left the engine in no state to go on.
    const broken = !Array.isArray(thrown);
    if (broken) console.error(thrown);
    postMessage({ revision: data.revision, lost: true, broken });
  }
});

/** @param {{ engine: string, wasm: ArrayBuffer }} data address and wasm of the engine, which come first */
async function load({ engine: address, wasm }) {
  const module = await import(address);
  await module.default({ module_or_path: wasm });
  return module;
}
