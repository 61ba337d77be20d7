// The wanted function of a synthesis: error of the drawn linkage, as a sentence and as a plot over x.
import { awaited } from "assur/app/busy.js";
import { LOST } from "assur/app/notices.js";
import { make, makeSvg, write } from "assur/core/dom.js";
import { Seen } from "assur/core/seen.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {NonNullable<import("assur/state/state.js").Documents["synthesis"]["function"]>} Wanted
 * @typedef {import("assur/types/web.js").FunctionSummary} Error
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Width and height of the plot in its own units. The browser stretches the plot to the size of its element. */
const [WIDE, HIGH] = [100, 30];

export class FunctionView {
  #model;
  #said = make("p", { id: "function-said" });
  #plot = makeSvg("svg", { class: "function-plot", viewBox: `0 0 ${WIDE} ${HIGH}`, preserveAspectRatio: "none", "aria-hidden": "true" });
  #ends = make("p", { class: "function-ends" });
  #there;
  #shown = new Seen();
  element;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#model = page.model;
    const open = make("button", { id: "function-open", class: "control add", type: "button", "data-t": "function.open" });
    open.addEventListener("click", async () => {
      const part = await awaited(import("assur/kinds/synthesis/function-dialog.js")).catch(() => null);
      if (part) part.openFunction(page);
      else page.notices.tell(LOST);
    });
    const remove = make("button", { id: "function-remove", class: "control add", type: "button", "data-t": "function.remove" });
    remove.addEventListener("click", () => {
      page.store.update((state) => edited(state, "synthesis", () => ({ function: null })));
      open.focus();
    });
    this.#there = make("div", { id: "function" }, [this.#said, this.#plot, this.#ends, remove]);
    this.element = make("div", {}, [open, this.#there]);
  }

  /** @param {import("assur/kinds/synthesis/positions.js").Snapshot} snapshot */
  render({ state: { document: { function: wanted } }, summary: { function: error }, words }) {
    const { document } = this.#model.lastAccepted;
    // If no linkage has been found for this function, the drawn linkage may belong to another function.
    const isDrawn = "function" in document && document.function === wanted;
    if (this.#shown.same(wanted, isDrawn, error, words)) return;
    this.#there.hidden = !isDrawn || !wanted || !error;
    if (!isDrawn || !wanted || !error) return;
    write(this.#said, errorText(wanted, error, words));
    const most = Math.abs(error.greatest?.[1] ?? 0);
    this.#plot.replaceChildren(path(`M0 ${HIGH / 2}H${WIDE}`, "line"), path(curve(error, wanted.x, most), "rocker"));
    const x = wanted.x.map((end) => words.numbers.short(end));
    write(this.#ends, words.text("function.plot", { from: x[0], to: x[1], most: words.numbers.short(most) }));
  }
}

/**
 * @param {Wanted["of"]} of
 * @param {Words} words
 * @returns {string} formula of y as a function of x, or a phrase for a table
 */
export function formula(of, words) {
  if (of === "log10") return "y = log₁₀ x";
  if (of === "exp") return "y = eˣ";
  if (of === "sin") return "y = sin x";
  return "power" in of ? `y = x^${words.numbers.exact(of.power)}` : words.text("function.table");
}

/**
 * @param {Wanted} wanted
 * @param {Error} error
 * @param {Words} words
 */
function errorText({ of }, { greatest, complete }, words) {
  const name = formula(of, words);
  if (!greatest) return words.text("function.unreached", { name });
  const [x, error] = greatest.map((value) => words.numbers.short(value));
  return `${words.text("function.error", { name, x, error })} ${words.text(complete ? "function.whole" : "function.broken")}`;
}

/**
 * @param {Error} error
 * @param {readonly [number, number]} x ends of the plotted range
 * @param {number} most the greatest error, which reaches the edge of the plot
 * @returns {string} path of the curve of the error, interrupted at values of x that the linkage does not reach
 */
function curve({ curve: samples }, [from, to], most) {
  let pen = "M";
  return samples.map(([x, error]) => {
    if (error === null) {
      pen = "M";
      return "";
    }
    const segment = `${pen}${((x - from) / (to - from)) * WIDE} ${(1 - error / (most || 1)) * (HIGH / 2)}`;
    pen = "L";
    return segment;
  }).join("");
}

/**
 * @param {string} d
 * @param {string} role of the path's colour
 */
function path(d, role) {
  const made = makeSvg("path", { d });
  made.style.setProperty("--accent", `var(--role-${role})`);
  return made;
}
