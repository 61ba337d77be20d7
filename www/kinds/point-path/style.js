// The style sheet for paths. Importing this module waits until the sheet is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("kinds/point-path/style.css");
