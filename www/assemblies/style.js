// The style sheet of the assemblies. Importing this module waits until it is loaded.
import { addStyle } from "assur/core/dom.js";

await addStyle("assemblies/style.css");
