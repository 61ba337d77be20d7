// Views for poses of a body. Loaded with the first poses.
import { StatusLine } from "assur/controls/status.js";
import { CurvePress } from "assur/kinds/poses/curve-press.js";
import { Description } from "assur/kinds/poses/description.js";
import { HingesView } from "assur/kinds/poses/hinges.js";
import { PairsView } from "assur/kinds/poses/pairs.js";
import { ENTRIES } from "assur/kinds/poses/status.js";
import { TaskView } from "assur/kinds/poses/task.js";
import "assur/kinds/poses/style.js";

/** Words that only this kind has. */
export const words = "kinds/poses/later.*";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => [new TaskView(page), new HingesView(page), new PairsView(page), new CurvePress(page), new StatusLine("poses", ENTRIES, page), new Description()];
