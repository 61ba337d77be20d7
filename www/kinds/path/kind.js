// Views for a path. Loaded with the first path.
import { StatusLine } from "assur/controls/status.js";
import { Description } from "assur/kinds/path/description.js";
import { NinePointsView } from "assur/kinds/path/nine-points.js";
import { SearchView } from "assur/kinds/path/search.js";
import { ENTRIES } from "assur/kinds/path/status.js";
import { TaskView } from "assur/kinds/path/task.js";
import { TracedView } from "assur/kinds/path/traced.js";
import "assur/kinds/path/style.js";

/** Words that only this kind has. */
export const words = "kinds/path/later.*";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => [new TaskView(page), new TracedView(page), new SearchView(page), new NinePointsView(page), new StatusLine("path", ENTRIES, page), new Description()];
