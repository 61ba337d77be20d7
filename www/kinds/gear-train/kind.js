// Views for a differential. Loaded with the first differential.
import { StatusLine } from "assur/controls/status.js";
import { BodiesView } from "assur/kinds/gear-train/bodies.js";
import { ConditionsView } from "assur/kinds/gear-train/conditions.js";
import { TrainDescription } from "assur/kinds/gear-train/description.js";
import { DrivesView } from "assur/kinds/gear-train/drives.js";
import { LoadView } from "assur/kinds/gear-train/load.js";
import { MembersView } from "assur/kinds/gear-train/members.js";
import { ObserverView } from "assur/kinds/gear-train/observer.js";
import { RatiosView } from "assur/kinds/gear-train/ratios.js";
import { ENTRIES } from "assur/kinds/gear-train/status.js";
import { WheelsView } from "assur/kinds/gear-train/wheels.js";
import "assur/kinds/gear-train/style.js";

/** Words that only this kind has. */
export const words = "kinds/gear-train/later.*";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => [
  new DrivesView(page), new ObserverView(page), new WheelsView(page), new ConditionsView(page), new RatiosView(), new MembersView(page), new LoadView(page),
  new BodiesView(page), new StatusLine("gear-train", ENTRIES, page), new TrainDescription(),
];
