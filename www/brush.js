// The worker of the studio: makes the calls that the page wrote down. It imports nothing, as the import map of the page does not
// hold here: what is called the page says first.

/** @type {readonly string[]} */
let methods = [];
/** @type {readonly string[]} */
let properties = [];
/** @type {Map<number, any>} contexts of the canvases, and paths, by their numbers */
const things = new Map();

addEventListener("message", ({ data }) => {
  if (data.canvas) {
    things.set(data.number, data.canvas.getContext("2d", data.settings));
    return;
  }
  try {
    if (data.methods) ({ methods, properties } = data);
    else paint(data);
  } finally {
    postMessage(null);
  }
});

/** @param {import("assur/studio.js").Painting} painting */
function paint({ made, painted, gone }) {
  for (const [number, calls] of made) things.set(number, replayed(calls, new Path2D()));
  for (const [number, calls] of painted) replayed(calls, things.get(number));
  for (const number of gone) things.delete(number);
}

/**
 * @param {import("assur/recorder.js").Calls} calls
 * @param {any} target a path or a context
 */
function replayed(calls, target) {
  for (let at = 0; at < calls.length; ) {
    const code = /** @type {number} */ (calls[at]);
    const end = at + 2 + /** @type {number} */ (calls[at + 1]);
    /** @type {any[]} */
    const given = calls.slice(at + 2, end);
    const thing = things.get(given[0]?.thing);
    if (thing) given[0] = thing.canvas ?? thing;
    at = end;
    if (code < methods.length) target[methods[code]](...given);
    else {
      const name = properties[code - methods.length];
      (name in target ? target : target.canvas)[name] = given[0];
    }
  }
  return target;
}
