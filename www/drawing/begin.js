// Start of drawing: on an empty sheet, or on the open document.
import { edit } from "assur/drawing/edit.js";
import { withView } from "assur/state/state.js";

/** @param {import("assur/app/page.js").Page} page */
export function newDrawing(page) {
  const { kind, document } = page.engine.functions.blank();
  page.choose(kind, document, [], () => ({ drawing: true, playing: false, lesson: null }));
}

/** @param {import("assur/app/page.js").Page} page */
export function toggleDrawing(page) {
  const { store, history, model } = page;
  model.follow(store.get());
  const { summary } = model;
  if (!(summary.moves ? summary.traceable : "links" in store.get().document)) return;
  // A draft, which does not move, is shown only with the drawing tools.
  const on = !summary.moves || !store.get().view.drawing;
  history.step(() => {
    store.update((state) => withView(state, { drawing: on, playing: on ? false : state.view.playing }));
    // An edit that moves nothing converts a document of another kind into a linkage.
    if (on && !("links" in store.get().document)) edit(page, { edit: "move", points: [], by: [0, 0] });
  });
}
