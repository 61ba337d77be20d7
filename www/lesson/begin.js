// Opening of a lesson from other parts of the page, with its step's mechanism; opening of the form for lecturers.
import { OWN, readLesson } from "assur/lesson/offer.js";
import { open } from "assur/lesson/show.js";
import { shownNow } from "assur/lesson/steps.js";
import { withExtras, withView } from "assur/state/state.js";

/**
 * Opens a lesson at a step, with the mechanism of this step.
 * @param {import("assur/app/page.js").Page} page
 * @param {import("assur/lesson/offer.js").Entry} entry
 * @param {number} [step] number of the step
 */
export async function begin(page, entry, step = 1) {
  const { lesson: { steps }, presets } = await readLesson(entry);
  const { id } = entry;
  const index = Math.min(Math.max(step, 1), steps.length) - 1;
  const [show] = steps[index].shows;
  if (open(show, presets, page, { lesson: { id, step: index + 1 } })) page.attend();
}

/**
 * Opens the form for lecturers. A state without a lesson gets one, with a single step that shows the present state.
 * @param {import("assur/app/page.js").Page} page
 */
export function writeLesson(page) {
  page.history.step(() => page.store.update((state) => {
    const lesson = state.lesson ?? { title: "", steps: [{ title: "", text: "", shows: shownNow(page) }] };
    const open = state.view.lesson?.id === OWN ? state.view.lesson : { id: OWN, step: 1 };
    return withView(withExtras(state, { lesson }), { lesson: open });
  }));
  page.lesson.write(true);
  page.attend();
}
