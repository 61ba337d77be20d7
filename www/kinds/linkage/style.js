// The style sheet of what only a linkage needs. Who imports this waits until it is there.
import { make } from "assur/core/dom.js";

const sheet = make("link", { rel: "stylesheet", href: import.meta.resolve("assur/kinds/linkage/style.css") });
await new Promise((resolve) => {
  // Without it everything still works.
  sheet.onload = sheet.onerror = resolve;
  document.head.append(sheet);
});
