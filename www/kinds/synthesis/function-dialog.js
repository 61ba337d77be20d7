// The dialog for a wanted function. It derives the positions of a synthesis from the function. Loaded on demand.
import { numberField } from "assur/controls/number-box.js";
import { sentence } from "assur/controls/problems.js";
import { radians } from "assur/core/angles.js";
import { byId, make } from "assur/core/dom.js";
import { parseNumber } from "assur/core/numbers.js";
import { Refusal, attempt } from "assur/core/problem.js";
import { formula } from "assur/kinds/synthesis/function.js";
import { MAX_POSITIONS } from "assur/kinds/synthesis/positions.js";
import { take } from "assur/state/change.js";
import { edited, withoutExtras } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/synthesis/function.js").Wanted} Wanted
 * @typedef {import("assur/state/state.js").Documents["synthesis"]} Document
 * @typedef {import("assur/core/problem.js").Problem} Problem
 */

/** Initial values. `USUAL`: function. `POWER`: exponent. `COUNT`: number of positions; with `USUAL` the error is 0.2 %. */
const USUAL = Object.freeze(/** @type {Wanted} */ ({ of: "log10", x: [1, 2], input_deg: [90, 150], output_deg: [210, 270] }));
const POWER = 2;
const COUNT = 3;

/** The ranges that the form asks for: of x and of both angles, with their units. */
const RANGES = Object.freeze(/** @type {const} */ ([["x", ""], ["input_deg", "°"], ["output_deg", "°"]]));

/** Separator of two numbers in a row. A comma without a space after it may be a decimal sign. */
const BETWEEN = /\s*;\s*|,?\s+/;

/**
 * Shows the dialog in the page's language.
 * @param {import("assur/app/page.js").Page} page page with an open synthesis
 */
export function openFunction(page) {
  const { words } = page;
  const document = /** @type {Document} */ (page.store.get().document);
  const form = makeForm(document, words);
  const problem = make("p", { id: "function-problem", role: "alert" });
  const set = make("button", { id: "function-set", class: "control", type: "submit", "data-t": "function.set" });
  const close = make("button", { id: "function-close", class: "control", type: "button", "data-t": "dialog.close" });
  const element = make("form", { novalidate: "" }, [
    make("h2", { id: "function-title", "data-t": "function.title" }),
    make("div", { class: "exports" }, form.rows),
    make("p", { class: "note", "data-t": "function.note" }),
    problem,
    make("div", { class: "way-out" }, [set, " ", close]),
  ]);
  const dialog = make("dialog", { id: "function-dialog", class: "dialog", "aria-labelledby": "function-title" }, [element]);
  words.fill(dialog);
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", () => dialog.remove());
  element.addEventListener("submit", (event) => {
    event.preventDefault();
    const { value, problems } = attempt(() => made(form, page));
    form.mark(new Set(problems.map(({ field }) => field)));
    problem.textContent = [...new Set(problems.map((one) => sentence(one, words)))].join(" ");
    if (!value) return;
    const [{ input_deg: input }] = value.positions;
    page.history.step(() => take({ document: value, input: radians(input) }, page));
    dialog.close();
  });
  byId("app", HTMLElement).append(dialog);
  dialog.showModal();
}

/**
 * @param {ReturnType<typeof makeForm>} form
 * @param {import("assur/app/page.js").Page} page
 * @returns {Partial<Document> & Pick<Document, "positions">} the new fields of the document; choices made for other positions are reset
 */
function made(form, { engine, store }) {
  const { wanted, count, even } = form.read();
  const state = withoutExtras(edited(store.get(), "synthesis", () => ({ function: wanted })));
  const positions = engine.functions.functionPositions(state, count, even);
  return { function: wanted, positions, free: false, member: null, solution: null, trial: null };
}

/**
 * @param {Document} document
 * @param {import("assur/core/words.js").Words} words
 */
