// What the page shows of a mixer only.
import { numberLists } from "assur/kinds/mixer/lists.js";
import { Rail } from "assur/kinds/mixer/rail.js";
import { mixerStatus } from "assur/kinds/mixer/status.js";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => {
  numberLists();
  return [new Rail(page), mixerStatus()];
};
