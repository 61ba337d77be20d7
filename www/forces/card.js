// A card of a list: an entry with its fields, the reason why it is refused, and a button that removes it.
import { make, write } from "assur/core/dom.js";

/**
 * @param {Readonly<{ list: string, i: number, title: string }>} entry the name of its list, its index there, and its title
 * @param {readonly HTMLElement[]} content
 * @param {import("assur/forces/fields.js").Fields} fields
 * @param {() => void} remove
 */
export function card({ list, i, title }, content, fields, remove) {
  const id = `${list}-${i}`;
  return make("details", { id, class: "fold within" }, [
    make("summary", {}, [`${i + 1}. ${title}`]), ...content, make("p", { id: `${id}-why`, class: "forces-why" }), fields.button(`${id}-remove`, "forces.remove", remove),
  ]);
}

/**
 * Writes the reasons why entries of a list are refused.
 * @param {HTMLElement} element of the list
 * @param {string} list
 * @param {number} count of its entries
 * @param {(index: number) => string} reason empty if an entry is not refused
 */
export function writeReasons(element, list, count, reason) {
  for (let i = 0; i < count; i++) {
    const why = element.querySelector(`#${list}-${i}-why`);
    if (why) write(why, reason(i));
  }
}
