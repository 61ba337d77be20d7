// The choice of a linkage for a path.
import { attempt } from "assur/core/problem.js";
import { inputNow } from "assur/state/change.js";
import { edited } from "assur/state/state.js";

/**
 * Shows a linkage. If it has no pose at the present input, it is shown at the first point that it meets.
 * @param {import("assur/app/page.js").Page} page
 * @param {import("assur/types/file.js").TracingDocument} linkage
 */
export function choose(page, linkage) {
  page.store.update((state) => edited(state, "point-path", () => ({ linkage })));
  page.model.follow(page.store.get());
  const { summary, coordinate } = page.model;
  if (!("met" in summary) || !("traced" in summary) || summary.moves === null) return;
  if (attempt(() => page.engine.at(inputNow(page))).value) return;
  const input = summary.met.find((one) => one !== null);
  if (typeof input === "number") page.drive(coordinate.inputShown(input));
}

/**
 * @param {import("assur/app/page.js").Page} page
 * @param {() => void} left called when the page shows a document of another kind
 */
export function onLeaving({ store }, left) {
  store.subscribe(({ kind }, previous) => {
    if (kind !== "point-path" && previous.kind === "point-path") left();
  });
}
