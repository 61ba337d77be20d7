// The style sheet of the force plans. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("force-plan/style.css");
