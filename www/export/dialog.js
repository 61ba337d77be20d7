// The export dialog: table, drawing, plots and animations as files. Loaded on demand.
import { byId, make } from "assur/core/dom.js";
import { download } from "assur/core/download.js";
import { attempt } from "assur/core/problem.js";
import { animations } from "assur/export/animation.js";
import { toCsv } from "assur/export/csv.js";
import { paperTheme, toPng, toSvg, withCaption, withLegend } from "assur/export/pictures.js";
import { withoutExtras } from "assur/state/state.js";

/** @typedef {import("assur/app/page.js").Page} Page */

/** Choices of the number of rows per turn of the crank: from a row every 10° to a row every 0.1°. */
const STEPS = Object.freeze([36, 72, 180, 360, 720, 3600]);
const USUAL = 360;

/**
 * Shows the dialog in the page's language.
 * @param {Page} page
 */
export function openExport(page) {
  document.getElementById("export-dialog")?.remove();
  const { dialog, stop } = makeDialog(page);
  page.words.fill(dialog);
  byId("app", HTMLElement).append(dialog);
  dialog.addEventListener("close", () => {
    stop();
    dialog.remove();
  });
  dialog.showModal();
}

/**
 * Makes the controls for the format of the table. The decimal sign is initially that of the page's language.
 * @param {import("assur/state/coordinate.js").Coordinate} coordinate
 * @param {import("assur/core/words.js").Words} words
 */
function tableChoices({ moves }, words) {
  const select = (/** @type {string} */ choice, /** @type {Readonly<Record<string, string>>} */ keys, /** @type {string} */ usual) => {
    const made = make("select", { id: `export-${choice}`, class: "control", "aria-labelledby": `export-${choice}-name` });
    made.append(...Object.entries(keys).map(([value, key]) => make("option", { value, "data-t": key })));
    made.value = usual;
    return made;
  };
  const usual = words.numbers.comma ? "comma" : "point";
  const decimal = select("decimal", { point: "export.decimal.point", comma: "export.decimal.comma" }, usual);
  const angles = select("angles", { deg: "export.angles.deg", rad: "export.angles.rad" }, "deg");
  const names = select("names", { short: "export.names.short", words: "export.names.words" }, "short");
  const dimensions = select("dimensions", { first: "export.dimensions.first", none: "export.dimensions.none" }, "first");
  const row = (/** @type {HTMLSelectElement} */ made, /** @type {string} */ key) => [
    make("span", { id: `${made.id}-name`, "data-t": key }),
    make("div", {}, [made]),
  ];
  const signs = row(decimal, "export.decimal");
  // The table of a motion over time has units of its own: only the decimal sign can be chosen.
  const rows = moves === "time" ? signs : [
    ...signs,
    ...row(angles, "export.angles"),
    ...row(names, "export.names"),
    ...row(dimensions, "export.dimensions"),
  ];
  const chosen = () => ({
    comma: decimal.value === "comma",
    degrees: angles.value === "deg",
    worded: names.value === "words",
    dimensions: dimensions.value === "first",
  });
  return { rows, chosen };
}

/**
 * @param {import("assur/state/model.js").Model} model
 * @param {import("assur/state/state.js").State} state
 * @param {import("assur/core/words.js").Words} words
 * @returns {string} name of the drawn mechanism, and the value of its input
 */
function caption({ summary, coordinate }, state, words) {
  const name = byId("mechanism-name", HTMLElement).textContent ?? "";
  if (summary.moves === null) return name;
  return `${name}, ${coordinate.symbol} = ${coordinate.written(coordinate.of(state), words, 1)}`;
}

/** @param {Page} page */
function makeDialog(page) {
  const { engine, model, store, mechanism, chart, words } = page;
  const theme = paperTheme(engine.roles);
  const name = `assur-${engine.catalogue.fileName(withoutExtras(model.lastAccepted))}`;
  const drawing = () => withCaption(mechanism, theme, caption(model, store.get(), words));
  const plots = () => withLegend(chart, theme, words);
  const head = (/** @type {string} */ id, /** @type {string} */ key) => make("span", { id, "data-t": key });
  const button = (/** @type {string} */ part, /** @type {string} */ format, /** @type {() => void} */ press, text = format.toUpperCase()) => {
    const id = `export-${part}-${format}`;
    return make("button", { id, class: "control", type: "button", "aria-labelledby": `export-${part} ${id}`, onclick: press }, [text]);
  };
  const said = make("p", { id: "export-said", class: "note", role: "status" });
  const copy = async (/** @type {Promise<Blob>} */ png) => {
    // The item takes the promise: some browsers allow the clipboard only right after the click.
    const copied = await navigator.clipboard.write([new ClipboardItem({ "image/png": png })]).then(() => true, () => false);
    said.textContent = words.text(copied ? "export.copied" : "export.not_copied");
  };
  const pictures = (/** @type {string} */ part, /** @type {string} */ canvas, /** @type {() => import("assur/export/pictures.js").Picture} */ picture) => {
    const title = () => byId(canvas, HTMLCanvasElement).getAttribute("aria-label") ?? "";
    return make("div", {}, [
      button(part, "svg", () => download(toSvg(picture(), theme, title()), `${name}-${part}.svg`)),
      button(part, "png", async () => download(await toPng(picture(), theme), `${name}-${part}.png`)),
      ...(copies() ? [button(part, "copy", () => copy(toPng(picture(), theme)), words.text("export.copy"))] : []),
    ]);
  };
  const title = () => byId("mechanism", HTMLCanvasElement).getAttribute("aria-label") ?? "";
  const moving = animations(page, theme, name, title, said);
  const { coordinate } = model;
  const step = make("select", { id: "export-step", class: "control", "aria-labelledby": "export-table export-step-name" });
  step.append(...STEPS.map((steps) => make("option", { value: `${steps}` }, [coordinate.share(steps, words)])));
  step.value = `${USUAL}`;
  const choices = tableChoices(coordinate, words);
  const saveTable = () => {
    const { value } = attempt(() => engine.sweep(Number(step.value)));
    if (value) download(toCsv(value, coordinate, choices.chosen(), words), `${name}.csv`);
  };
  const drawn = [head("export-drawing", "export.drawing"), pictures("drawing", "mechanism", drawing)];
  // A mechanism that cannot move has only a drawing to export.
  const exports = model.summary.moves === null ? drawn : [
    head("export-table", "export.table"),
    make("div", {}, [button("table", "csv", saveTable), head("export-step-name", "export.step"), step]),
    ...choices.rows,
    ...drawn,
    head("export-plots", "export.plots"),
    pictures("plots", "charts", plots),
    ...moving.rows,
  ];
  const dialog = make("dialog", { id: "export-dialog", class: "dialog", "aria-labelledby": "export-title" }, [
    make("form", { method: "dialog" }, [
      make("h2", { id: "export-title", "data-t": "export.title" }),
      make("div", { class: "exports" }, [...exports, make("div", { class: "whole" }, [moving.working, said])]),
      make("p", { class: "note", "data-t": "export.note" }),
      make("div", { class: "way-out" }, [make("button", { id: "export-close", class: "control", "data-t": "dialog.close" })]),
    ]),
  ]);
  return { dialog, stop: moving.stop };
}

/** @returns {boolean} whether the browser can put a picture into the clipboard, which it cannot on a page without a secure address */
function copies() {
  return typeof ClipboardItem !== "undefined" && navigator.clipboard !== undefined;
}
