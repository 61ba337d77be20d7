// Worker that searches for the linkage whose point traces a path best, for some seconds.
import { problemsOf } from "assur/core/problem.js";
import { start } from "assur/core/parts.js";
import { PathSearch } from "assur/pkg/assur_web.js";

/** Linkages that are compared in a step. */
const STEP = 2048;

/** Least time between two messages, in milliseconds. */
const PAUSE = 150;

addEventListener("message", async ({ data }) => {
  const { wasm, state, wishes, seconds } = data;
  try {
    await start(wasm.first, () => wasm.second);
    const search = new PathSearch(state, wishes);
    const end = performance.now() + 1000 * seconds;
    let said = -Infinity;
    /** @type {import("assur/types/web.js").TracingProgress["found"]} */
    let found = null;
    for (;;) {
      const progress = search.step(STEP);
      found = progress.found ?? found;
      const now = performance.now();
      const ended = progress.exact || now > end;
      if (!ended && now < said + PAUSE) continue;
      said = now;
      postMessage({ progress: { ...progress, found }, ended });
      found = null;
      if (ended) break;
    }
  } catch (thrown) {
    const problems = problemsOf(thrown);
    if (!problems) console.error(thrown);
    postMessage({ problems: problems ?? [{ code: "part_broke" }] });
  }
});
