// When a pointer that was pressed is released.

/**
 * The window's own `blur` counts as well: that of an element, which may lose the focus while a pointer is down, does not bubble to it.
 * @param {() => void} then called when a pointer is released, or its release goes to a context menu, another frame or another window
 */
export function whenReleased(then) {
  for (const end of ["pointerup", "pointercancel", "contextmenu"]) addEventListener(end, then, true);
  addEventListener("blur", then);
}
