// Introduction to the page and to its lessons, shown on a first visit.
import { LOST } from "assur/app/notices.js";
import { byId, make } from "assur/core/dom.js";
import { LESSONS } from "assur/lessons/index.js";
import { addressed } from "assur/state/address.js";
import { keep, kept } from "assur/state/storage.js";

/** Name under which the browser stores that the introduction was closed. */
const NAME = "welcome";

/**
 * Shows the introduction, unless the reader has closed it before, or the page was opened by a shared URL or in a frame.
 * @param {import("assur/app/page.js").Page} page
 */
export function welcome(page) {
  const container = byId("welcome", HTMLElement);
  const sent = addressed(location.href) !== "" || self !== top;
  if (sent || kept(NAME) !== null) return;
  const close = () => {
    keep(NAME, "closed");
    container.hidden = true;
  };
  byId("welcome-lessons", HTMLElement).append(...LESSONS.map((entry) => {
    const button = make("button", { id: `welcome-${entry.id}`, class: "control", type: "button", "data-t": `lessons.${entry.id}.title` });
    button.addEventListener("click", async () => {
      const part = await import("assur/lesson/begin.js").catch(() => null);
      if (part) await part.begin(page, entry);
      else page.notices.tell(LOST);
    });
    return button;
  }));
  byId("welcome-close", HTMLButtonElement).addEventListener("click", () => {
    close();
    byId("gallery", HTMLButtonElement).focus();
  });
  // A reader with an open lesson needs no introduction.
  page.store.subscribe(({ view: { lesson } }) => {
    if (lesson && !container.hidden) close();
  });
  container.hidden = false;
}
