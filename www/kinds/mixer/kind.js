// Views for a mixer.
import { Rail } from "assur/kinds/mixer/rail.js";
import { mixerStatus } from "assur/kinds/mixer/status.js";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => [new Rail(page), mixerStatus()];
