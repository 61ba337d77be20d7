// How quantities are spelled: φ₃′, ω₅, ẋ.

const STROKES = Object.freeze(["", "′", "″"]);
const LETTERS = Object.freeze({
  angle: Object.freeze(["φ", "ω", "ε"]),
  x: Object.freeze(["x", "ẋ", "ẍ"]),
  y: Object.freeze(["y", "ẏ", "ÿ"]),
});

/** The numbers of the links that are not called by them. */
const LINKS = Object.freeze(/** @type {Record<string, string>} */ ({ coupler: "2", rocker: "3" }));

/**
 * The symbol of a quantity or of its derivative, as φ₃′, ω₅, ẋ.
 * @param {string} name as `rocker.angle`, `C2.x`
 * @param {number} order
 * @param {boolean} physical whether derivatives are by time
 */
export function symbol(name, order, physical) {
  const [of, what] = name.split(".");
  const letters = LETTERS[/** @type {keyof typeof LETTERS} */ (what)];
  const numbered = of in LINKS || /^wheel\d+$/.test(of);
  const index = what === "angle" && numbered ? subscript(LINKS[of] ?? of.replace(/\D/g, "")) : "";
  const named = what === "angle" && !numbered ? ` ${of}` : "";
  return (physical ? letters[order] + index : letters[0] + index + STROKES[order]) + named;
}

/**
 * @param {string} text
 * @returns {string} the same with its digits written low
 */
export function subscript(text) {
  return text.replace(/\d/g, (digit) => String.fromCharCode(0x2080 + Number(digit)));
}
