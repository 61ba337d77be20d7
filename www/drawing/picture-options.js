// Options of the picture behind the drawing, shown with the tools while the picture tool is in use.
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { make } from "assur/core/dom.js";
import { refuse, unsay } from "assur/drawing/edit.js";

/** @typedef {keyof import("assur/drawing/picture.js").Base} Part */

/** Limits of the picture's opacity. */
const OPACITY = Object.freeze({ least: 0.1, most: 1 });

/** @type {readonly Part[]} */
const PARTS = Object.freeze(["length", "angle", "x", "y"]);

export class PictureOptions {
  #page;
  #picture;
  #file = make("input", { id: "draw-picture-file", class: "unseen", type: "file", accept: "image/*", tabindex: "-1", "aria-hidden": "true" });
  #opacity = make("input", { id: "draw-picture-opacity", type: "range", min: String(OPACITY.least), max: String(OPACITY.most), step: "0.05", "data-t-label": "draw.picture.opacity" });
  #base;
  #there;
  /** @type {{ part: Part, box: NumberBox }[]} */
  #boxes = [];

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/drawing/picture.js").BackPicture} picture
   */
  constructor(page, picture) {
    this.#page = page;
    this.#picture = picture;
    const choose = make("button", { id: "draw-picture-choose", class: "control", type: "button", "data-t": "draw.picture.choose", onclick: () => this.#file.click() });
    const remove = make("button", { id: "draw-picture-remove", class: "control", type: "button", "data-t": "draw.picture.remove", onclick: () => picture.remove() });
    this.#file.addEventListener("change", () => {
      const file = this.#file.files?.[0];
      if (file) this.take(file);
      this.#file.value = "";
    });
    this.#opacity.addEventListener("input", () => {
      picture.opacity = Number(this.#opacity.value);
    });
    const fields = PARTS.flatMap((part) => {
      const input = numberField({ id: `draw-picture-${part}`, "data-t-label": `draw.picture.${part}` });
      const box = new NumberBox(input, `draw-picture-${part}`, page.drafts, (value) => this.#lay(part, value));
      this.#boxes.push({ part, box });
      return make("label", {}, [make("span", { "data-t": `draw.picture.${part}` }), " ", input]);
    });
    this.#base = make("span", { class: "draw-base" }, fields);
    this.#there = make("span", { class: "draw-base" }, [this.#opacity, remove]);
    this.element = make("span", { id: "draw-picture-options", class: "draw-wheels" }, [choose, this.#file, this.#there, this.#base]);
  }

  /** @param {File} file to put behind the drawing */
  async take(file) {
    const { mechanism } = this.#page;
    const problem = await this.#picture.take(file, mechanism.view, mechanism.size);
    if (problem) refuse(this.#page, problem);
    else unsay(this.#page);
  }

  /**
   * @param {boolean} shown
   * @param {import("assur/core/words.js").Words} words
   */
  render(shown, { numbers }) {
    this.element.hidden = !shown;
    const { base, there, opacity } = this.#picture;
    this.#there.hidden = !there;
    this.#base.hidden = !base;
    if (document.activeElement !== this.#opacity) this.#opacity.value = String(opacity);
    this.#opacity.style.setProperty("--fill", String((opacity - OPACITY.least) / (OPACITY.most - OPACITY.least)));
    if (!base) return;
    for (const { part, box } of this.#boxes) box.show(base[part], { brief: numbers.short(base[part]), full: numbers.exact(base[part]) }, false);
  }

  /**
   * @param {Part} part
   * @param {number} value
   * @returns {number} the resulting value in the state
   */
  #lay(part, value) {
    const { base } = this.#picture;
    if (!base) return value;
    if (this.#picture.lay({ ...base, [part]: value })) {
      unsay(this.#page);
      const { bounds } = this.#picture;
      if (bounds) this.#page.mechanism.seek(bounds);
    } else refuse(this.#page, "no_length");
    return this.#picture.base?.[part] ?? value;
  }
}
