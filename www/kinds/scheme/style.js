// The style sheet for schemes. Importing this module waits until the sheet is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("kinds/scheme/style.css");
