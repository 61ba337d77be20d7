// When a pointer that was pressed is released.

/** @param {() => void} then a pointer was released; also where its release goes elsewhere, to a context menu, another frame or window */
export function whenReleased(then) {
  for (const end of ["pointerup", "pointercancel", "contextmenu"]) addEventListener(end, then, true);
  // That of the window: of elements, which may lose the focus while a pointer is down, it does not bubble.
  addEventListener("blur", then);
}
