// Release of a pressed pointer.

/**
 * Reports the release of a pointer, and events after which the page may not get the release: a context menu opens, or
 * the focus moves to another frame or window. A `blur` of an element does not reach the window.
 * @param {() => void} then called at each of these events
 */
export function whenReleased(then) {
  for (const end of ["pointerup", "pointercancel", "contextmenu"]) addEventListener(end, then, true);
  addEventListener("blur", then);
}
