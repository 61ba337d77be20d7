// `index.html` for each output. An element with `data-in` is only in the outputs that the attribute names: `site` is
// the served page, `host` the folder for a host, `file` the page in one file.
import { parse } from "node-html-parser";

/** @typedef {import("./folders.js").Table} Table */
/** @typedef {"site" | "host" | "file"} Output */

/** Language of the title, and first language where a text is given in all languages. */
const FIRST = "en";

/**
 * Fills the placeholders `{{key}}` of the page. No language is chosen before scripts run, so a placeholder gets the
 * text in all languages. Only the title has to be short and gets one language. `{{version}}` stands for the version,
 * `{{languages}}` for the codes of the languages.
 * @param {string} page
 * @param {ReadonlyMap<string, Table>} tables by language
 * @param {string} version
 * @returns {string}
 */
export function fill(page, tables, version) {
  const languages = [FIRST, ...[...tables.keys()].filter((language) => language !== FIRST)];
  const text = (/** @type {string} */ language, /** @type {string} */ key) => {
    const found = tables.get(language)?.[key];
    if (found === undefined) throw new Error(`the page asks for the words \`${key}\`, which ${language}.json lacks`);
    return found;
  };
  const all = (/** @type {string} */ key) => [...new Set(languages.map((language) => text(language, key)))].join(" · ");
  const places = (/** @type {string} */ part, /** @type {(key: string) => string} */ given) =>
    part.replace(/\{\{\s*([\w.]+)\s*\}\}/g, (_, key) => escaped(given(key)));
  const facts = new Map([["version", version], ["languages", [...tables.keys()].sort().join(" ")]]);
  const titled = page.replace(/<title[^>]*>[^]*?<\/title>/g, (title) => places(title, (key) => text(FIRST, key)));
  const filled = places(titled, (key) => facts.get(key) ?? all(key));
  if (filled.includes("{{")) throw new Error("the page opens a place for words by {{ and does not close it");
  return filled;
}

/** @param {string} text text to be escaped for an element's content or for a quoted attribute */
function escaped(text) {
  return text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");
}

/** The page as a tree of elements, to be changed for one output. */
export class Page {
  #tree;

  /**
   * @param {string} page
   * @param {Output} output
   */
  constructor(page, output) {
    this.#tree = parse(page, { comment: false });
    for (const element of this.#tree.querySelectorAll("[data-in]")) {
      if (element.getAttribute("data-in")?.split(" ").includes(output)) element.removeAttribute("data-in");
      else element.remove();
    }
  }

  /** @param {string} selector selector that must match exactly one element */
  #one(selector) {
    const [element, another] = this.#tree.querySelectorAll(selector);
    if (!element || another) throw new Error(`index.html has ${element ? "more than one" : "no"} ${selector}`);
    return element;
  }

  /** @param {Record<string, string>} imports addresses of files by the bare names that scripts use */
  setImportMap(imports) {
    // A `</script>` in the map would end the element.
    const map = JSON.stringify({ imports }).replaceAll("<", "\\u003c");
    this.#one("script[type=importmap]").set_content(map, { comment: true });
  }

  /** @param {(name: string) => string} address returns the address of a file in a `link` element */
  setLinks(address) {
    for (const link of this.#tree.querySelectorAll("link[href]")) {
      const name = link.getAttribute("href") ?? "";
      if (!name.startsWith("data:")) link.setAttribute("href", address(name));
    }
  }

  /** @param {(name: string) => string} style returns the content of a style sheet */
  putStylesInside(style) {
    for (const link of this.#tree.querySelectorAll("link[rel=stylesheet]")) {
      const content = style(link.getAttribute("href") ?? "").replaceAll("</", "<\\/");
      link.replaceWith(`<style>${content}</style>`);
    }
  }

  /**
   * @param {string} selector attribute that identifies a `meta` element, such as `name="build"`
   * @param {string} content
   */
  setMeta(selector, content) {
    this.#one(`meta[${selector}]`).setAttribute("content", content);
  }

  /** @returns {string} the page as text, without comments and indentation */
  text() {
    const lines = this.#tree.toString().split("\n").map((line) => line.trim());
    return `${lines.filter((line) => line !== "").join("\n")}\n`;
  }
}

/**
 * @param {string} page
 * @param {"script" | "style"} element
 * @returns {string[]} contents of the elements of this name, without empty ones
 */
export function inline(page, element) {
  const all = parse(page).querySelectorAll(element).map(({ rawText }) => rawText);
  return all.filter((content) => content !== "");
}
