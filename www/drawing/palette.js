// The drawing tools as buttons over the drawing, and the prompt of the tool in use.
import { numberField } from "assur/controls/number-box.js";
import { byId, make, makeSvg, write } from "assur/core/dom.js";
import { PictureOptions } from "assur/drawing/picture-options.js";
import { subscript } from "assur/core/symbols.js";
import { DYADS, TOOLS } from "assur/drawing/tools.js";
import { Seen } from "assur/core/seen.js";

export class Palette {
  #page;
  #work;
  /** @type {Map<string, HTMLButtonElement>} */
  #buttons = new Map();
  #prompt = make("p", { id: "draw-prompt", role: "status" });
  #dyads = make("select", { id: "draw-dyad-kind", class: "control", "data-t-label": "draw.dyad.kind" }, DYADS.map((value) => make("option", { value }, [value])));
  #teeth = [0, 1].map((k) => numberField({ id: `draw-teeth-${k + 1}`, inputmode: "numeric", "data-t-label": "draw.teeth", "data-t-title": "draw.teeth", "data-n": String(k + 1) }));
  #internal = make("input", { id: "draw-internal", type: "checkbox" });
  #wheels;
  #row;
  #shown = new Seen();

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/drawing/tools.js").Work} work
   */
  constructor(page, work) {
    this.#page = page;
    this.#work = work;
    const buttons = TOOLS.map(({ name, icon, key }) => {
      const svg = makeSvg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, [makeSvg("path", { d: icon })]);
      const button = make("button", {
        id: `draw-${name}`, class: "control", type: "button", "aria-pressed": "false", "aria-keyshortcuts": `Alt+${key}`,
        "data-t-label": `draw.tool.${name}`, "data-t-title": `draw.tool.${name}`,
      }, [svg]);
      button.addEventListener("click", () => {
        this.take(name);
        page.redraw();
      });
      this.#buttons.set(name, button);
      return button;
    });
    this.#dyads.addEventListener("change", () => {
      work.dyad = this.#dyads.value;
      work.rest();
      page.redraw();
    });
    this.#teeth.forEach((input, k) => {
      input.value = String(work.teeth[k]);
      input.addEventListener("input", () => {
        const teeth = Number(input.value);
        const valid = Number.isInteger(teeth) && teeth >= 3;
        input.setAttribute("aria-invalid", String(!valid));
        if (valid) work.teeth[k] = teeth;
      });
    });
    this.#internal.addEventListener("change", () => {
      work.internal = this.#internal.checked;
    });
    this.#wheels = make("span", { class: "draw-wheels" }, [
      ...this.#teeth.map((input, k) => make("label", { for: input.id }, [`z${subscript(String(k + 1))} `, input])),
      make("label", { class: "check" }, [this.#internal, " ", make("span", { "data-t": "draw.internal" })]),
    ]);
    this.pictures = new PictureOptions(page, work.picture);
    this.#row = make("div", { class: "draw-buttons", role: "toolbar", "data-t-label": "draw.tools" }, buttons);
    this.element = make("div", { id: "draw-tools", class: "draw-tools" }, [
      this.#row,
      make("div", { class: "draw-options" }, [this.#dyads, this.#wheels, this.pictures.element, this.#prompt]),
    ]);
    byId("mechanism", HTMLCanvasElement).after(this.element);
    page.words.fill(this.element);
  }

  /** Height of the part at the top of the drawing that the buttons cover, in pixels. */
  get height() {
    return this.#row.offsetTop + this.#row.offsetHeight;
  }

  /** @param {string} name of the tool to use */
  take(name) {
    this.#work.take(name);
    this.#shown = new Seen();
  }

  /**
   * @param {KeyboardEvent} event
   * @returns {boolean} whether the key chose a tool
   */
  byKey({ code }) {
    const tool = TOOLS.find(({ key }) => code === `Key${key}` || code === `Digit${key}`);
    if (tool) this.take(tool.name);
    this.#page.redraw();
    return tool !== undefined;
  }

  /** @param {import("assur/state/model.js").AnySnapshot} snapshot */
  render({ words, state }) {
    const { tool, pressed, dyad, stage } = this.#work;
    this.pictures.render(tool === "picture", words);
    if (this.#shown.same(words, tool, stage, dyad, state.document)) return;
    for (const [name, button] of this.#buttons) button.setAttribute("aria-pressed", String(name === tool));
    this.#dyads.hidden = tool !== "dyad";
    this.#wheels.hidden = tool !== "mesh";
    const prompts = TOOLS.find(({ name }) => name === tool)?.prompts ?? [];
    const prompt = tool === "dyad" ? prompts.find((name) => name.endsWith(dyad[2 * pressed.length])) : prompts[stage];
    write(this.#prompt, prompt ? words.text(`draw.prompt.${prompt}`) : "");
  }
}