function makeForm(document, words) {
  const { of, ...ends } = document.function ?? USUAL;
  const { numbers } = words;
  const named = (/** @type {string} */ id, /** @type {string} */ key) => make("span", { id, "data-t": key });
  const select = (/** @type {string} */ id, /** @type {readonly (readonly [string, string])[]} */ options, /** @type {string} */ value) => {
    const box = make("select", { id, class: "control", "aria-labelledby": `${id}-name` });
    box.append(...options.map(([one, text]) => make("option", { value: one }, [text])));
    box.value = value;
    return box;
  };
  const box = (/** @type {string} */ id, /** @type {string} */ by, /** @type {string} */ value) => numberField({ id, size: "6", "aria-labelledby": by, value });

  const [kind, inner] = typeof of === "string" ? [of, null] : /** @type {["power" | "table", unknown]} */ (Object.entries(of)[0]);
  const chosen = select("function-of", [
    ["log10", formula("log10", words)], ["power", "y = x^p"], ["exp", formula("exp", words)],
    ["sin", words.text("function.sin")], ["table", words.text("function.table")],
  ], kind);
  const power = box("function-power", "function-power-name", numbers.exact(typeof inner === "number" ? inner : POWER));
  const powered = make("label", { id: "function-powered" }, [named("function-power-name", "function.power"), " ", power]);
  const rows = make("textarea", { id: "function-rows", class: "control", rows: "5", spellcheck: "false", "aria-labelledby": "function-rows-name" });
  rows.value = Array.isArray(inner) ? inner.map((row) => row.map(numbers.exact, numbers).join(" ")).join("\n") : "";
  const ranges = RANGES.map(([part, unit]) => {
    const boxes = ends[part].map((end, k) => box(`function-${part}-${k}`, `function-${part}-name function-${part}-${k}-name`, numbers.exact(end) + unit));
    const cells = boxes.map((one, k) => make("span", { class: "function-end" }, [named(`${one.id}-name`, k === 0 ? "function.from" : "function.to"), " ", one]));
    return { part, boxes, row: [named(`function-${part}-name`, `field.function.${part}`), make("div", {}, cells)] };
  });
  const counts = Array.from({ length: MAX_POSITIONS - 1 }, (_, k) => String(k + 2)).map((n) => /** @type {[string, string]} */ ([n, n]));
  const count = select("function-count", counts, String(document.function ? Math.min(document.positions.length, MAX_POSITIONS) : COUNT));
  const spacing = select("function-spacing", [["roots", words.text("function.roots")], ["even", words.text("function.even")]], "roots");
  const pasted = [named("function-rows-name", "function.rows"), make("div", {}, [rows])];
  const fit = () => {
    powered.hidden = chosen.value !== "power";
    for (const one of pasted) one.hidden = chosen.value !== "table";
    // A table determines the range of x itself.
    for (const one of ranges[0].row) one.hidden = chosen.value === "table";
  };
  chosen.addEventListener("change", fit);
  fit();

  /** Inputs to mark if a field of the document is invalid, by the name of that field. */
  const boxes = new Map([["function.of", [rows]], ["function.power", [power]], ...ranges.map(({ part, boxes }) => /** @type {const} */ ([`function.${part}`, boxes]))]);
  return {
    rows: [
      named("function-of-name", "field.function.of"), make("div", {}, [chosen, powered]),
      ...pasted, ...ranges.flatMap(({ row }) => row),
      named("function-count-name", "function.count"), make("div", {}, [count]),
      named("function-spacing-name", "function.spacing"), make("div", {}, [spacing]),
    ],
    /** @param {ReadonlySet<string | undefined>} wrong fields */
    mark(wrong) {
      for (const [field, all] of boxes) for (const one of all) one.setAttribute("aria-invalid", String(wrong.has(field)));
    },
    /** @returns {{ wanted: Wanted, count: number, even: boolean }} the typed values; throws a `Refusal` if one of them is not a number */
    read() {
      /** @type {Problem[]} */
      const problems = [];
      const number = (/** @type {string} */ text, /** @type {string} */ field) => {
        const value = parseNumber(text);
        if (value === null) problems.push({ code: "not_a_number", field });
        return value ?? 0;
      };
      const pair = (/** @type {number} */ k) => {
        const { part, boxes: [from, to] } = ranges[k];
        return /** @type {[number, number]} */ ([from, to].map((one) => number(one.value, `function.${part}`)));
      };
      const table = chosen.value === "table" ? tableOf(rows.value, problems) : null;
      const of = /** @type {Wanted["of"]} */ (table ? { table } : chosen.value === "power" ? { power: number(power.value, "function.power") } : chosen.value);
      /** @type {Wanted["x"]} */
      const x = table ? [table[0]?.[0] ?? 0, table.at(-1)?.[0] ?? 0] : pair(0);
      const wanted = { of, x, input_deg: pair(1), output_deg: pair(2) };
      if (problems.length > 0) throw new Refusal(problems);
      return { wanted, count: Number(count.value), even: spacing.value === "even" };
    },
  };
}

/**
 * @param {string} text two numbers to a line, separated by a space, a semicolon or a comma
 * @param {Problem[]} problems list that receives a problem for each invalid line
 * @returns {[number, number][]}
 */
export function tableOf(text, problems) {
  const lines = text.split("\n").map((line) => line.trim()).filter(Boolean);
  return lines.map((line, k) => {
    const parts = line.split(BETWEEN);
    const pair = (parts.length === 1 ? line.split(",") : parts).map(parseNumber);
    const [x, y] = pair;
    if (pair.length === 2 && x !== null && y !== null) return [x, y];
    problems.push({ code: "bad_row", field: "function.of", row: k + 1 });
    return [0, 0];
  });
}
