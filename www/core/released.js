// Release of a pressed pointer.

/**
 * Reports the release. `blur` of the window counts as a release; `blur` of an element, which may come during a press, does not bubble.
 * @param {() => void} then called when a pointer is released, or its release goes to a context menu, another frame or another window
 */
export function whenReleased(then) {
  for (const end of ["pointerup", "pointercancel", "contextmenu"]) addEventListener(end, then, true);
  addEventListener("blur", then);
}
