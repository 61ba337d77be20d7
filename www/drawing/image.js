// An image that stands behind a drawing: of whatever file, as the text that states hold, and its pixels.

/**
 * @typedef {Readonly<{ text: string, pixels: HTMLCanvasElement }>} Image
 */

/** A photograph that is larger is made smaller: pixels of its longer side. Where that is not enough, these. */
const LONGEST_SIDE = 2000;
const SIDES = Object.freeze([LONGEST_SIDE, 1400, 1000, 700]);
const QUALITY = 0.85;

/** Characters that a state takes, the same as in assur-file. */
const LONGEST = 2_000_000;

/** What a state takes as it is. */
const TAKEN = /^data:image\/(png|jpeg|webp|gif|svg\+xml);base64,/;

/** Of what has no size of its own, as drawings without one. */
const SIDE = 1000;

/**
 * @param {File} file
 * @returns {Promise<Image | null>} it where it is a picture: as it is, or made smaller
 */
export async function imageOf(file) {
  try {
    const text = await address(file);
    const image = await loaded(text);
    const pixels = painted(image, LONGEST_SIDE);
    const large = Math.max(image.naturalWidth, image.naturalHeight) > LONGEST_SIDE && !text.startsWith("data:image/svg");
    const taken = TAKEN.test(text) && text.length <= LONGEST && !large ? text : photograph(image);
    return taken === undefined ? null : { text: taken, pixels };
  } catch {
    return null;
  }
}

/**
 * @param {string} text of an image
 * @returns {Promise<HTMLCanvasElement | null>} its pixels, if it is a picture
 */
export async function pixelsOf(text) {
  try {
    return painted(await loaded(text), LONGEST_SIDE);
  } catch {
    return null;
  }
}

/**
 * @param {HTMLImageElement} image
 * @returns {string | undefined} it as a photograph that a state takes
 */
function photograph(image) {
  for (const side of SIDES) {
    const text = painted(image, side, "#ffffff").toDataURL("image/jpeg", QUALITY);
    if (text.length <= LONGEST) return text;
  }
  return undefined;
}

/**
 * @param {HTMLImageElement} image
 * @param {number} longest pixels of its longer side
 * @param {string} [ground] what is behind it
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
 * @param {string} text of an image: nothing of it runs or is fetched where it is shown as a picture
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
 * @returns {Promise<string>} it as a text
 */
function address(file) {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.addEventListener("load", () => resolve(String(reader.result)));
    reader.addEventListener("error", () => reject(reader.error));
    reader.readAsDataURL(file);
  });
}
