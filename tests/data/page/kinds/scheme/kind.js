// What the page shows of a scheme only: its mobility and its structure.
import { StatusLine } from "assur/controls/status.js";

/** @type {import("assur/app/views.js").Make} */
export const views = () => [new StatusLine("scheme", [
  { name: "scheme-mobility", title: "status.mobility", say: ({ summary, words }) => ({ text: words.numbers.exact(summary.counts.mobility) }) },
  { name: "scheme-formula", title: "status.formula", say: ({ summary }) => ({ text: summary.formula }) },
])];
