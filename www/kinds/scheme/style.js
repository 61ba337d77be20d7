// The style sheet for schemes. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("kinds/scheme/style.css");
