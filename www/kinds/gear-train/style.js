// The style sheet for differentials. Importing this module waits until the sheet is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("kinds/gear-train/style.css");
