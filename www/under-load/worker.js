// Steady cycles, in a worker.
import { problemsOf } from "assur/core/problem.js";
import { start } from "assur/core/parts.js";
import { Simulator } from "assur/pkg/assur_web.js";

addEventListener("message", async ({ data }) => {
  const { wasm, state, rate, delta } = data;
  try {
    await start(wasm.first, () => wasm.second);
    const simulator = new Simulator();
    simulator.set(state);
    postMessage({ found: simulator.cycle(rate, delta) });
  } catch (thrown) {
    const problems = problemsOf(thrown);
    if (!problems) console.error(thrown);
    postMessage({ problems: problems ?? [{ code: "trapped" }] });
  }
});
