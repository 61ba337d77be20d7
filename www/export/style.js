// The style sheet of what is printed. Who imports this waits until it is there.
import { addStyle } from "assur/core/dom.js";

await addStyle("export/print.css");
