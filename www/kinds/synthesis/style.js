// The style sheet for syntheses. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("kinds/synthesis/style.css");
