// All motions of a linkage, in a worker: the map of their branches, and the branches of the assemblies at an input.
import load, { AllMotions } from "assur/pkg/assur_web.js";

/** @type {Promise<unknown> | null} */
let engine = null;
/** @type {AllMotions | null} */
let motions = null;

addEventListener("message", async ({ data }) => {
  try {
    // The compiled wasm comes with the first question.
    engine ??= load({ module_or_path: data.wasm });
    await engine;
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
    // Problems answer the question; any other failure leaves the engine unusable.
    const broken = !Array.isArray(thrown);
    if (broken) console.error(thrown);
    postMessage({ revision: data.revision, lost: true, broken });
  }
});
