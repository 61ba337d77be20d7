// The notes for teachers beside the page: documents of the repository as pages to read.
import { readFileSync } from "node:fs";
import path from "node:path";
import { Marked } from "marked";

/** The folder of the repository and of the site. */
export const FOLDER = "docs";

/** Those that are for readers of the page. */
const NOTES = Object.freeze(["model", "errata", "file-format"]);

const HEAD = `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<title>Assur</title>
<style>
body { max-width: 52em; margin: 0 auto; padding: 1em 1.2em 4em; font: 16px/1.5 system-ui, "DejaVu Sans", sans-serif; }
table { display: block; overflow-x: auto; border-collapse: collapse; }
th, td { padding: 4px 12px 4px 0; text-align: left; vertical-align: top; border-bottom: 1px solid #8888; }
pre { overflow-x: auto; }
</style>
</head>
<body>
`;
const FOOT = "</body>\n</html>\n";

/**
 * @param {string} root of the repository
 * @returns {Map<string, string>} the notes by their places in the site
 */
export function notes(root) {
  const text = (/** @type {string} */ name) => readFileSync(path.join(root, FOLDER, `${name}.md`), "utf8");
  return new Map(NOTES.map((name) => [`${FOLDER}/${name}.html`, note(text(name))]));
}

/**
 * @param {string} markdown
 * @returns {string} a page; its links to notes lead to their pages
 */
export function note(markdown) {
  const marked = new Marked({
    walkTokens: (token) => {
      if (token.type !== "link") return;
      const link = /** @type {import("marked").Tokens.Link} */ (token);
      const [, name] = /^([\w-]+)\.md$/.exec(link.href) ?? [];
      if (NOTES.includes(name)) link.href = `${name}.html`;
    },
  });
  return `${HEAD}${marked.parse(markdown, { async: false })}${FOOT}`;
}
