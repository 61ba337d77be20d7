// The table of a sweep as CSV: numbers with a decimal point, so short that they read back as the very same.

/** @param {import("assur/engine.js").SweepTable} table */
export function toCsv({ columns, rows }) {
  const lines = rows.map(({ input, values, reason }) => [input, ...values.map((value) => value ?? ""), reason?.code ?? ""]);
  const text = [["phi_deg", ...columns, "reason"], ...lines].map((cells) => `${cells.join(",")}\n`);
  return new Blob(text, { type: "text/csv" });
}
