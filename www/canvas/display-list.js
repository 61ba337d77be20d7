// Conversion of the engine's flat display lists into shapes and labels for a canvas.

/**
 * @typedef {Float32Array | Float64Array} List of numbers, as the engine returns it
 * @typedef {{ record: List, role: string, look: number, path: Path2D, loops?: List[] }} Shape
 * `record`: the numbers of the shape in the list. `loops`: the corners of each polygon, for a shape of polygons.
 * @typedef {{ role: string, label: string, x: number, y: number, dx: number, dy: number }} Label
 * @typedef {{ body: number, shapes: Shape[], labels: Label[] }} Layer
 */

const BODY = 0;
const POLYGONS = 1;
const POLYLINE = 2;
const CIRCLE = 3;
const TEXT = 4;

/**
 * @param {List} list
 * @param {number} start index in the array at which the list begins
 * @param {readonly string[]} roles
 * @param {readonly string[]} labels
 * @param {() => Path2D} newPath an empty path
 * @param {readonly Layer[]} [before] layers read from an earlier list with the same roles and kind of path; unchanged
 * shapes are taken from them, with their paths
 * @returns {Layer[]} in the order of painting
 */
export function readDisplayList(list, start, roles, labels, newPath, before = []) {
  const known = before.flatMap(({ shapes }) => shapes);
  let count = 0;
  /** @type {Layer} */
  let layer = { body: 0, shapes: [], labels: [] };
  const layers = [layer];
  let at = start;
  while (at < list.length) {
    const kind = list[at];
    if (kind === BODY) {
      layer = { body: list[at + 1], shapes: [], labels: [] };
      layers.push(layer);
      at += 2;
    } else if (kind === TEXT) {
      const [role, label, x, y, dx, dy] = list.subarray(at + 1, at + 7);
      layer.labels.push({ role: roles[role], label: labels[label], x, y, dx, dy });
      at += 7;
    } else if (kind === POLYGONS || kind === POLYLINE || kind === CIRCLE) {
      const old = known[count];
      const shape = old && stands(old.record, list, at) ? old : readShape(list, at, roles, newPath);
      layer.shapes.push(shape);
      at += shape.record.length;
      count += 1;
    } else {
      throw new Error(`display list: no record ${kind}`);
    }
  }
  return layers;
}

/**
 * @param {List} record
 * @returns {number[][]} bounds of a circle, as one array xmin, ymin, xmax, ymax; an empty array for another shape
 */
export function circleBounds(record) {
  if (record[0] !== CIRCLE) return [];
  const [x, y, radius] = record.subarray(3, 6);
  return [[x - radius, y - radius, x + radius, y + radius]];
}

/**
 * @param {List} record earlier record; as a record contains its own length, comparing its values is enough
 * @param {List} list
 * @param {number} at
 * @returns {boolean} whether the list has the same record at that index
 */
function stands(record, list, at) {
  return record.every((value, i) => value === list[at + i]);
}

/**
 * @param {List} list
 * @param {number} at
 * @param {readonly string[]} roles
 * @param {() => Path2D} newPath
 * @returns {Shape}
 */
function readShape(list, at, roles, newPath) {
  const path = newPath();
  /** @type {Shape} */
  const shape = { record: list, role: roles[list[at + 1]], look: list[at + 2], path };
  let end = at + 6;
  if (list[at] === POLYGONS) end = addPolygons(shape, list, at + 3);
  else if (list[at] === POLYLINE) end = addPoints(path, list, at + 3);
  else {
    path.arc(list[at + 3], list[at + 4], list[at + 5], 0, 2 * Math.PI);
    path.closePath();
  }
  shape.record = list.subarray(at, end);
  return shape;
}

/**
 * @param {Shape} shape
 * @param {List} list
 * @param {number} at
 * @returns {number} index of the next record
 */
function addPolygons(shape, list, at) {
  const count = list[at];
  at += 1;
  shape.loops = [];
  for (let loop = 0; loop < count; loop++) {
    const end = addPoints(shape.path, list, at);
    shape.path.closePath();
    shape.loops.push(list.subarray(at + 1, end));
    at = end;
  }
  return at;
}

/**
 * @param {Path2D} path
 * @param {List} list
 * @param {number} at
 */
function addPoints(path, list, at) {
  const points = list[at];
  const end = at + 1 + 2 * points;
  for (let i = at + 1; i < end; i += 2) {
    if (i === at + 1) path.moveTo(list[i], list[i + 1]);
    else path.lineTo(list[i], list[i + 1]);
  }
  return end;
}
