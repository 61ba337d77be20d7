// Sources of states: an address, the browser's storage, a file, and a file or text of another program.
import { Refusal, attempt } from "assur/core/problem.js";
import { LANGUAGES } from "assur/core/words.js";
import { fromAddress, fromFile } from "assur/state/codec.js";
import { addressed } from "assur/state/address.js";
import { initialState, usualView, withExtras } from "assur/state/state.js";
import { putAside, stored, takeUpAddress, withImage } from "assur/state/storage.js";

/**
 * @typedef {import("assur/engine.js").Engine} Engine
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {Readonly<{ kind: "address" | "embed" | "kept" | "file" | "part" | "pasted" | "import" | "link" | "picture" | "store", problems: readonly Problem[], name?: string }>} Failure
 * A failure of kind `import` lists the parts that could not be imported; all other parts were.
 * @typedef {Readonly<{ state: State, failure: Failure | null } | { state: null, failure: Failure }>} Taken
 * @typedef {{ state: State, failures: readonly Failure[] }} Opening
 * @typedef {Readonly<{ calm: boolean, lang: string, projector?: boolean, embedding?: import("assur/embed/embed.js").Embedding | null }>} Habits
 * Settings of the visit. `calm`: nothing moves unless the reader starts it. `lang`: language of states that name none,
 * chosen on the page or else by the browser. `projector`: whether projector mode is on, which no state turns off. `embedding`: settings from another page that shows this one in a frame.
 */

/** Extension of the files of the program Linkage. */
const EXTENSION = /\.linkage2$/i;

/** Extensions of pictures: some systems do not know the type of every picture. */
const PICTURE = /\.(avif|bmp|gif|hei[cf]|jpe?g|png|svg|tiff?|webp)$/i;

/** Largest size of a file, in bytes. */
const MAX_FILE = 20_000_000;

/** Codes of problems with a file after which the notice also lists the kinds of file that can be opened. */
const OTHERS = Object.freeze(["not_json", "no_mechanism", "is_picture"]);

/**
 * Length to which texts of other programs are cut, in characters, because the engine's memory never shrinks. It exceeds
 * the engine's limit, so that the engine refuses a text that was cut.
 */
const MAX_FOREIGN = 2 ** 20 + 1;

/** Greatest length of a title, in characters. */
const MAX_TITLE = 400;

/**
 * Makes a state from a value that comes from outside the page, which the engine checks, and applies the settings of the visit to its view.
 * @param {Failure["kind"]} kind
 * @param {() => unknown} unwrap
 * @param {Engine} engine
 * @param {Habits} habits
 * @returns {Promise<Taken>}
 */
async function take(kind, unwrap, engine, { calm, lang, projector = false, embedding }) {
  const unwrapped = attempt(unwrap);
  let { problems } = unwrapped;
  /** @type {State | null} */
  let value = null;
  if (problems.length === 0) ({ value, problems } = attempt(() => /** @type {State} */ (engine.functions.readState(unwrapped.value))));
  if (!value) return { state: null, failure: { kind, problems } };
  const { kind: of, document, view } = value;
  const playing = view.playing && !calm;
  const drawing = view.drawing && (embedding?.edits ?? true);
  return { state: initialState(of, document, { ...view, playing, drawing, projector: view.projector || projector, lang: LANGUAGES.includes(view.lang) ? view.lang : lang }, value), failure: null };
}

/**
 * @param {string} address
 * @param {Engine} engine
 * @param {Habits} habits
 * @returns {Promise<Taken | null>} null if the address holds no state
 */
export async function takeAddress(address, engine, habits) {
  const hash = addressed(address);
  if (hash === "") return null;
  const presetOf = (/** @type {string} */ id) => {
    const preset = engine.catalogue.preset(id);
    return preset && { kind: preset.kind, document: preset.document, view: usualView({ lang: habits.lang }) };
  };
  return take("address", () => fromAddress(hash, presetOf), engine, habits);
}

/**
 * @param {File} file
 * @returns {Problem | null} reason not to read the file; null if there is none
 */
