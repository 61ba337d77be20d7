// Entry for browsers and bundlers. The engine is fetched from the folder of its script, and is ready after the import.
import init from "./engine/assur_web.js";

await init();

export * from "./engine/assur_web.js";
export { Mechanism } from "./mechanism.js";
