// The style sheet for drawing. An import of this module waits until the style sheet is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("drawing/style.css");
