// Writing of a read-out into the page.
import { make, setData, write } from "assur/core/dom.js";

/**
 * @param {HTMLElement} output
 * @param {Pick<import("assur/controls/shown.js").Cell, "text" | "value" | "asked">} cell
 */
export function writeReadout(output, { text, value, asked }) {
  if (asked !== undefined && output.dataset.asked === asked) return;
  if (asked !== undefined) {
    output.dataset.asked = asked;
    output.replaceChildren(text, make("span", { class: "unseen" }, [` ${asked}`]));
  } else {
    delete output.dataset.asked;
    if (output.childElementCount === 0) write(output, text);
    else output.replaceChildren(text);
  }
  if (value === undefined) delete output.dataset.value;
  else setData(output, "value", String(value));
}
