// The style sheet of the polygons. Who imports this waits until it is there.
import { addStyle } from "assur/core/dom.js";

await addStyle("polygons/style.css");
