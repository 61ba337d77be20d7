// The worksheet printed instead of the page: drawing and plots, given numbers, values, steps of the lesson with lines
// for answers, and the page's address. Loaded once the page is drawn, because printing does not wait for modules.
import { byId, make, makeSvg } from "assur/core/dom.js";
import { withSubscripts } from "assur/core/subscripts.js";
import { paperTheme, toSvgElement, withLegend } from "assur/export/pictures.js";
import { stepOnPaper } from "assur/export/steps.js";
import "assur/export/style.js";
import { given } from "assur/lesson/given.js";
import { END } from "assur/lesson/panel.js";

/** @typedef {import("assur/app/page.js").Page} Page */

/** Side of a cell of the QR code, in millimetres: large enough for a telephone to read the code from paper. */
const CELL = 0.45;
/** Quiet zone around the code, in cells. */
const QUIET = 4;
/** Numbers of characters up to which an address is printed as text, and as a QR code: longer ones nobody types, or no telephone reads. */
const MAX_TEXT = 200;
const MAX_CODE = 900;

/**
 * Makes the browser print a worksheet instead of the page.
 * @param {Page} page
 */
export function printWorksheets(page) {
  const clear = () => document.getElementById("worksheet")?.remove();
  addEventListener("beforeprint", () => {
    clear();
    const steps = page.lesson.steps();
    // A worksheet must not answer its own questions.
    const hidden = steps.flatMap(({ question }) => question?.hides ?? []);
    document.body.append(page.sheet ?? page.posed(hidden, () => worksheet(page, steps)));
  });
  addEventListener("afterprint", clear);
}

/**
 * @param {Page} page
 * @param {readonly import("assur/lesson/panel.js").Told[]} steps of the open lesson
 */
function worksheet(page, steps) {
  const { engine, model, mechanism, chart, words, address } = page;
  const theme = paperTheme(engine.roles);
  const title = byId("mechanism-name", HTMLElement);
  const line = (/** @type {string} */ key) => make("span", { class: "blank" }, [words.text(key)]);
  const drawn = (/** @type {import("assur/export/pictures.js").Picture} */ picture, /** @type {string} */ said) => make("figure", {}, [toSvgElement(picture, theme, said)]);
  const figure = (/** @type {import("assur/export/pictures.js").Picture} */ picture, /** @type {string} */ canvas) => drawn(picture, byId(canvas, HTMLCanvasElement).getAttribute("aria-label") ?? "");
  const figures = [figure(mechanism.cropped(), "mechanism")];
  if (model.summary.moves !== null) figures.push(figure(withLegend(chart, theme, words), "charts"));
  const items = steps.map(({ question, ...step }) => {
    const posed = question && { text: question.text, options: (question.options ?? []).map(({ text }) => text) };
    return stepOnPaper({ ...step, question: posed }, page.lesson.onPaper(step.id));
  });
  return make("section", { id: "worksheet", class: "paper", lang: words.lang }, [
    make("header", {}, [
      make("h1", {}, [title.textContent ?? ""]),
      make("p", {}, [title.title]),
      make("p", { class: "blanks" }, [line("print.name"), line("print.date")]),
    ]),
    make("div", { class: "figures" }, figures),
    make("div", { class: "tables" }, [dimensions(page), values(page.shown)]),
    ...[...page.onPaper.values()].flatMap((parts) => parts(drawn)),
    ...(items.length > 0 ? [make("ol", {}, items), ...page.lesson.onPaper(END)] : []),
    foot(address.link(model.lastAccepted), page),
  ]);
}

/**
 * @param {Page} page
 * @returns {HTMLElement} all given numbers of the drawn mechanism
 */
function dimensions({ engine, model, words }) {
  const rows = given(model.lastAccepted, engine, words).map((one) => make("tr", {}, [make("td", {}, withSubscripts(one))]));
  return make("table", {}, [make("tbody", {}, rows)]);
}

/**
 * @param {import("assur/controls/shown.js").Shown} shown
 * @returns {HTMLElement} table of values and status line as on the page; values hidden by a lesson stay hidden
 */
function values(shown) {
  const cell = (/** @type {string} */ text, wide = false) => make("td", { colspan: wide ? "3" : "1" }, [text]);
  const rows = shown.rows("values", "curvature").map(({ title, cells }) => make("tr", {}, [cell(title), ...cells.map(({ text, wide }) => cell(text, wide))]));
  const said = shown.rows("status").map(({ title, cells: [{ text }] }) => make("p", {}, [`${title} ${text}`]));
  return make("div", {}, [make("table", {}, [make("tbody", {}, rows)]), ...said]);
}

/**
 * @param {string} link
 * @param {Page} page
 */
function foot(link, { engine, words }) {
  const cells = link.length > MAX_CODE ? null : engine.functions.qrCode(link);
  const parts = cells ? [code(cells)] : [];
  return make("footer", {}, [...parts, make("p", {}, [link.length <= MAX_TEXT ? link : words.text(cells ? "print.code" : "print.long")])]);
}

/** @param {Uint8Array} cells of the QR code, row by row; 1 is dark */
function code(cells) {
  const side = Math.sqrt(cells.length);
  const edge = side + 2 * QUIET;
  const path = [...cells].map((dark, at) => (dark ? `M${at % side} ${Math.floor(at / side)}h1v1h-1z` : "")).join("");
  const svg = makeSvg("svg", { viewBox: `${-QUIET} ${-QUIET} ${edge} ${edge}`, class: "code" }, [makeSvg("path", { d: path })]);
  svg.style.width = `${edge * CELL}mm`;
  return svg;
}
