// What the page shows of a linkage only. Loaded with the first linkage.
import { CourseView, paintCourse } from "assur/kinds/linkage/course.js";
import { EquationsView } from "assur/kinds/linkage/equations.js";
import { LinkageRail } from "assur/kinds/linkage/rail.js";
import { linkageStatus } from "assur/kinds/linkage/status.js";
import "assur/kinds/linkage/style.js";
import { TracedPoints } from "assur/kinds/linkage/tracers.js";
import { LinkageTitle } from "assur/kinds/linkage/title.js";

/** @param {import("assur/app/page.js").Page} page */
export function linkageViews(page) {
  page.chart.lay(paintCourse);
  return {
    views: [new LinkageRail(page), new TracedPoints(page), new CourseView(page), linkageStatus(), new EquationsView(page)],
    common: [new LinkageTitle(page)],
  };
}
