// Copying the URL of a state; opening and saving files.
import { byId } from "assur/core/dom.js";
import { download } from "assur/core/download.js";
import { toFile } from "assur/state/codec.js";

/** @typedef {import("assur/state/state.js").State} State */

/**
 * Shows the URL of a state in the address bar and copies it. If it cannot be copied, a dialog shows it to be copied by hand.
 * @param {State} state
 * @param {import("assur/state/address.js").Address} address
 * @returns {Promise<{ link: string, copied: boolean }>} the URL, and whether it is in the clipboard
 */
export async function copyLink(state, address) {
  const link = address.link(state);
  address.show(state);
  try {
    await navigator.clipboard.writeText(link);
    return { link, copied: true };
  } catch {
    // Browsers may forbid writing to the clipboard.
    const field = byId("link-text", HTMLInputElement);
    field.value = link;
    byId("link", HTMLDialogElement).showModal();
    field.select();
    return { link, copied: false };
  }
}

/**
 * @param {State} state
 * @param {string} name of the file, without extension
 */
export function saveFile(state, name) {
  download(new Blob([toFile(state)], { type: "application/json" }), `${name}.assur.json`);
}

/**
 * @param {(file: File) => void} opened takes the chosen file
 * @returns {() => void} opens the file picker
 */
export function filePicker(opened) {
  const input = byId("file", HTMLInputElement);
  input.addEventListener("change", () => {
    const file = input.files?.[0];
    if (!file) return;
    input.value = "";
    opened(file);
  });
  return () => input.click();
}
