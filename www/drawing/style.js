// The style sheet for drawing. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("drawing/style.css");
