// The style sheet of the gallery. Importing this module waits until the sheet is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("gallery/style.css");
