// A temporary folder for one test, and the root of the repository.
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { fileURLToPath } from "node:url";
import { write } from "./files.js";

/** Path of the root of the repository. */
export const ROOT = fileURLToPath(new URL("../../..", import.meta.url));

/**
 * @param {import("node:test").TestContext} test test after which the folder is removed
 * @param {Record<string, string>} [files] contents of files by their paths in the folder
 * @returns {string} the folder
 */
export function temporary(test, files = {}) {
  const folder = mkdtempSync(path.join(tmpdir(), "assur-build-"));
  test.after(() => rmSync(folder, { recursive: true }));
  write(folder, new Map(Object.entries(files)));
  return folder;
}
