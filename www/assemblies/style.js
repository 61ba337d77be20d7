// The style sheet of the assemblies. Who imports this waits until it is there.
import { addStyle } from "assur/core/dom.js";

await addStyle("assemblies/style.css");
