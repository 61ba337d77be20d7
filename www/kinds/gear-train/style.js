// The style sheet of what only a differential needs. Who imports this waits until it is there.
import { addStyle } from "assur/core/dom.js";

await addStyle("kinds/gear-train/style.css");
