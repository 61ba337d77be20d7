// An image behind a drawing, read from a file: as text for the state, and as pixels for painting.

/** @typedef {Readonly<{ text: string, pixels: HTMLCanvasElement }>} Image */

/** Longest side of an image that keeps its size, in pixels. */
const MAX_SIDE = 2000;
/** Lengths tried for the longer side of any other image, in pixels, until the text of the image is short enough. */
const SIDES = Object.freeze([MAX_SIDE, 1400, 1000, 700]);
const QUALITY = 0.85;

/** Greatest length of an image's text in a state, in characters; the same as in assur-file. */
const MAX_TEXT = 2_000_000;

/** Text of an image of a type that a state takes without conversion. */
const TAKEN = /^data:image\/(png|jpeg|webp|gif|svg\+xml);base64,/;

/** Side given to an image that has no size of its own (some vector drawings), in pixels. */
const SIDE = 1000;

/**
 * @param {File} file
 * @returns {Promise<Image | null>} the image, converted and made smaller if need be; null if the file is no
 * image, or if the image is too long for a state at every size
 */
export async function imageOf(file) {
  try {
    const text = await address(file);
    const image = await loaded(text);
    const pixels = painted(image, MAX_SIDE);
    const large = Math.max(image.naturalWidth, image.naturalHeight) > MAX_SIDE && !text.startsWith("data:image/svg");
    const taken = TAKEN.test(text) && text.length <= MAX_TEXT && !large ? text : photograph(image);
    return taken === undefined ? null : { text: taken, pixels };
  } catch {
    return null;
  }
}

/**
 * @param {string} text of an image
 * @returns {Promise<HTMLCanvasElement | null>} pixels of the image; null if the text is no image
 */
export async function pixelsOf(text) {
  try {
    return painted(await loaded(text), MAX_SIDE);
  } catch {
    return null;
  }
}

/**
 * @param {HTMLImageElement} image
 * @returns {string | undefined} the image as a JPEG short enough for a state; undefined if it is too long at every size
 */
function photograph(image) {
  for (const side of SIDES) {
    const text = painted(image, side, "#ffffff").toDataURL("image/jpeg", QUALITY);
    if (text.length <= MAX_TEXT) return text;
  }
  return undefined;
}

/**
 * @param {HTMLImageElement} image
 * @param {number} longest greatest length of the longer side, in pixels
 * @param {string} [ground] colour behind the image
 * @returns {HTMLCanvasElement}
 */
function painted(image, longest, ground) {
  const [width, height] = [image.naturalWidth || SIDE, image.naturalHeight || SIDE];
  const shrunk = Math.min(1, longest / Math.max(width, height));
  const canvas = document.createElement("canvas");
  canvas.width = Math.max(1, Math.round(width * shrunk));
  canvas.height = Math.max(1, Math.round(height * shrunk));
  const context = canvas.getContext("2d");
  if (!context) throw new Error("no canvas");
  if (ground) {
    context.fillStyle = ground;
    context.fillRect(0, 0, canvas.width, canvas.height);
  }
  context.drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas;
}

/**
 * @param {string} text of an image; in an image element, scripts and links inside the image have no effect
 * @returns {Promise<HTMLImageElement>}
 */
async function loaded(text) {
  const image = new Image();
  image.src = text;
  await image.decode();
  return image;
}

/**
 * @param {File} file
 * @returns {Promise<string>} the file as a data URL
 */
function address(file) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener("load", () => resolve(String(reader.result)));
    reader.addEventListener("error", () => reject(reader.error));
    reader.readAsDataURL(file);
  });
}
