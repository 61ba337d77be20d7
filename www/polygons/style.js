// The style sheet of the polygons. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("polygons/style.css");
