// Views of a drawing that is not yet a movable linkage. The drawing tools are always shown with it.
import { StatusLine } from "assur/controls/status.js";
import { withView } from "assur/state/state.js";

/** @typedef {import("assur/state/model.js").OwnSnapshot<"draft">} Snapshot */

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => [
  new StatusLine("draft", [
    {
      name: "draft-w", title: "status.w",
      say: (/** @type {Snapshot} */ { summary: { mobility }, words: { numbers } }) => (mobility === null ? null : { text: numbers.exact(mobility), value: mobility }),
    },
    {
      name: "draft-drivers", title: "status.drivers",
      say: (/** @type {Snapshot} */ { summary: { drivers }, words: { numbers } }) => ({ text: numbers.exact(drivers), value: drivers }),
    },
  ], page),
  { render: ({ state }) => state.view.drawing || page.store.update((now) => withView(now, { drawing: true })) },
];
