// Reader of the tables that the page saves as CSV.
import assert from "node:assert/strict";

/** Unit at the end of a column's name. In `phi_deg`, the column of the input, the unit is part of the name. */
const UNIT = /_(rad|deg|m|mm|cm|length|s)(_per_.*)?$/;

/**
 * @param {Blob} file
 * @returns {Promise<{ text: string, comments: string[], header: string[], rows: string[][], has: (column: string) => boolean, cell: (row: number, column: string) => string, value: (row: number, column: string) => number }>}
 */
export async function readCsv(file) {
  const bytes = await file.text();
  const text = bytes.replace(/^\ufeff/, "");
  const lines = text.split("\n");
  assert.equal(lines.pop(), "");
  const comments = lines.filter((line) => line.startsWith("# "));
  const [head, ...rest] = lines.slice(comments.length);
  const comma = head.includes(";");
  const header = head.split(comma ? ";" : ",");
  const rows = rest.map((line) => line.split(comma ? ";" : ",").map((cell) => (comma ? cell.replace(",", ".") : cell)));
  for (const row of rows) {
    assert.equal(row.length, header.length, String(row));
    // Each number is written with its shortest text.
    for (const cell of row.slice(0, -1).filter((one) => one !== "")) assert.equal(cell, String(Number(cell)));
  }
  const columns = new Map(header.map((name, index) => [name === "phi_deg" ? name : name.replace(UNIT, ""), index]));
  const cell = (row, column) => {
    assert.ok(columns.has(column), `${column} in ${header}`);
    return rows[row][columns.get(column)];
  };
  return { text, comments, header, rows, has: (column) => columns.has(column), cell, value: (row, column) => (cell(row, column) === "" ? NaN : Number(cell(row, column))) };
}
