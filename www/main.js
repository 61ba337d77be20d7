// Starts the page: loads words and engine, puts the parts together, sets the time running.
import { degrees } from "assur/angles.js";
import { ChartCursor } from "assur/chart-cursor.js";
import { ChartHands } from "assur/chart-hands.js";
import { ChartView } from "assur/chart.js";
import { commands as makeCommands } from "assur/commands.js";
import { byId, make, setData } from "assur/dom.js";
import { Drafts } from "assur/drafts.js";
import { Engine } from "assur/engine.js";
import { Header } from "assur/header.js";
import { History } from "assur/history.js";
import { keep } from "assur/keeper.js";
import { helpRows, listen } from "assur/keys.js";
import { Lesson } from "assur/lesson.js";
import { Loop } from "assur/loop.js";
import { MechanismHands } from "assur/mechanism-hands.js";
import { MechanismView } from "assur/mechanism.js";
import { Model } from "assur/model.js";
import { Notices } from "assur/notices.js";
import { open, takeAddress, takeFile } from "assur/opening.js";
import { played } from "assur/player.js";
import { PlotBar } from "assur/plot-bar.js";
import { ProblemView } from "assur/problems.js";
import { Rail, Switches } from "assur/rail.js";
import { ReadoutTable } from "assur/readouts.js";
import { copyLink, filePicker, saveFile } from "assur/share.js";
import { withMechanism, withView } from "assur/state.js";
import { StatusLine } from "assur/status.js";
import { Store } from "assur/store.js";
import { Theme } from "assur/theme.js";
import { Transport } from "assur/transport.js";
import { LANGUAGES, Words, preferredLanguage } from "assur/words.js";

/** @type {import("assur/opening.js").Failure[]} */
const LOST = [{ kind: "part", problems: [{ code: "not_arrived" }] }];

/** Numbers that change faster than this cannot be read; in seconds. */
const WRITING_PERIOD = 0.2;

/**
 * Puts the page together and draws it for the first time.
 * @param {Engine} engine
 * @param {import("assur/opening.js").Habits} habits
 * @param {{ state: import("assur/state.js").State, failures: import("assur/opening.js").Failure[] }} opening
 * @param {Words} startWords
 */
