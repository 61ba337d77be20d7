// Node runs the scripts of the page as they stand in `www`: their bare names `assur/…` are resolved by resolve.mjs.
import { register } from "node:module";

register("./resolve.mjs", import.meta.url);
