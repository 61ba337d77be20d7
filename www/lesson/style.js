// The style sheet of what lecturers write. Who imports this waits until it is there.
import { addStyle } from "assur/core/dom.js";

await addStyle("lesson/style.css");
