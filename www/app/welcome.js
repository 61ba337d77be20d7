// Line with the three ways to begin, shown over the drawing on a first visit until the reader does something.
import { LOST } from "assur/app/notices.js";
import { byId } from "assur/core/dom.js";
import { LESSONS } from "assur/lessons/index.js";
import { addressed } from "assur/state/address.js";
import { keep, kept } from "assur/state/storage.js";

/** Name under which the browser stores that the line has been closed. */
const NAME = "welcome";

/**
 * Shows the line, unless the reader has closed it before, or the page was opened by a shared URL or in a frame.
 * @param {import("assur/app/page.js").Page} page
 * @param {import("assur/app/commands.js").Commands} commands
 */
export function welcome(page, commands) {
  const line = byId("welcome", HTMLElement);
  const sent = addressed(location.href) !== "" || self !== top;
  if (sent || kept(NAME) !== null) return;
  const { store } = page;
  const close = () => {
    unsubscribe();
    keep(NAME, "closed");
    line.hidden = true;
  };
  const [first] = LESSONS;
  const begin = async () => {
    const part = await import("assur/lesson/begin.js").catch(() => null);
    if (part) await part.begin(page, first);
    else page.notices.tell(LOST);
  };
  const acts = { "welcome-draw": commands["new-drawing"], "welcome-gallery": commands.gallery, "welcome-lesson": begin, "welcome-close": () => byId("gallery", HTMLButtonElement).focus() };
  for (const [id, act] of Object.entries(acts)) {
    byId(id, HTMLButtonElement).addEventListener("click", () => {
      close();
      act();
    });
  }
  // Other changes do not close the line: the input changes by itself, and the choice of a language is no action on the mechanism.
  const unsubscribe = store.subscribe(({ document, view }, previous) => {
    if (document !== previous.document || view.playing !== previous.view.playing || view.lesson !== previous.view.lesson || view.drawing !== previous.view.drawing) close();
  });
  line.hidden = false;
}
