// For Node.js: the engine is ready when this module is.
import { readFile } from "node:fs/promises";
import init from "./engine/assur_web.js";

await init({ module_or_path: await readFile(new URL("./engine/assur_web_bg.wasm", import.meta.url)) });

export * from "./engine/assur_web.js";
export { Mechanism } from "./mechanism.js";
