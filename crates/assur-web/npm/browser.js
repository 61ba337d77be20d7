// For browsers and bundlers: the engine is fetched from beside its script, and ready when this module is.
import init from "./engine/assur_web.js";

await init();

export * from "./engine/assur_web.js";
export { Mechanism } from "./mechanism.js";