function unfit({ name, size, type }) {
  if (type.startsWith("image/") || (type === "" && PICTURE.test(name))) return { code: "is_picture" };
  return size > MAX_FILE ? { code: "file_too_large", size: size / 1e6, max: MAX_FILE / 1e6 } : null;
}

/**
 * @param {File} file
 * @param {Engine} engine
 * @param {Habits} habits
 * @returns {Promise<Taken>}
 */
export async function takeFile(file, engine, habits) {
  const { name } = file;
  const problem = unfit(file);
  const text = problem ? "" : await file.text().catch(() => "");
  if (isForeign(text, engine)) return takeForeign(text, name, engine, habits);
  const unwrap = () => {
    if (problem) throw new Refusal([problem]);
    const value = fromFile(text);
    engine.functions.checkKeys(text);
    return value;
  };
  const { state, failure } = await take("file", unwrap, engine, habits);
  if (state) return { state, failure: null };
  const { problems } = failure;
  const told = OTHERS.includes(problems[0].code) ? [...problems, { code: "what_opens" }] : problems;
  return { state, failure: { ...failure, problems: told, name } };
}

/**
 * @param {string} text
 * @param {Engine} engine
 * @returns {boolean} whether the text comes from another program
 */
export function isForeign(text, engine) {
  return engine.functions.isImport(text.slice(0, MAX_FOREIGN));
}

/**
 * Imports a mechanism of another program, from a file or from a pasted URL or text.
 * @param {string} text
 * @param {string | null} name of the file; null for pasted text
 * @param {Engine} engine
 * @param {Habits} habits
 * @returns {Promise<Taken>}
 */
export async function takeForeign(text, name, engine, habits) {
  /** @type {readonly Problem[]} */
  let lost = [];
  let from = name ?? "";
  const unwrap = () => {
    const { read: { kind, document }, left_out } = engine.functions.readImport(text.slice(0, MAX_FOREIGN));
    lost = left_out;
    if ("source" in document) from ||= document.source ?? "";
    const title = name && { title: name.replace(EXTENSION, "").slice(0, MAX_TITLE) };
    return { format: 2, kind, document: { ...document, ...title }, view: usualView({ lang: habits.lang }) };
  };
  const { state, failure } = await take(name === null ? "pasted" : "file", unwrap, engine, habits);
  if (!state) return { state, failure: { ...failure, name: from } };
  return { state, failure: lost.length > 0 ? { kind: "import", problems: lost, name: from } : null };
}

/**
 * Finds the first state: that of the address, or else the stored one, or else the first preset. Collects failures on the way, and puts a stored
 * state aside that cannot be read. A page embedded in another has no storage.
 * @param {Engine} engine
 * @param {Habits} habits
 * @returns {Promise<Opening>}
 */
export async function open(engine, habits) {
  /** @type {Failure[]} */
  const failures = [];
  takeUpAddress();
  const address = await takeAddress(location.href, engine, habits);
  const text = habits.embedding ? null : stored();
  const bare = () => fromFile(text ?? "");
  const kept = () => withImage(bare());
  const pictured = Boolean(Object(attempt(bare).value).picture);
  /**
   * Opens a state, and reports that its picture is missing if the stored state had one.
   * @param {State} state
   */
  const said = (state) => {
    if (pictured && !state.picture) failures.push({ kind: "picture", problems: [{ code: "picture_lost" }] });
    return { state, failures };
  };
  if (address?.state) {
    // An address holds no picture. If its drawing is the stored one, the stored picture is put behind it.
    const { state } = address;
    const { state: last } = pictured ? await take("kept", kept, engine, habits) : { state: null };
    const same = last?.kind === state.kind && JSON.stringify(last.document) === JSON.stringify(state.document);
    return same ? said(withExtras(state, { picture: last.picture })) : { state, failures };
  }
  if (address) failures.push(address.failure);
  if (text !== null) {
    const { state, failure } = await take("kept", kept, engine, habits);
    if (state) return said(state);
    putAside(text);
    failures.push(failure);
  }
  const { calm, lang, projector } = habits;
  const [{ kind, document }] = engine.catalogue.mixers;
  return { state: initialState(kind, document, { playing: !calm, lang, projector: projector ?? false }), failures };
}
