// Starts the page: loads words and engine, finds the first state, puts the page together.
import { open } from "assur/app/opening.js";
import { Page } from "assur/app/page.js";
import { byId } from "assur/core/dom.js";
import { Words } from "assur/core/words.js";
import { Engine } from "assur/engine.js";

async function start() {
  const { lang } = document.documentElement;
  const habits = { calm: matchMedia("(prefers-reduced-motion: reduce)").matches, lang };
  // Most often these words are those of the state, too.
  const [engine] = await Promise.all([Engine.load(), Words.load(lang)]);
  const opening = await open(engine, habits);
  const words = await Words.load(opening.state.view.lang);
  new Page(engine, habits, words, opening).show();
}

// Not awaited: what is loaded later imports from here, and would wait for the end of this module.
start().catch((thrown) => {
  console.error(thrown);
  byId("boot", HTMLElement).hidden = true;
  byId("app", HTMLElement).hidden = true;
  byId("failed", HTMLElement).hidden = false;
});
