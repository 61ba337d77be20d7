// Views for a mixer.
import { StatusLine } from "assur/controls/status.js";
import { Rail } from "assur/kinds/mixer/rail.js";
import { ENTRIES } from "assur/kinds/mixer/status.js";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => [new Rail(page), new StatusLine("mixer", ENTRIES, page)];
