// Release of a pressed pointer.

/**
 * Reports the release of a pointer, or a `blur` of the window. A `blur` of an element does not reach the window.
 * @param {() => void} then called when a pointer is released, or its release goes to a context menu, another frame or another window
 */
export function whenReleased(then) {
  for (const end of ["pointerup", "pointercancel", "contextmenu"]) addEventListener(end, then, true);
  addEventListener("blur", then);
}
