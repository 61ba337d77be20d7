// Display of pending loads: a line below the header, and the page's busy state for assistive software.
import { byId } from "assur/core/dom.js";

let waiting = 0;

/**
 * Shows the page as busy until a promise is settled.
 * @template T
 * @param {Promise<T>} coming
 * @returns {Promise<T>} a promise with the same result
 */
export async function awaited(coming) {
  tell(1);
  try {
    return await coming;
  } finally {
    tell(-1);
  }
}

/** @param {1 | -1} more change in the number of pending loads */
function tell(more) {
  waiting += more;
  byId("app", HTMLElement).ariaBusy = waiting > 0 ? "true" : null;
}
