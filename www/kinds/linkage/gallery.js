// The gallery: the mixer and the linkages of the catalogue, one to be chosen. Loaded when it is asked for.
import { byId, make } from "assur/core/dom.js";
import "assur/kinds/linkage/style.js";

/**
 * Shows the dialog in the language of the words.
 * @param {import("assur/app/page.js").Page} page
 */
export function openGallery(page) {
  const { engine, words, store } = page;
  document.getElementById("gallery-dialog")?.remove();
  const state = store.get();
  const current = engine.presetOf(state)?.id;
  const entry = (/** @type {string} */ id, /** @type {string} */ key, /** @type {() => void} */ open) => {
    const button = make("button", { id: `gallery-${id}`, class: "segment", "aria-pressed": String(id === current), "data-t": key });
    if (id === current) button.autofocus = true;
    button.addEventListener("click", open);
    return button;
  };
  const dialog = make("dialog", { id: "gallery-dialog", class: "dialog", "aria-labelledby": "gallery-title" }, [
    make("form", { method: "dialog" }, [
      make("h2", { id: "gallery-title", "data-t": "gallery.heading" }),
      make("div", { class: "gallery" }, [
        ...engine.catalogue.map(({ id, kind, document }) => entry(id, `gallery.${id}`, () => page.choose(kind, document))),
      ]),
      make("button", { id: "gallery-close", class: "control", "data-t": "dialog.close" }),
    ]),
  ]);
  words.fill(dialog);
  byId("app", HTMLElement).append(dialog);
  dialog.addEventListener("close", () => dialog.remove());
  dialog.showModal();
}
