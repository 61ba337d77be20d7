// Legend of the overlays of instant centres, centrodes, curvature and forces, over the drawing: the names of their lines and marks, and a button that
// fits all of them into the view.
import { byId } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";

/** @typedef {"instant_centres" | "centrodes" | "curvature" | "forces"} Overlay */

/** Entry that only hinges with friction need. */
const CIRCLE = "forces.legend.circle";

/**
 * Lines and marks of each overlay: the role that colours them, their look, and the key of their name.
 * @type {Readonly<Record<Overlay, readonly (readonly [role: string, look: "line" | "dashed" | "ring" | "dot", name: string])[]>>}
 */
const ENTRIES = Object.freeze({
  instant_centres: [["ink", "ring", "legend.centre"], ["velocity", "line", "legend.kennedy"]],
  centrodes: [["accent3", "line", "legend.fixed"], ["accent4", "line", "legend.moving"], ["ink", "dot", "legend.pole"]],
  forces: [["reaction", "line", "forces.legend.reaction"], ["force", "line", "forces.legend.force"], ["weight", "line", "forces.legend.weight"], ["inertia", "line", "forces.legend.inertia"], ["torque", "line", "forces.legend.torque"], ["reaction", "ring", CIRCLE]],
  curvature: [["accent1", "line", "legend.circle"], ["accent1", "dashed", "legend.evolute"], ["accent2", "line", "legend.inflection"]],
});
const OVERLAYS = Object.freeze(/** @type {Overlay[]} */ (Object.keys(ENTRIES)));

export class Legend {
  #box = byId("legend", HTMLElement);
  #list = byId("legend-entries", HTMLElement);

  /** @param {import("assur/app/page.js").Page} page */
  constructor({ mechanism }) {
    byId("zoom-all", HTMLButtonElement).addEventListener("click", () => mechanism.fitAll());
  }

  /** @param {import("assur/state/model.js").Snapshot} snapshot */
  render({ state: { document, view }, summary, words }) {
    const on = "points" in summary && !view.drawing ? OVERLAYS.filter((overlay) => view[overlay]) : [];
    this.#box.hidden = on.length === 0;
    const rubs = "friction" in document && document.friction?.some(({ hinge }) => hinge);
    const entries = on.flatMap((overlay) => ENTRIES[overlay]).filter(([, , name]) => rubs || name !== CIRCLE).map(([role, look, name]) =>
      html`<li><i class=${look} .style=${`color: var(--role-${role})`} aria-hidden="true"></i> ${words.text(name)}</li>`);
    render(entries, this.#list);
  }
}
