// Worker that searches for a dwell and reports each mechanism. After an improvement, it waits for the page to show it.
import { problemsOf } from "assur/core/problem.js";
import { start } from "assur/core/parts.js";
import { Design } from "assur/pkg/assur_web.js";

/** Ends the wait after an improvement. */
let goOn = () => {};

addEventListener("message", ({ data }) => {
  if (data.wasm) search(data);
  else goOn();
});

/** @param {{ wasm: import("assur/core/parts.js").Parts, state: import("assur/types/web.js").State, wishes: import("assur/types/web.js").Wishes }} task the compiled engine, and the arguments of its `Design` */
async function search({ wasm, state, wishes }) {
  try {
    await start(wasm.first, () => wasm.second);
    const design = new Design(state, wishes);
    let progress;
    do {
      progress = design.step();
      postMessage({ progress });
      if (progress.accepted) await new Promise((resolve) => (goOn = () => resolve(undefined)));
    } while (!progress.end);
  } catch (thrown) {
    const problems = problemsOf(thrown);
    if (!problems) console.error(thrown);
    postMessage({ problems: problems ?? [{ code: "part_broke" }] });
  }
}
