// The papers that lessons are about: of each item what is printed, as MathML for the page, and where it stands, as a document.
import temml from "temml";

/**
 * @typedef {"right" | "misprint" | "scan" | "false" | "unprovable"} Verdict whether an item holds; a misprint may be the scan's
 * @typedef {Readonly<{
 *   item: string, step: string, printed?: readonly string[], instead?: readonly string[], verdict?: Verdict, shown?: boolean, engine?: string, test?: string,
 * }>} Item
 * An item of a paper by its id: the step of the lesson that it belongs to, `end` for what closes the lesson; its formulas in LaTeX and those that hold
 * instead; `right` where there is no verdict; `shown` where its numbers do not give the answer to the question of the step away; a file and a symbol of the engine, a file and a test.
 */

/**
 * @param {string} latex
 * @returns {string} the formula as an element of MathML, without style attributes, which a hosted page forbids
 */
export function mathml(latex) {
  // A prime stands raised in every font: as a superscript it would be tiny.
  const primed = latex.replaceAll("''", "\\mathord{″}").replaceAll("'", "\\mathord{′}");
  const text = temml.renderToString(primed, { throwOnError: true, displayMode: true, wrap: "none" });
  return text.replaceAll(/ (style|class)="[^"]*"/g, "").replaceAll(/<menclose[^>]*>(.*?)<\/menclose>/g, "<mover>$1<mo>¯</mo></mover>");
}

/**
 * @param {string} text of `paper.json` in the folder of a lesson
 * @returns {string} what the page reads of it
 */
export function built(text) {
  const items = /** @type {Item[]} */ (JSON.parse(text));
  return JSON.stringify(items.map(({ item, step, printed = [], instead = [], verdict = "right", shown = false }) => ({ item, step, verdict, printed: printed.map(mathml), instead: instead.map(mathml), shown })));
}

/**
 * @param {readonly { lesson: string, items: readonly Item[] }[]} papers
 * @param {number} all items of all papers
 * @returns {string} the document that says where each item stands
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
