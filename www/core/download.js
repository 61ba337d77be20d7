// Download of a file to the reader's machine.
import { byId } from "assur/core/dom.js";

let address = "";

/**
 * @param {Blob} file
 * @param {string} name
 */
export function download(file, name) {
  URL.revokeObjectURL(address);
  address = URL.createObjectURL(file);
  const link = byId("save-link", HTMLAnchorElement);
  link.href = address;
  link.download = name;
  link.click();
}
