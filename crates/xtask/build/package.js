// The npm package of the engine: the engine's script from the built page, the whole wasm module, types, licences and
// the files of `crates/assur-web/npm`.
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync } from "node:fs";
import path from "node:path";
import { read, replace } from "./files.js";
import { ENGINE, WHOLE } from "./site.js";

/**
 * @param {{ root: string, site: string, staging: string, to: string, version: string }} options
 */
export function pack({ root, site, staging, to, version }) {
  /** @type {Map<string, string | Buffer>} */
  const files = new Map(read(path.join(root, "crates/assur-web/npm")));
  for (const [name, content] of files) files.set(name, String(content).replaceAll("{{version}}", version));
  for (const [name, place] of [
    ["engine/assur_web.js", path.join(site, "pkg/assur_web.js")],
    ["engine/assur_web_bg.wasm", path.join(root, ENGINE, WHOLE)],
    ["LICENSE-MIT", path.join(root, "LICENSE-MIT")],
    ["LICENSE-APACHE", path.join(root, "LICENSE-APACHE")],
  ]) {
    files.set(name, readFileSync(place));
  }
  for (const [name, place] of [
    ["engine/assur_web.d.ts", path.join(ENGINE, "assur_web.d.ts")],
    ["types/edit.d.ts", "crates/assur-edit/types.d.ts"],
    ["types/file.d.ts", "crates/assur-file/types.d.ts"],
    ["types/web.d.ts", "crates/assur-web/types.d.ts"],
  ]) {
    // In the repository, modules of types are imported by bare names; in the package, by relative paths.
    files.set(name, readFileSync(path.join(root, place), "utf8").replaceAll('"assur/types/', '"../types/'));
  }
  replace(staging, files);
  mkdirSync(to, { recursive: true });
  // On Windows, npm is a shell script and needs a shell to run.
  const shell = process.platform === "win32";
  execFileSync("npm", ["pack", "--silent", "--pack-destination", to], { cwd: staging, shell, stdio: ["ignore", "ignore", "inherit"] });
}
