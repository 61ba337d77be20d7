// A drawing context that writes SVG, with only those members of a canvas context that the page and the engine use.

const NAMESPACE = "http://www.w3.org/2000/svg";

/** Significant digits of lengths: enough for a thousandth of a pixel on the largest sheet. */
const DIGITS = 7;

const ESCAPES = Object.freeze({ "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" });

const ANCHORS = Object.freeze({ left: "start", start: "start", center: "middle", right: "end", end: "end" });

/** A path that also keeps its SVG data. */
export class SvgPath extends Path2D {
  data = "";

  /**
   * @param {number} x
   * @param {number} y
   */
  moveTo(x, y) {
    this.data += `M${short(x)} ${short(y)}`;
  }

  /**
   * @param {number} x
   * @param {number} y
   */
  lineTo(x, y) {
    this.data += `L${short(x)} ${short(y)}`;
  }

  /**
   * @param {number} x of the centre
   * @param {number} y
   * @param {number} radius
   * @param {number} from start angle in radians
   * @param {number} to end angle, at most one turn after the start
   */
  arc(x, y, radius, from, to) {
    const point = (/** @type {number} */ angle) => `${short(x + radius * Math.cos(angle))} ${short(y + radius * Math.sin(angle))}`;
    // Two halves, because an SVG arc through a whole turn would have equal ends and vanish.
    const halves = [(from + to) / 2, to].map((angle) => `A${short(radius)} ${short(radius)} 0 0 1 ${point(angle)}`);
    this.data += `${this.data ? "L" : "M"}${point(from)}${halves.join("")}`;
  }

  closePath() {
    this.data += "Z";
  }
}

/** Context that writes SVG. Like the context of a canvas, it is also its own current path. */
export class Svg extends SvgPath {
  fillStyle = "#000000";
  strokeStyle = "#000000";
  globalAlpha = 1;
  lineWidth = 1;
  /** @type {CanvasLineJoin} */
  lineJoin = "miter";
  /** @type {CanvasLineCap} */
  lineCap = "butt";
  font = "10px sans-serif";
  /** @type {CanvasTextAlign} */
  textAlign = "start";
  /** @type {CanvasTextBaseline} */
  textBaseline = "alphabetic";
  /** @type {readonly number[]} */
  #dash = [];
  #transform = "";
  /** @type {string[]} */
  #elements = [];
  #size;
  #title;
  #scale;
  /** Context that measures texts and converts colours. */
  #canvas;
  /** @type {Map<string, [string, number]>} */
  #colours = new Map();

  /**
   * @param {{ readonly width: number, readonly height: number }} size
   * @param {string} title description of the picture
   * @param {number} [scale] magnification
   */
  constructor(size, title, scale = 1) {
    super();
    const canvas = new OffscreenCanvas(1, 1).getContext("2d", { willReadFrequently: true });
    if (!canvas) throw new Error("no 2d context");
    this.#canvas = canvas;
    this.#size = size;
    this.#title = title;
    this.#scale = scale;
  }

