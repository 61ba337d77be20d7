// All that the page shows of a linkage beside drawing and plots, put together. Loaded with the first linkage.
import { CourseView, paintCourse } from "assur/linkage/course.js";
import { EquationsView } from "assur/linkage/equations.js";
import "assur/linkage/style.js";
import { LinkageRail, LinkageStatus, LinkageTitle } from "assur/linkage/views.js";

/**
 * @param {{
 *   store: import("assur/store.js").Store<import("assur/state.js").State>,
 *   drafts: import("assur/drafts.js").Drafts,
 *   history: import("assur/history.js").History,
 *   engine: import("assur/engine.js").Engine,
 *   chart: import("assur/chart.js").ChartView,
 *   views: { render(snapshot: import("assur/model.js").Snapshot): void }[],
 * }} page of which `views` are shown whatever the mechanism
 * @param {import("assur/words.js").Words} words
 * @returns {{ render(snapshot: import("assur/model.js").OwnSnapshot<"linkage">): void }[]} what is shown while it is a linkage
 */
export function linkageParts({ store, drafts, history, engine, chart, views }, words) {
  chart.lay(paintCourse);
  views.push(new LinkageTitle(engine));
  return [
    new LinkageRail(store, drafts, words),
    new CourseView(store, drafts, history, words),
    new LinkageStatus(words),
    new EquationsView(engine, words),
  ];
}
