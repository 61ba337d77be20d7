// What is on its way shows that it is: a line below the header, and the page tells assistive software that it is busy.
import { byId } from "assur/core/dom.js";

let waiting = 0;

/**
 * @template T
 * @param {Promise<T>} coming
 * @returns {Promise<T>} the same
 */
export async function awaited(coming) {
  tell(1);
  try {
    return await coming;
  } finally {
    tell(-1);
  }
}

/** @param {1 | -1} more that are waited for */
function tell(more) {
  waiting += more;
  byId("app", HTMLElement).ariaBusy = waiting > 0 ? "true" : null;
}
