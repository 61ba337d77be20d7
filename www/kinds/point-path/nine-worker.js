// Worker of a search through nine points. With start data it follows paths. Without start data it collects the results
// and gives out the work.
import { problemsOf } from "assur/core/problem.js";
import { start as begin } from "assur/core/parts.js";
import { NinePointSearch, NinePointWorker } from "assur/pkg/assur_web.js";

/** @type {NinePointSearch | null} */
let search = null;
/** @type {NinePointWorker | null} */
let tracker = null;

addEventListener("message", async ({ data }) => {
  const { wasm, state, start, ends, work } = data;
  try {
    if (wasm) {
      await begin(wasm.first, () => wasm.second);
      if (start) {
        tracker = new NinePointWorker(start, state);
        postMessage({});
      } else {
        search = new NinePointSearch(state);
        postMessage({ work: search.work(), progress: search.progress() });
      }
    } else if (search && ends) {
      search.add(ends);
      postMessage({ progress: search.progress(), found: search.found(), work: search.work() });
    } else if (tracker && work) {
      postMessage({ ends: tracker.track(work) });
    }
  } catch (thrown) {
    const problems = problemsOf(thrown);
    if (!problems) console.error(thrown);
    postMessage({ problems: problems ?? [{ code: "part_broke" }] });
  }
});
