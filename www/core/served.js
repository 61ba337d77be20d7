// Origin of the page: a site, which also has notes for teachers, or the one-file page, which has none.

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
