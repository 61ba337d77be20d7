// The style sheet of the assemblies. An import of this module waits until the style sheet is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("assemblies/style.css");
