// The kinds of mechanism: what of the page only one of them has.
import { mixerViews } from "assur/kinds/mixer/kind.js";

/**
 * @typedef {import("assur/state/state.js").Kind} Kind
 * @typedef {import("assur/app/views.js").View} View
 * @typedef {(page: import("assur/app/page.js").Page) => { views: readonly View[], common: readonly View[] }} Make
 * `views` are shown where both the state and what is drawn are of the kind, `common` from then on whatever there is.
 */

/** @type {ReadonlyMap<Kind, Make>} that of the first view is here at once */
export const HERE = new Map([["mixer", mixerViews]]);

/** @type {ReadonlyMap<Kind, () => Promise<Make>>} others are loaded when they are needed */
export const LATER = new Map([["linkage", async () => (await import("assur/kinds/linkage/kind.js")).linkageViews]]);
