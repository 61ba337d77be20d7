// Start of the page: loads the words and the engine, finds the first state and builds the page.
import { chosenLanguage } from "assur/app/language.js";
import { open } from "assur/app/opening.js";
import { Page } from "assur/app/page.js";
import { keptProjector } from "assur/app/projector.js";
import { byId } from "assur/core/dom.js";
import { compiledWasm } from "assur/core/wasm.js";
import { Words } from "assur/core/words.js";
import { Engine } from "assur/engine.js";
import { addressed } from "assur/state/address.js";
import { stored } from "assur/state/storage.js";

async function start() {
  const { search } = location;
  const framed = new URLSearchParams(search).has("embed") ? import("assur/embed/embed.js") : null;
  const lang = (framed ? null : chosenLanguage()) ?? document.documentElement.lang;
  const reader = { calm: matchMedia("(prefers-reduced-motion: reduce)").matches, lang, projector: !framed && keptProjector() };
  // The mechanism of a first visit needs only the first part of the engine; others may need both.
  const isFirst = addressed(location.href) === "" && (framed !== null || stored() === null);
  // Usually the state has this language, so that no other words need to be loaded.
  const [engine, part] = await Promise.all([Engine.load(), framed, Words.load(lang), isFirst ? null : compiledWasm()]);
  const embedding = part && new part.Embedding(search);
  const habits = embedding?.habits(reader) ?? reader;
  const found = await open(engine, habits);
  const opening = (await embedding?.opened(found, habits.calm)) ?? found;
  const words = await Words.load(opening.state.view.lang);
  new Page(engine, habits, words, opening).show();
}

// The start is not awaited here: modules loaded later import this module, and would have to wait for its end.
start().catch((thrown) => {
  console.error(thrown);
  byId("boot", HTMLElement).hidden = true;
  byId("app", HTMLElement).hidden = true;
  byId("failed", HTMLElement).hidden = false;
});
