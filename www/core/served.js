// Origin of the page: a site has notes for teachers beside it, the one-file page has none.

/**
 * @param {string} lesson
 * @param {string} lang
 * @returns {string} address of the notes for teachers
 */
export function notesOf(lesson, lang) {
  return `docs/${lesson}.${lang}.html`;
}

export function served() {
  return location.protocol.startsWith("http");
}
