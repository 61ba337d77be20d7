// The drawing tools as buttons over the drawing, and the prompt of the tool in use. Five tools draw most mechanisms and are always
// visible; the others are in a menu beside them.
import { numberField } from "assur/controls/number-box.js";
import { byId, make, makeSvg, write } from "assur/core/dom.js";
import { PictureOptions } from "assur/drawing/picture-options.js";
import { subscript } from "assur/core/symbols.js";
import { DYADS, TOOLS } from "assur/drawing/tools.js";
import { Seen } from "assur/core/seen.js";

/** Distance of the buttons in the corner from the edge of the drawing, in pixels. */
const CORNER = 10;

/** Tools that are always visible. */
const MAIN = Object.freeze(["select", "bars", "slide", "fix", "drive"]);

/** Icon of the menu's button, as an SVG path, while no tool of the menu is in use. */
const DOTS = "M6 12h.01M12 12h.01M18 12h.01";

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
  #menu;
  #more;
  #corner = byId("zoom-in", HTMLButtonElement);
  #shown = new Seen();

  /**
   * @param {import("assur/app/page.js").Page} page
   * @param {import("assur/drawing/tools.js").Work} work
   */
  constructor(page, work) {
    this.#page = page;
    this.#work = work;
    const [main, more] = [true, false].map((isMain) => TOOLS.filter(({ name }) => MAIN.includes(name) === isMain).map((tool) => this.#button(tool, isMain)));
    this.#menu = make("div", { id: "draw-menu", class: "draw-menu", role: "group", "data-t-label": "draw.more", hidden: "" }, more);
    this.#more = make("button", { id: "draw-more", class: "control", type: "button", "aria-pressed": "false", "aria-expanded": "false", "aria-controls": "draw-menu", onclick: () => this.#open(this.#menu.hidden !== false) }, [
      picture(DOTS), make("span", { "data-t": "draw.more" }),
    ]);
    // A press elsewhere closes the menu.
    addEventListener("pointerdown", ({ target }) => {
      if (target instanceof Node && !this.#menu.contains(target) && !this.#more.contains(target)) this.fold();
    }, true);
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
    this.element = make("div", { id: "draw-tools", class: "draw-tools" }, [
      make("div", { class: "draw-bar" }, [make("div", { class: "draw-buttons", role: "toolbar", "data-t-label": "draw.tools" }, [...main, this.#more]), this.#menu]),
      make("div", { class: "draw-options" }, [this.#dyads, this.#wheels, this.pictures.element, this.#prompt]),
    ]);
    byId("mechanism", HTMLCanvasElement).after(this.element);
    page.words.fill(this.element);
  }

  /** @returns {import("assur/stage/view.js").Insets} heights that the tools with their prompt cover at the top, and the buttons in the corner at the bottom */
  get insets() {
    const { offsetTop, offsetHeight } = this.element;
    if (offsetHeight === 0) return { top: 0, bottom: 0 };
    const corner = this.#corner.offsetHeight > 0 ? this.#corner.offsetHeight + CORNER : 0;
    return { top: offsetTop + offsetHeight, bottom: corner };
  }

  /**
   * @param {import("assur/drawing/tools.js").Tool} tool
   * @param {boolean} isMain whether the tool is always visible, and so has a short name
   */
  #button({ name, icon, key }, isMain) {
    const button = make("button", {
      id: `draw-${name}`, class: "control", type: "button", "aria-pressed": "false", "aria-keyshortcuts": `Alt+${key}`, "data-t-title": `draw.tool.${name}`,
    }, [picture(icon), make("span", { "data-t": `draw.${isMain ? "short" : "tool"}.${name}` })]);
    button.addEventListener("click", () => {
      this.take(name);
      if (this.fold()) this.#more.focus();
      this.#page.redraw();
    });
    this.#buttons.set(name, button);
    return button;
  }

  /** @param {boolean} open whether the menu is to be open */
  #open(open) {
    this.#menu.hidden = !open;
    this.#more.setAttribute("aria-expanded", String(open));
  }

  /** @returns {boolean} whether the menu was open, and is closed now */
  fold() {
    const open = !this.#menu.hidden;
    this.#open(false);
    return open;
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
    // The button of the menu shows the tool in use if that tool is in the menu.
    const inMenu = TOOLS.find(({ name }) => name === tool && !MAIN.includes(name));
    this.#more.setAttribute("aria-pressed", String(inMenu !== undefined));
    // On a narrow page, it shows only the icon of that tool.
    const texts = inMenu ? [make("span", { class: "draw-wide" }, [words.text(`draw.tool.${inMenu.name}`)]), make("span", { class: "draw-narrow" }, [words.text("draw.more")])] : [make("span", {}, [words.text("draw.more")])];
    this.#more.replaceChildren(picture(inMenu?.icon ?? DOTS), ...texts);
    this.#dyads.hidden = tool !== "dyad";
    this.#wheels.hidden = tool !== "mesh";
    const prompts = TOOLS.find(({ name }) => name === tool)?.prompts ?? [];
    const prompt = tool === "dyad" ? prompts.find((name) => name.endsWith(dyad[2 * pressed.length])) : prompts[stage];
    write(this.#prompt, prompt ? words.text(`draw.prompt.${prompt}`) : "");
  }
}

/** @param {string} d */
function picture(d) {
  return makeSvg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, [makeSvg("path", { d })]);
}
