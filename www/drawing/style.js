// The style sheet of what is needed for drawing only. Who imports this waits until it is there.
import { addStyle } from "assur/core/dom.js";

await addStyle("drawing/style.css");
