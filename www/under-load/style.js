// The style sheet of the motion under load. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("under-load/style.css");
