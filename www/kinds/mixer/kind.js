// What the page shows of a mixer only.
import { Rail } from "assur/kinds/mixer/rail.js";
import { mixerStatus } from "assur/kinds/mixer/status.js";

/** @param {import("assur/app/page.js").Page} page */
export function mixerViews(page) {
  return { views: [new Rail(page), mixerStatus()], common: [] };
}