  /** @returns {string} the document */
  toString() {
    const { width, height } = this.#size;
    const [wide, high] = [width, height].map((length) => short(length * this.#scale));
    const head = attributes({ xmlns: NAMESPACE, width: wide, height: high, viewBox: `0 0 ${width} ${height}`, role: "img" });
    return `<svg${head}>\n<title>${escaped(this.#title)}</title>\n${this.#elements.join("\n")}\n</svg>\n`;
  }

  /**
   * Begins a moment of an endless animation: all that is painted up to {@link end} is visible only at this moment.
   * Programs without animation show the first moment.
   * @param {number} number of the moment, from 0
   * @param {number} count of moments
   * @param {number} seconds duration of all moments together
   */
  moment(number, count, seconds) {
    const shown = { display: number === 0 ? "inline" : "none" };
    const times = number === 0 ? [["inline", 0], ["none", 1]] : [["none", 0], ["inline", number], ["none", number + 1]];
    const within = times.filter(([, time]) => Number(time) < count);
    const motion = {
      attributeName: "display", calcMode: "discrete", dur: `${short(seconds)}s`, repeatCount: "indefinite",
      values: within.map(([value]) => value).join(";"), keyTimes: within.map(([, time]) => short(Number(time) / count)).join(";"),
    };
    this.#elements.push(`<g${attributes(shown)}><animate${attributes(motion)}/>`);
  }

  /** @param {number} strength opacity of the painting from here to {@link end} */
  faded(strength) {
    this.#elements.push(`<g${attributes({ opacity: short(strength) })}>`);
  }

  end() {
    this.#elements.push("</g>");
  }

  /**
   * @param {number} a
   * @param {number} b
   * @param {number} c
   * @param {number} d
   * @param {number} e
   * @param {number} f
   */
  setTransform(a, b, c, d, e, f) {
    const matrix = [a, b, c, d, e, f].map(short).join(" ");
    this.#transform = matrix === "1 0 0 1 0 0" ? "" : `matrix(${matrix})`;
  }

  /** @param {readonly number[]} dash */
  setLineDash(dash) {
    this.#dash = dash;
  }

  beginPath() {
    this.data = "";
  }

  /**
   * @param {SvgPath} [path]
   * @param {CanvasFillRule} [rule]
   */
  fill(path = this, rule = "nonzero") {
    this.#add("path", { d: path.data, "fill-rule": rule === "evenodd" ? rule : "", ...this.#filling() });
  }

  /** @param {SvgPath} [path] */
  stroke(path = this) {
    this.#add("path", { d: path.data, fill: "none", ...this.#line() });
  }

  /**
   * @param {number} x
   * @param {number} y
   * @param {number} width
   * @param {number} height
   */
  fillRect(x, y, width, height) {
    this.#add("rect", { x: short(x), y: short(y), width: short(width), height: short(height), ...this.#filling() });
  }

  /** @param {string} text */
  measureText(text) {
    this.#canvas.font = this.font;
    return this.#canvas.measureText(text);
  }

  /**
   * @param {string} text
   * @param {number} x
   * @param {number} y
   * @param {number} [widest] width into which a longer text is squeezed
   */
  fillText(text, x, y, widest = Infinity) {
    const squeezed = this.measureText(text).width > widest;
    /** @type {Record<string, string>} */
    const fit = squeezed ? { textLength: short(widest), lengthAdjust: "spacingAndGlyphs" } : {};
    this.#text(text, x, y, { ...this.#filling(), ...fit });
  }

  /**
   * @param {string} text
   * @param {number} x
   * @param {number} y
   */
  strokeText(text, x, y) {
    // This outline is the halo of the text that is filled next. Screen readers must not read the text twice.
    this.#text(text, x, y, { fill: "none", ...this.#line(), "aria-hidden": "true" });
  }

  /**
   * @param {string} text
   * @param {number} x
   * @param {number} y
   * @param {Readonly<Record<string, string | number>>} look
   */
  #text(text, x, y, look) {
    if (!text) return;
    const [, weight, size, family] = /^(?:(\w+) )?([\d.]+)px (.+)$/.exec(this.font) ?? ["", "", "10", "sans-serif"];
    const anchor = ANCHORS[/** @type {keyof typeof ANCHORS} */ (this.textAlign)];
    this.#add(
      "text",
      {
        x: short(x),
        y: short(y + this.#drop()),
        "font-family": family,
        "font-size": size,
        "font-weight": weight ?? "",
        "text-anchor": anchor === "start" ? "" : anchor,
        "xml:space": /^\s|\s$|\s\s/.test(text) ? "preserve" : "",
        ...look,
      },
      text,
    );
  }

  /**
   * Texts are placed by the alphabetic baseline, because it is the only one on which programs that show SVG agree.
   * @returns {number} distance of the alphabetic baseline below the baseline of the context
   */
  #drop() {
    const ascent = (/** @type {CanvasTextBaseline} */ baseline) => {
      this.#canvas.textBaseline = baseline;
      return this.measureText("").fontBoundingBoxAscent;
    };
    return ascent("alphabetic") - ascent(this.textBaseline);
  }

  #filling() {
    const [fill, alpha] = this.#colour(this.fillStyle);
    return { fill, "fill-opacity": opacity(alpha * this.globalAlpha) };
  }

  #line() {
    const [stroke, alpha] = this.#colour(this.strokeStyle);
    return {
      stroke,
      "stroke-width": short(this.lineWidth),
      "stroke-opacity": opacity(alpha * this.globalAlpha),
      "stroke-linejoin": this.lineJoin === "miter" ? "" : this.lineJoin,
      "stroke-linecap": this.lineCap === "butt" ? "" : this.lineCap,
      "stroke-dasharray": this.#dash.map(short).join(" "),
    };
  }

  /**
   * @param {string} css colour in any notation of CSS; programs other than browsers know only #rrggbb
   * @returns {[string, number]} #rrggbb and opacity
   */
  #colour(css) {
    let known = this.#colours.get(css);
    if (!known) {
      const canvas = this.#canvas;
      canvas.clearRect(0, 0, 1, 1);
      canvas.fillStyle = css;
      canvas.fillRect(0, 0, 1, 1);
      const [red, green, blue, alpha] = canvas.getImageData(0, 0, 1, 1).data;
      known = [`#${[red, green, blue].map((part) => part.toString(16).padStart(2, "0")).join("")}`, alpha / 255];
      this.#colours.set(css, known);
    }
    return known;
  }

  /**
   * @param {string} name
   * @param {Readonly<Record<string, string | number>>} look
   * @param {string} [text]
   */
  #add(name, look, text) {
    const head = name + attributes({ ...look, transform: this.#transform });
    this.#elements.push(text === undefined ? `<${head}/>` : `<${head}>${escaped(text)}</${name}>`);
  }
}

/** @param {number} value */
function short(value) {
  return String(Number(value.toPrecision(DIGITS)));
}

/** @param {number} value */
function opacity(value) {
  return value === 1 ? "" : String(Number(value.toFixed(3)));
}

/** @param {Readonly<Record<string, string | number>>} values values of attributes; empty ones are omitted */
function attributes(values) {
  const given = Object.entries(values).filter(([, value]) => value !== "");
  return given.map(([name, value]) => ` ${name}="${escaped(String(value))}"`).join("");
}

/**
 * @param {string} text
 * @returns {string} the text escaped for XML, without characters that XML forbids
 */
function escaped(text) {
  const legal = text.replace(/[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\u{10000}-\u{10ffff}]/gu, "");
  return legal.replace(/[&<>"]/g, (sign) => ESCAPES[/** @type {keyof typeof ESCAPES} */ (sign)]);
}
