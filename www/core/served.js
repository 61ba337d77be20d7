// Whether the page comes from a site, which has notes beside it; the page that is one file has none.

/**
 * @param {string} lesson
 * @param {string} lang
 * @returns {string} where the notes for teachers are
 */
export function notesOf(lesson, lang) {
  return `docs/${lesson}.${lang}.html`;
}

export function served() {
  return location.protocol.startsWith("http");
}
