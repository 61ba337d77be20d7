// A lesson opened from elsewhere than its tab: with the mechanism of its step.
import { readLesson } from "assur/lesson/offer.js";
import { Progress } from "assur/lesson/progress.js";
import { open } from "assur/lesson/show.js";

/**
 * Opens a lesson at the first step that was not answered rightly, with what the step shows.
 * @param {import("assur/app/page.js").Page} page
 * @param {import("assur/lesson/offer.js").Entry} entry
 */
export async function begin(page, entry) {
  const { lesson: { steps }, presets } = await readLesson(entry);
  const { id } = entry;
  const index = Math.max(new Progress(id, steps).next, 0);
  const [show] = steps[index].shows;
  if (open(show, presets, page, { lesson: { id, step: index + 1 } })) page.attend();
}
