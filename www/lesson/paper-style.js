// The style sheet of what a paper prints. Who imports this waits until it is there.
import { addStyle } from "assur/core/dom.js";

await addStyle("lesson/paper.css");
