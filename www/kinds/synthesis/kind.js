// Views for a synthesis. Loaded with the first synthesis.
import { StatusLine } from "assur/controls/status.js";
import { ConditionsView } from "assur/kinds/synthesis/conditions.js";
import { FamilyView } from "assur/kinds/synthesis/family.js";
import { PositionsView } from "assur/kinds/synthesis/positions.js";
import { SolutionsView } from "assur/kinds/synthesis/solutions.js";
import { ENTRIES } from "assur/kinds/synthesis/status.js";
import { TrialView } from "assur/kinds/synthesis/trial.js";
import "assur/kinds/synthesis/style.js";

/** Words that only this kind has. */
export const words = "kinds/synthesis/later.*";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => [new PositionsView(page), new TrialView(page), new FamilyView(page), new SolutionsView(page), new ConditionsView(page), new StatusLine("synthesis", ENTRIES, page)];
