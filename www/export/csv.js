// The table of a sweep as CSV. Each number has the fewest digits that read back as exactly the same number.
import { degrees } from "assur/core/angles.js";
import { called } from "assur/core/names.js";
import { parseNumber } from "assur/core/numbers.js";
import { calledWhole, isLength } from "assur/core/symbols.js";

/**
 * @typedef {import("assur/types/web.js").SweepTable} SweepTable
 * @typedef {import("assur/state/coordinate.js").Coordinate} Coordinate
 * @typedef {SweepTable["columns"][number]} Column
 * @typedef {import("assur/core/words.js").Words} Words
 */

/**
 * Choices for a table.
 * @typedef {object} Choices
 * @property {boolean} comma whether 0,5 is written for 0.5, with a semicolon between cells
 * @property {boolean} degrees whether angles are in degrees instead of radians; derivatives are always in radians and with respect to radians
 * @property {boolean} worded whether columns have headings in words instead of the short names of the command line
 * @property {boolean} dimensions whether the file begins with the dimensions of the linkage, as comments
 */

/** Keys of column headings in words, by kind of quantity and by order of the derivative. */
const COLUMNS = Object.freeze({
  angle: Object.freeze(["export.column.angle", "export.column.omega", "export.column.epsilon"]),
  x: Object.freeze(["export.column.x", "export.column.vx", "export.column.ax"]),
  y: Object.freeze(["export.column.y", "export.column.vy", "export.column.ay"]),
  distance: Object.freeze(["export.column.distance", "export.column.distance_v", "export.column.distance_a"]),
  corner: Object.freeze(["export.column.corner", "export.column.corner_v", "export.column.corner_a"]),
  between: Object.freeze(["export.column.between", "export.column.between_v", "export.column.between_a"]),
  transmission: Object.freeze(["export.column.transmission", "export.column.transmission_v", "export.column.transmission_a"]),
  pressure: Object.freeze(["export.column.pressure", "export.column.pressure_v", "export.column.pressure_a"]),
  radius: Object.freeze(["export.column.radius", "export.column.radius_v", "export.column.radius_a"]),
  centre_x: Object.freeze(["export.column.centre_x"]),
  centre_y: Object.freeze(["export.column.centre_y"]),
});

/** Prefix of the column headings and dimensions of the compared mechanism, Ⓐ. */
const OF_A = "Ⓐ: ";

/** Significant digits of a dimension. They exclude the rounding errors of lengths computed from coordinates. */
const DIGITS = 12;

const DIMENSIONS = Object.freeze({ length: "export.dimension.length", x: "export.dimension.x", y: "export.dimension.y" });

/**
 * Writes the table of the mechanism, with the columns of the compared mechanism to its right.
 * @param {SweepTable} table
 * @param {Coordinate} coordinate unit and range of the input
 * @param {Choices} choices
 * @param {Words} words
 */
export function toCsv(table, coordinate, choices, words) {
  const separator = choices.comma ? ";" : ",";
  const number = (/** @type {number} */ value) => (choices.comma ? `${value}`.replace(".", ",") : `${value}`);
  const line = (/** @type {readonly string[]} */ cells) => lineOf(cells, separator);
  const tables = [{ of: "", ...table }, ...(table.compared ? [{ of: OF_A, ...table.compared }] : [])];
  const comments = tables.flatMap(({ of, dimensions }) => dimensions.map((dimension) => {
    const value = words.length(number(Number(dimension.value.toPrecision(DIGITS))));
    return `# ${of}${oneLine(words.text(DIMENSIONS[dimension.kind], { of: dimension.of, value }))}\n`;
  }));
  const heads = tables.flatMap(({ of, columns }) => [...columns.map((column) => named(column, coordinate, choices, words)), "reason"].map((name) => of + name));
  const scales = tables.map(({ columns }) => columns.map(({ quantity }) => (quantity && writtenInDegrees(quantity, choices) ? degrees(1) : 1)));
  const lines = table.rows.map(({ input }, row) => {
    const cells = tables.flatMap(({ rows }, of) => {
      const { values, reason } = rows[row];
      return [...values.map((value, column) => (value === null ? "" : number(value * scales[of][column]))), reason?.code ?? ""];
    });
    return line([number(input), ...cells]);
  });
  return fileOf([...(choices.dimensions ? comments : []), line([inputName(coordinate, words), ...heads]), ...lines]);
}

