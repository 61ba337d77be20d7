// Colours of the roles (crank, coupler, …), and sizes of text and lines, as the style sheet sets them for light pages,
// dark pages or projectors.

/** @typedef {Readonly<Record<string, string>>} Colours */

/** Media queries on which the style sheet depends. */
const WATCHED = Object.freeze(["(prefers-color-scheme: dark)", "(min-width: 640px)", "(min-width: 1200px)", "(min-width: 1600px)"]);

/** Size of the page's text on most screens, in pixels. */
const USUAL_SIZE = 14;

export class Theme {
  #element;
  /** @type {readonly string[]} */
  #roles;
  /** @type {Colours} colour by role */
  colours = {};
  /** @type {[number, number, number][]} red, green and blue of each role's colour, in the order of the roles */
  palette = [];
  /** @type {Colours} colours by role for small text: darker on light paper, lighter on dark paper */
  inks = {};
  /** The colour of the paper under the drawing. */
  ground = "";
  font = "sans-serif";
  /** Size of text relative to the usual size; larger on large screens. */
  scale = 1;
  /** Thickness of lines relative to the usual one. */
  weight = 1;
  /** Number of times the colours and sizes have been read. */
  revision = 0;

  /**
   * @param {readonly string[]} roles
   * @param {() => void} changed
   * @param {Element} [element] element whose style gives the colours and the size of text
   */
  constructor(roles, changed, element = document.documentElement) {
    this.#element = element;
    this.#roles = roles;
    this.#read();
    for (const query of WATCHED) {
      matchMedia(query).addEventListener("change", () => {
        this.#read();
        changed();
      });
    }
  }

  /** @param {boolean} on whether the page is for a projector, with large text, thick lines and high contrast */
  project(on) {
    const root = document.documentElement;
    if (root.dataset.projector === String(on)) return;
    root.dataset.projector = String(on);
    this.#read();
  }

  #read() {
    const style = getComputedStyle(this.#element);
    const context = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
    /** @type {Record<string, string>} */
    const colours = {};
    this.palette = this.#roles.map((role) => {
      colours[role] = style.getPropertyValue(`--role-${role}`).trim();
      if (!context) return [0, 0, 0];
      context.fillStyle = colours[role];
      context.fillRect(0, 0, 1, 1);
      const [red, green, blue] = context.getImageData(0, 0, 1, 1).data;
      return [red, green, blue];
    });
    this.colours = colours;
    this.ground = style.getPropertyValue("--ground").trim();
    this.inks = Object.fromEntries(this.#roles.map((role) => [role, mixed(colours[role], colours.ink)]));
    this.revision += 1;
    this.font = style.fontFamily;
    this.weight = Number(style.getPropertyValue("--weight"));
    this.scale = Number.parseFloat(style.fontSize) / USUAL_SIZE;
  }
}

/**
 * @param {string} colour
 * @param {string} ink
 */
function mixed(colour, ink) {
  return `color-mix(in srgb, ${colour} 62%, ${ink})`;
}
