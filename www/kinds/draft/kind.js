// Views of a drawing that does not move yet; it is always shown with the drawing tools.
import { StatusLine } from "assur/controls/status.js";
import { withView } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/model.js").OwnSnapshot<"draft">} Snapshot
 */

/** @type {import("assur/app/views.js").Make} */
export const views = ({ store }) => [
  new StatusLine("draft", [
    {
      name: "draft-w", title: "status.w",
      say: (/** @type {Snapshot} */ { summary: { mobility }, words: { numbers } }) => (mobility === null ? null : { text: numbers.exact(mobility), value: mobility }),
    },
    {
      name: "draft-drivers", title: "status.drivers",
      say: (/** @type {Snapshot} */ { summary: { drivers }, words: { numbers } }) => ({ text: numbers.exact(drivers), value: drivers }),
    },
  ]),
  { render: ({ state }) => state.view.drawing || store.update((now) => withView(now, { drawing: true })) },
];
