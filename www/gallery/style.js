// The style sheet of the gallery. Who imports this waits until it is there.
import { addStyle } from "assur/core/dom.js";

await addStyle("gallery/style.css");
