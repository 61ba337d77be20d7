// The style sheet of what only a synthesis needs. Who imports this waits until it is there.
import { addStyle } from "assur/core/dom.js";

await addStyle("kinds/synthesis/style.css");
