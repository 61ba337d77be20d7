// The style sheet for print. Importing this module waits until the sheet is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("export/print.css");
