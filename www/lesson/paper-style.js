// The style sheet for items of a paper. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("lesson/paper.css");
