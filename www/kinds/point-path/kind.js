// Views for a path. Loaded with the first path.
import { StatusLine } from "assur/controls/status.js";
import { AtlasView } from "assur/kinds/point-path/atlas.js";
import { Description } from "assur/kinds/point-path/description.js";
import { NinePointsView } from "assur/kinds/point-path/nine-points.js";
import { SearchView } from "assur/kinds/point-path/search.js";
import { ENTRIES } from "assur/kinds/point-path/status.js";
import { TaskView } from "assur/kinds/point-path/task.js";
import { TracedView } from "assur/kinds/point-path/traced.js";
import "assur/kinds/point-path/style.js";

/** Words that only this kind has. */
export const words = "kinds/point-path/later.*";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => [new TaskView(page), new TracedView(page), new SearchView(page), new NinePointsView(page), new AtlasView(page), new StatusLine("point-path", ENTRIES, page), new Description()];
