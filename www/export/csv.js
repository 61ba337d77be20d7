// The table of a sweep as CSV: numbers with a decimal point, so short that they read back as the very same.

/**
 * @param {import("assur/engine.js").SweepTable} table
 * @param {string} input what its column is called
 */
export function toCsv({ columns, rows }, input) {
  const lines = rows.map(({ input: at, values, reason }) => [at, ...values.map((value) => value ?? ""), reason?.code ?? ""]);
  const text = [[input, ...columns, "reason"], ...lines].map((cells) => `${cells.join(",")}\n`);
  return new Blob(text, { type: "text/csv" });
}
