// All motions of a linkage, in a worker: the map of the branches, and the branch of each assembly at an input.
import { problemsOf } from "assur/core/problem.js";
import { start } from "assur/core/parts.js";
import { AllMotions } from "assur/pkg/assur_web.js";

/** @type {Promise<unknown> | null} */
let engine = null;
/** @type {AllMotions | null} */
let motions = null;

addEventListener("message", async ({ data }) => {
  try {
    // The compiled wasm comes with the first question.
    engine ??= start(data.wasm.first, () => data.wasm.second);
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
    // After an exception without problems the engine is unusable.
    const broken = !problemsOf(thrown);
    if (broken) console.error(thrown);
    postMessage({ revision: data.revision, lost: true, broken });
  }
});
