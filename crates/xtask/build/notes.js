// Notes as HTML pages beside the page: documents of the repository, and notes for teachers from the lessons.
import { readFileSync } from "node:fs";
import path from "node:path";
import { Marked } from "marked";

/** Folder of the documents in the repository, and of the notes in the site. */
export const FOLDER = "docs";

/** Documents of the repository that are published with the page. */
const NOTES = Object.freeze(["errata", "file-format"]);

/** Path of a lesson's notes in one language. */
export const OF_LESSON = /^lessons\/([^/]+)\/notes\.(\w+)\.md$/;

const head = (/** @type {string} */ lang) => `<!doctype html>
<html lang="${lang}">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="data:,">
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
 * @param {ReadonlyMap<string, string>} sources locations of the page's source files by their paths in `www`
 * @returns {Map<string, string>} the notes by their paths in the site, such as `docs/mixer.kk.html` for a lesson
 */
export function notes(root, sources) {
  const found = NOTES.map((name) => ({ name, lang: "en", file: path.join(root, FOLDER, `${name}.md`) }));
  for (const [place, file] of sources) {
    const [, lesson, lang] = OF_LESSON.exec(place) ?? [];
    if (lesson) found.push({ name: `${lesson}.${lang}`, lang, file });
  }
  return new Map(found.map(({ name, lang, file }) => [`${FOLDER}/${name}.html`, note(readFileSync(file, "utf8"), lang)]));
}

/**
 * @param {string} markdown
 * @param {string} lang
 * @returns {string} an HTML page, with links to published documents changed to links to their pages
 */
export function note(markdown, lang) {
  const marked = new Marked({
    walkTokens: (token) => {
      if (token.type !== "link") return;
      const link = /** @type {import("marked").Tokens.Link} */ (token);
      const [, name] = /([\w-]+)\.md$/.exec(link.href) ?? [];
      if (NOTES.includes(name)) link.href = `${name}.html`;
    },
  });
  return `${head(lang)}${marked.parse(markdown, { async: false })}${FOOT}`;
}
