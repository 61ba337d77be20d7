// The style sheet for linkages. Importing this module waits until the sheet is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("kinds/linkage/style.css");