function run(engine, habits, opening, startWords) {
  let words = startWords;
  const store = new Store(opening.state);
  const drafts = new Drafts(() => loop.request());
  const model = new Model(engine, drafts, store.get());
  const history = new History(store, drafts);
  const help = byId("help", HTMLDialogElement);
  byId("help-open", HTMLButtonElement).addEventListener("click", () => help.showModal());
  const theme = new Theme(engine.roles, () => loop.request());

  byId("app", HTMLElement).hidden = false;
  const chart = new ChartView(byId("charts", HTMLCanvasElement), engine, theme, () => cursor.redraw());
  const cursor = new ChartCursor(byId("chart-cursor", HTMLCanvasElement), theme, chart, engine);
  const notices = new Notices(() => loop.request());
  const take = async (/** @type {Promise<import("assur/opening.js").Taken | null>} */ coming) => {
    const taken = await coming;
    if (!taken) return;
    await learn();
    notices.tell(taken.failure ? [taken.failure] : []);
    const { state } = taken;
    if (state) history.step(() => store.update(() => state));
  };
  // The address that was entered: by now another may have been written over it.
  addEventListener("hashchange", ({ newURL }) => take(takeAddress(newURL, engine, habits)));
  const commands = Object.freeze({
    ...makeCommands({ store, model, drafts, history, engine }),
    open: filePicker((text, name) => take(takeFile(text, name, engine, habits))),
    save: () => saveFile(model.good),
    copy: () => copyLink(model.good, () => notices.tell(["copied"])),
    export: async () => {
      // The table comes of the larger engine.
      const [part] = await Promise.all([import("assur/export/dialog.js"), engine.grow()]).catch(() => []);
      if (part) part.openExport({ engine, model, mechanism, chart, words });
      else notices.tell(LOST);
    },
    gallery: async () => {
      const part = await import("assur/linkage/gallery.js").catch(() => null);
      const grown = part && (await engine.grow().then(learn).catch(() => false));
      if (grown) part.openGallery({ engine, words, store, choose });
      else notices.tell(LOST);
    },
  });
  const header = new Header(history, commands);
  new ChartHands(byId("charts", HTMLCanvasElement), chart, cursor, store, model, drafts);
  const mechanism = new MechanismView(byId("mechanism", HTMLCanvasElement), engine, theme);
  const hands = new MechanismHands(byId("mechanism", HTMLCanvasElement), mechanism, engine, store, model, drafts);
  const lesson = new Lesson({ store, model, history }, engine, () => loop.request());
  /** @type {import("assur/linkage/gallery.js").Choose} */
  const choose = (lesson, document) => history.step(() => {
    store.update((state) => withView(withMechanism(state, lesson, document), { plot: "angles" }));
    mechanism.fit();
    // The crank of another mechanism may not go where this one's stands.
    model.follow(store.get());
    if (!model.placed) store.update((state) => withView(state, { phi_deg: degrees(model.summary.home) }));
  });
  /** @type {{ render(snapshot: import("assur/model.js").Snapshot): void }[]} */
  const views = [
    mechanism,
    hands,
    chart,
    cursor,
    new Transport(store, model, drafts, theme),
    new PlotBar(store, engine, drafts),
    new ReadoutTable(),
    new ProblemView(),
    new Switches(store),
    lesson,
    header,
    notices,
  ];
  /** @type {Record<string, { render(snapshot: any): void }[] | undefined>} what only one lesson has */
  const special = { mixer: [new Rail(store, engine, drafts), new StatusLine()] };
  const specialise = async () => {
    special.linkage = [];
    const { linkageParts } = await import("assur/linkage/parts.js");
    special.linkage = linkageParts({ store, drafts, history, engine, chart, views }, words);
    loop.request();
  };

  listen({
    ...commands,
    trace: () => hands.trace(),
    lesson: () => {
      lesson.toggle();
      header.fold(store.get().view.step > 0);
    },
    settings: () => byId("settings", HTMLButtonElement).click(),
    help: () => help.showModal(),
    close: () => {
      header.close();
      notices.clear();
      hands.trace(false);
    },
  });

  let unwritten = 0;
  const step = (/** @type {number} */ dt) => {
    unwritten += dt;
    store.update((state) => played(state, dt, engine, model));
    return store.get().view.playing;
  };
  // Sentences for screen readers come with the first rest: most visits begin in motion, and need none.
  let speaks = false;
  const teachToSpeak = async () => {
    speaks = true;
    const { Spoken } = await import("assur/spoken.js");
    views.push(new Spoken(chart, opening.state.view.playing));
    loop.request();
  };
  const render = () => {
    const state = store.get();
    if (!state.view.playing && !speaks) teachToSpeak().catch(() => (speaks = false));
    const legible = !state.view.playing || unwritten >= WRITING_PERIOD;
    if (legible) unwritten = 0;
    model.follow(state);
    theme.project(state.view.projector);
    const snapshot = model.snapshot(state, words, legible);
    setData(document.documentElement, "lesson", snapshot.lesson);
    for (const view of views) view.render(snapshot);
    if (state.lesson !== snapshot.lesson) return;
    const own = special[state.lesson];
    if (!own) specialise().catch(() => notices.tell(LOST));
    for (const view of own ?? []) view.render(snapshot);
  };
  const loop = new Loop(step, render);
  store.subscribe(() => loop.request());
  keep(store, () => model.sound);

  const hear = (/** @type {Words} */ chosen) => {
    words = chosen;
    speak(words);
    loop.request();
  };
  // With linkages come their words.
  const learn = async () => {
    const { lang } = words;
    const more = await Words.load(lang, engine.tables);
    if (lang === words.lang) hear(more);
    return true;
  };
  chooseLanguage(store, engine, hear);
  speak(words);
  notices.tell(opening.failures);
  byId("boot", HTMLElement).hidden = true;
  render();
  loop.request();
  // The canvases learn their sizes, and are drawn, at the end of the first frame.
  requestAnimationFrame(() => requestAnimationFrame(() => {
    setData(document.documentElement, "ready", "true");
    performance.mark("ready");
  }));
}

/**
 * The select of languages and the state's language are one; words come when they are loaded.
 * @param {Store<import("assur/state.js").State>} store
 * @param {Engine} engine
 * @param {(words: Words) => void} changed
 */
function chooseLanguage(store, engine, changed) {
  const select = byId("lang", HTMLSelectElement);
  for (const lang of LANGUAGES) select.append(make("option", { value: lang, lang, "data-t": `lang.${lang}` }));
  select.value = store.get().view.lang;
  select.addEventListener("change", () => store.update((state) => withView(state, { lang: select.value })));
  store.subscribe(async ({ view: { lang } }, previous) => {
    if (lang === previous.view.lang) return;
    select.value = lang;
    const words = await Words.load(lang, engine.tables).catch(() => null);
    // Another choice may have been made while these words were on their way.
    if (store.get().view.lang !== lang) return;
    if (words) changed(words);
    else store.update((state) => withView(state, { lang: previous.view.lang }));
  });
}

/**
 * Writes the page in a language.
 * @param {Words} words
 */
function speak(words) {
  document.documentElement.lang = words.lang;
  document.title = words.text("page.title");
  words.fill(document);
  byId("help-keys", HTMLElement).replaceChildren(...helpRows(words));
}

/** Says that the page cannot work, in all languages. */
function fail() {
  byId("boot", HTMLElement).hidden = true;
  byId("app", HTMLElement).hidden = true;
  byId("failed", HTMLElement).hidden = false;
}

try {
  const lang = preferredLanguage(navigator.languages);
  const habits = { calm: matchMedia("(prefers-reduced-motion: reduce)").matches, lang };
  // Most often these words are those of the state, too.
  const [engine] = await Promise.all([Engine.load(), Words.load(lang)]);
  const opening = await open(engine, habits);
  run(engine, habits, opening, await Words.load(opening.state.view.lang, engine.tables));
} catch (thrown) {
  console.error(thrown);
  fail();
}
