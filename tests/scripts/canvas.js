// Stand-in for a canvas, without pixels: it keeps texts with their places, and measures a text by the number of its letters.

/** Width of a letter, relative to the size of the font. */
const LETTER = 0.5;

globalThis.Path2D ??= class Path2D {
  moveTo() {}
  lineTo() {}
  arc() {}
  closePath() {}
};

export class Context {
  /** @type {{ text: string, x: number, y: number, width: number, font: string, colour: string, align: string }[]} */
  texts = [];
  /** Colours in which something was filled or stroked. */
  painted = new Set();
  canvas = { width: 1, height: 1 };
  font = "10px sans-serif";
  fillStyle = "#000000";
  strokeStyle = "#000000";
  textAlign = "start";
  textBaseline = "alphabetic";
  globalAlpha = 1;
  lineWidth = 1;
  lineJoin = "miter";
  lineCap = "butt";

  setTransform() {}
  setLineDash() {}
  beginPath() {}
  closePath() {}
  moveTo() {}
  lineTo() {}
  arc() {}
  clearRect() {}
  drawImage() {}
  strokeText() {}

  fill() {
    this.painted.add(this.fillStyle);
  }

  stroke() {
    this.painted.add(this.strokeStyle);
  }

  fillRect() {
    this.fill();
  }

  measureText(text) {
    const [, size] = /([\d.]+)px/.exec(this.font);
    return { width: [...text].length * LETTER * Number(size), fontBoundingBoxAscent: 0.9 * Number(size) };
  }

  fillText(text, x, y) {
    if (text !== "") this.texts.push({ text, x, y, width: this.measureText(text).width, font: this.font, colour: this.fillStyle, align: this.textAlign });
  }
}

/**
 * Stand-in for the theme of a page: each role has a colour of its own.
 * @param {readonly string[]} roles
 */
export function themeOf(roles) {
  const colours = Object.fromEntries(roles.map((role, i) => [role, `#${(0x101010 + i * 0x070b0d).toString(16)}`]));
  const palette = roles.map((role) => [1, 3, 5].map((at) => Number.parseInt(colours[role].slice(at, at + 2), 16)));
  return { colours, inks: colours, palette, ground: "#ffffff", font: "sans-serif", scale: 1, weight: 1, revision: 1 };
}