/**
 * @param {readonly (readonly string[])[]} rows
 * @param {Words} words
 * @returns {Blob} the rows in the form that a spreadsheet in the language of the words reads
 */
export function rowsAsCsv(rows, { numbers }) {
  return fileOf(rows.map((cells) => lineOf(cells, numbers.comma ? ";" : ",")));
}

/**
 * @param {readonly string[]} cells
 * @param {string} separator
 */
function lineOf(cells, separator) {
  return `${cells.map((cell) => quoted(cell, separator)).join(separator)}\n`;
}

/** @param {readonly string[]} lines */
function fileOf(lines) {
  const text = lines.join("");
  // A byte order mark announces UTF-8: without it, a spreadsheet misreads letters beyond ASCII.
  const mark = /[^\0-\x7f]/.test(text) ? "\ufeff" : "";
  return new Blob([mark, text], { type: "text/csv" });
}

/**
 * @param {Column} column
 * @param {Coordinate} coordinate
 * @param {Choices} choices
 * @param {Words} words
 * @returns {string} heading of the column, with its unit
 */
function named({ name, quantity }, { moves }, choices, words) {
  if (!quantity) return name;
  const { kind, of, order } = quantity;
  const { worded } = choices;
  const inDegrees = writtenInDegrees(quantity, choices);
  if (worded) {
    const angle = words.text(inDegrees ? "unit.deg" : "unit.rad");
    const length = words.unit || words.text("unit.length");
    const unit = isLength(kind) ? length : angle;
    const power = order > 1 ? "²" : "";
    const per = order > 0 ? `/${moves === "angle" ? angle : length}${power}` : "";
    const said = kind.endsWith("angle") ? called(of, words) : kind === "between" ? calledWhole(of, kind, words) : of;
    return words.text(COLUMNS[kind][order], { of: said, unit: `${unit}${per}` });
  }
  const angle = inDegrees ? "deg" : "rad";
  const length = lengthName(words);
  const unit = isLength(kind) ? length : angle;
  const by = moves === "angle" ? angle : length;
  const power = order > 1 ? `${order}` : "";
  const per = order > 0 ? `_per_${by}${power}` : "";
  return `${name}_${unit}${per}`;
}

/**
 * @param {Words} words
 * @returns {string} unit of length in a short column name
 */
function lengthName({ lengths }) {
  return lengths === "none" ? "length" : lengths;
}

/**
 * @param {Coordinate} coordinate
 * @param {Words} words
 */
function inputName({ viewKey, moves }, words) {
  const units = { angle: "", length: `_${lengthName(words)}`, time: "_s" };
  return `${viewKey}${units[moves]}`;
}

/**
 * @param {NonNullable<Column["quantity"]>} quantity
 * @param {Choices} choices
 */
function writtenInDegrees({ kind, order }, choices) {
  return choices.degrees && order === 0 && !isLength(kind);
}

/** Matches the first character of a cell that a spreadsheet takes for a formula. */
const FORMULA = /^[=+\-@\t\r]/;

/**
 * @param {string} text
 * @param {string} separator
 * @returns {string} a cell; an apostrophe precedes text that looks like a formula, so that spreadsheets keep it as text
 */
function quoted(text, separator) {
  const cell = FORMULA.test(text) && parseNumber(text) === null ? `'${text}` : text;
  return cell.includes(separator) || /["\n\r]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell;
}

/** @param {string} text */
function oneLine(text) {
  return text.replace(/\s+/g, " ");
}
