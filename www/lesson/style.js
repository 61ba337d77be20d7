// The style sheet for writing lessons. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("lesson/style.css");
