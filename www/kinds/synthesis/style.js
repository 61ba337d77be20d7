// The style sheet for syntheses. Importing this module waits until the sheet is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("kinds/synthesis/style.css");
