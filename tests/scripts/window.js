// The part of a browser's window that scripts need without a page: events and the classes of controls.
import { setMaxListeners } from "node:events";

/** Event class of Node, kept because a test with a document replaces the global class by that of the document. */
const { Event } = globalThis;
const view = new EventTarget();
setMaxListeners(0, view);

globalThis.addEventListener = view.addEventListener.bind(view);
globalThis.Node = class Node {};
globalThis.HTMLElement = class HTMLElement {};
globalThis.HTMLTextAreaElement = class HTMLTextAreaElement extends HTMLElement {};
globalThis.HTMLInputElement = class HTMLInputElement extends HTMLElement {
  type = "text";
};

/**
 * @param {string} type of an event
 * @param {object} [more] properties of the event, such as its target
 */
export function happen(type, more = {}) {
  const event = new Event(type, { cancelable: true });
  for (const [name, value] of Object.entries({ target: null, ...more })) Object.defineProperty(event, name, { value });
  view.dispatchEvent(event);
  return event;
}
