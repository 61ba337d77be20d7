// Projector mode. The browser stores it apart from the state, so that it stays on after a reload and in links that are opened in class.
import { withView } from "assur/state/state.js";
import { keep, kept } from "assur/state/storage.js";

/** Name under which the browser stores whether the mode is on, and the stored value if it is. */
const NAME = "projector";
const ON = "on";

/** @returns {boolean} whether the reader left the mode on */
export function keptProjector() {
  return kept(NAME) === ON;
}

/** @param {Pick<import("assur/app/page.js").Page, "store" | "habits">} page */
export function toggleProjector({ store, habits }) {
  const projector = !store.get().view.projector;
  store.update((state) => withView(state, { projector }));
  // A page embedded in another stores nothing.
  if (!habits.embedding) keep(NAME, projector ? ON : "off");
}
