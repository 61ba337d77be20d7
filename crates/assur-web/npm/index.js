// Entry for Node.js. The engine is ready after the import.
import { readFile } from "node:fs/promises";
import init from "./engine/assur_web.js";

await init({ module_or_path: await readFile(new URL("./engine/assur_web_bg.wasm", import.meta.url)) });

export * from "./engine/assur_web.js";
export { Mechanism } from "./mechanism.js";
