// The language of the page.
import { byId, make } from "assur/core/dom.js";
import { LANGUAGES, Words } from "assur/core/words.js";
import { withView } from "assur/state/state.js";
import { keep, kept } from "assur/state/storage.js";

/** Name under which the browser stores the chosen language. */
const NAME = "lang";

/** @returns {string | null} the language that the reader chose last */
export function chosenLanguage() {
  const lang = kept(NAME);
  return lang !== null && LANGUAGES.includes(lang) ? lang : null;
}

/**
 * Connects the list of languages with the state's language. A change reaches the page once the words are loaded.
 * @param {import("assur/app/page.js").Page} page
 */
export function chooseLanguage(page) {
  const { store, habits } = page;
  const select = byId("lang", HTMLSelectElement);
  for (const lang of LANGUAGES) select.append(make("option", { value: lang, lang, "data-t": `lang.${lang}` }));
  select.value = store.get().view.lang;
  /** The language chosen by the reader, stored once its words are loaded. */
  let chosen = "";
  select.addEventListener("change", () => {
    chosen = select.value;
    store.update((state) => withView(state, { lang: select.value }));
  });
  store.subscribe(async ({ view: { lang } }, previous) => {
    if (lang === previous.view.lang) return;
    select.value = lang;
    const words = await Words.load(lang).catch(() => null);
    // Another choice may have been made during the load.
    if (store.get().view.lang !== lang) return;
    if (words) page.setLanguage(words);
    // The words did not load: the state returns to the language of the page.
    else store.update((state) => withView(state, { lang: page.words.lang }));
    // A page embedded in another stores nothing.
    if (words && lang === chosen && !habits.embedding) keep(NAME, lang);
  });
}

/**
 * Writes all texts of the page in the language of the words.
 * @param {Words} words
 */
export function writeTexts(words) {
  document.documentElement.lang = words.lang;
  words.fill(document);
}
