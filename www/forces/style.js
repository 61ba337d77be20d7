// The style sheet of the parts on forces. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("forces/style.css");
