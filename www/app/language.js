// The language of the page.
import { byId, make } from "assur/core/dom.js";
import { LANGUAGES, Words } from "assur/core/words.js";
import { withView } from "assur/state/state.js";
import { keep, kept } from "assur/state/storage.js";

/** Under what the language that was chosen is kept. */
const NAME = "lang";

/** @returns {string | null} the language that the reader chose last */
export function chosenLanguage() {
  const lang = kept(NAME);
  return lang !== null && LANGUAGES.includes(lang) ? lang : null;
}

/**
 * The select of languages and the state's language are one; words come when they are loaded.
 * @param {import("assur/app/page.js").Page} page
 */
export function chooseLanguage(page) {
  const { store, habits } = page;
  const select = byId("lang", HTMLSelectElement);
  for (const lang of LANGUAGES) select.append(make("option", { value: lang, lang, "data-t": `lang.${lang}` }));
  select.value = store.get().view.lang;
  /** The language that the reader has chosen: it is kept once its words are there. */
  let chosen = "";
  select.addEventListener("change", () => {
    chosen = select.value;
    store.update((state) => withView(state, { lang: select.value }));
  });
  store.subscribe(async ({ view: { lang } }, previous) => {
    if (lang === previous.view.lang) return;
    select.value = lang;
    const words = await Words.load(lang).catch(() => null);
    // Another choice may have been made while these words were on their way.
    if (store.get().view.lang !== lang) return;
    if (words) page.hear(words);
    // Back to the language that the page speaks.
    else store.update((state) => withView(state, { lang: page.words.lang }));
    // In a frame of another page nothing is kept.
    if (words && lang === chosen && !habits.embedding) keep(NAME, lang);
  });
}

/**
 * Writes the page in a language.
 * @param {Words} words
 */
export function speak(words) {
  document.documentElement.lang = words.lang;
  words.fill(document);
}
