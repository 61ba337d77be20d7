// Changes of masses and loads: ordinary changes of the document, which the engine accepts or refuses like those of other fields.
import { attempt } from "assur/core/problem.js";
import { edited, withMechanism } from "assur/state/state.js";

/**
 * @typedef {import("assur/app/page.js").Page} Page
 * @typedef {import("assur/state/state.js").LinkageDocument} Document
 */

/**
 * @param {Page} page
 * @returns {Document} the linkage of the page
 */
export function linkageOf({ store }) {
  return /** @type {Document} */ (store.get().document);
}

/**
 * @param {Page} page
 * @param {(document: Document) => Partial<Document>} fields
 */
export function put({ store }, fields) {
  store.update((state) => edited(state, "linkage", fields));
}

/**
 * @param {Page} page
 * @param {number} index of a link
 * @param {Partial<Document["links"][number]>} change; an undefined field is removed
 */
export function putLink(page, index, change) {
  put(page, ({ links }) => ({ links: links.map((link, k) => (k === index ? without({ ...link, ...change }) : link)) }));
}

/**
 * @template {"loads" | "springs" | "dampers" | "friction"} L
 * @param {Page} page
 * @param {L} list
 * @param {(entries: NonNullable<Document[L]>) => NonNullable<Document[L]>} change
 */
export function putList(page, list, change) {
  put(page, (document) => ({ [list]: change(/** @type {NonNullable<Document[L]>} */ (document[list] ?? [])) }));
}

/**
 * @template {object} T
 * @param {T} value
 * @returns {T} without undefined fields
 */
export function without(value) {
  return /** @type {T} */ (Object.fromEntries(Object.entries(value).filter(([, part]) => part !== undefined)));
}

/**
 * Asks the engine for an edit of the drawn linkage, without opening the tools for drawing.
 * @param {Page} page
 * @param {import("assur/types/edit.js").Edit} wanted
 * @param {string} field that shows the reason for a refusal
 * @returns {boolean} whether the edit was made
 */
export function reshape(page, wanted, field) {
  const refusal = tried(page, wanted);
  if (refusal.length > 0) page.drafts.keep(field, refusal);
  else page.drafts.drop(field);
  return refusal.length === 0;
}

/**
 * @param {Page} page
 * @param {import("assur/types/edit.js").Edit} wanted
 * @returns {readonly import("assur/core/problem.js").Problem[]} reasons why the edit is refused; empty if it was made
 */
export function tried({ engine, store, model }, wanted) {
  model.follow(store.get());
  const { value: drawn, problems } = attempt(() => engine.simulator.edit(wanted, model.home));
  if (drawn) store.update((state) => withMechanism(state, drawn.kind, drawn.document));
  return problems;
}
