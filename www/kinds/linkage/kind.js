// Views for a linkage. Loaded with the first linkage.
import { StatusLine } from "assur/controls/status.js";
import { CourseView, paintCourse } from "assur/kinds/linkage/course.js";
import { EquationsView } from "assur/kinds/linkage/equations.js";
import { LinkageRail } from "assur/kinds/linkage/rail.js";
import { ENTRIES } from "assur/kinds/linkage/status.js";
import "assur/kinds/linkage/style.js";
import { TracedPoints } from "assur/kinds/linkage/tracers.js";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => {
  page.chart.lay(paintCourse);
  return [new LinkageRail(page), new TracedPoints(page), new CourseView(page), new StatusLine("linkage", ENTRIES, page), new EquationsView(page)];
};
