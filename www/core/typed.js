// Elements that take typed text.

/**
 * @param {EventTarget | null} target
 * @returns {boolean} whether the target takes text
 */
export function isTyped(target) {
  if (target instanceof HTMLInputElement) return !["range", "radio", "checkbox", "button"].includes(target.type);
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}
