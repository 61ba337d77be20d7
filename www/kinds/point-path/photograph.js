// A photograph behind the paper, over which a path is drawn.
import { make } from "assur/core/dom.js";
import { refuse, unsay } from "assur/drawing/edit.js";
import { BackPicture } from "assur/drawing/picture.js";

/** Limits of the opacity. */
const OPACITY = Object.freeze({ least: 0.1, most: 1 });

export class Photograph {
  #page;
  #picture;
  #file = make("input", { id: "path-photograph-file", class: "unseen", type: "file", accept: "image/*", tabindex: "-1", "aria-hidden": "true" });
  #opacity = make("input", { id: "path-photograph-opacity", type: "range", min: String(OPACITY.least), max: String(OPACITY.most), step: "0.05", "data-t-label": "path.photograph.opacity" });
  #there;
  #on = false;
  element;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#picture = new BackPicture(page);
    const choose = make("button", { id: "path-photograph", class: "control add", type: "button", "data-t": "path.photograph", onclick: () => this.#file.click() });
    const remove = make("button", { id: "path-photograph-remove", class: "control add", type: "button", "data-t": "path.photograph.remove", onclick: () => this.#picture.remove() });
    this.#file.addEventListener("change", () => {
      const file = this.#file.files?.[0];
      if (file) this.#take(file);
      this.#file.value = "";
    });
    this.#opacity.addEventListener("input", () => {
      this.#picture.opacity = Number(this.#opacity.value);
    });
    this.#there = make("div", {}, [this.#opacity, remove]);
    this.element = make("div", {}, [choose, this.#file, this.#there]);
    page.mechanism.layUnder((context, view) => {
      if (this.#on) this.#picture.paint(context, view);
    }, () => (this.#on ? this.#picture.bounds : null));
  }

  /** @param {import("assur/kinds/point-path/verdict.js").Snapshot} snapshot */
  render({ state }) {
    this.#on = state.kind === "point-path" && !state.view.drawing;
    this.#picture.follow();
    const { there, opacity } = this.#picture;
    this.#there.hidden = !there;
    if (document.activeElement !== this.#opacity) this.#opacity.value = String(opacity);
    this.#opacity.style.setProperty("--fill", String((opacity - OPACITY.least) / (OPACITY.most - OPACITY.least)));
  }

  /** @param {File} file */
  async #take(file) {
    const { mechanism } = this.#page;
    const problem = await this.#picture.take(file, mechanism.view, mechanism.size);
    if (problem) refuse(this.#page, problem);
    else unsay(this.#page);
  }
}
