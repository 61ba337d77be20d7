// Items of the papers that lessons are about: their formulas as MathML for the page, and a document that lists where
// each item is treated.
import temml from "temml";

/**
 * @typedef {"right" | "misprint" | "scan" | "false" | "unprovable"} Verdict whether an item holds as printed.
 * `misprint`: an error of the print or of the scan. `scan`: not legible in the scan. `unprovable`: neither proved nor
 * refuted
 * @typedef {Readonly<{
 *   item: string, step: string, printed?: readonly string[], instead?: readonly string[], verdict?: Verdict, shown?: boolean, engine?: string, test?: string,
 * }>} Item
 * An item of a paper. `item`: its id. `step`: id of the step of the lesson that it belongs to; `end` for the end of the
 * lesson. `printed`, `instead`: formulas in LaTeX as printed, and correct formulas. `verdict`: by default `right`.
 * `shown`: true if its numbers do not give the answer to the step's question away. `engine`: a file and a symbol of the
 * engine. `test`: a file and a test.
 */

/**
 * @param {string} latex
 * @returns {string} the formula as MathML, without style attributes, which the Content-Security-Policy forbids
 */
export function mathml(latex) {
  // Fonts draw the prime sign raised and small. As a superscript it would be tiny.
  const primed = latex.replaceAll("''", "\\mathord{″}").replaceAll("'", "\\mathord{′}");
  const text = temml.renderToString(primed, { throwOnError: true, displayMode: true, wrap: "none" });
  return text.replaceAll(/ (style|class)="[^"]*"/g, "").replaceAll(/<menclose[^>]*>(.*?)<\/menclose>/g, "<mover>$1<mo>¯</mo></mover>");
}

/**
 * @param {string} text of `paper.json` in the folder of a lesson
 * @returns {string} the fields that the page reads, as JSON, with formulas in MathML
 */
export function built(text) {
  const items = /** @type {Item[]} */ (JSON.parse(text));
  return JSON.stringify(items.map(({ item, step, printed = [], instead = [], verdict = "right", shown = false }) => ({ item, step, verdict, printed: printed.map(mathml), instead: instead.map(mathml), shown })));
}

/**
 * @param {readonly { lesson: string, items: readonly Item[] }[]} papers
 * @param {number} all number of items of all papers
 * @returns {string} document, in Markdown, that lists where each item is treated
 */
export function listed(papers, all) {
  const count = papers.reduce((sum, { items }) => sum + items.length, 0);
  const parts = papers.map(({ lesson, items }) => {
    const rows = items.map(({ item, step, verdict = "right", engine = "–", test = "–" }) => `| ${item} | ${verdict} | ${step} | ${code(engine)} | ${code(test)} |`);
    return `## ${lesson}\n\n| item | verdict | step | engine | test |\n|---|---|---|---|---|\n${rows.join("\n")}\n`;
  });
  return `# Items of the papers\n\nWhere each equation, figure, claim and worked number of the papers stands: the step of the lesson that shows it, what of the engine computes it, the test that
holds it. Of ${all} items ${count} are placed so. Written from \`www/lessons/*/paper.json\` by the tests of the build
(\`ASSUR_WRITE=1 node --test crates/xtask/build/papers.test.js\`).\n\n${parts.join("\n")}`;
}

/** @param {string} place a file and a symbol */
function code(place) {
  return place === "–" ? place : place.split(" ").map((part) => `\`${part}\``).join(" ");
}
