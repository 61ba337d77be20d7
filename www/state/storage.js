// Places where the state outlives the page: the address and the browser's storage. The page also works without them.
import { toFile } from "assur/state/codec.js";
import { VIEW_KEYS } from "assur/state/coordinate.js";
import { withExtras } from "assur/state/state.js";

/** @typedef {import("assur/state/state.js").State} State */

const KEY = "assur.state";
/** Key of the image behind the drawing. It is kept apart from the state because it is long and seldom changes. */
const IMAGE = "assur.image";
/** Number of characters at the end of an image that distinguish it from other images of the same length. */
const TAIL = 48;
/** Key of the digests of lecturers' lessons with stored names and answers, the most recently used last. */
const LESSONS = "assur.lessons";
/** Limit of the number of these lessons. Without it, a classroom machine would fill up. */
const MAX_LESSONS = 40;
const OF_LESSON = /^assur\.lesson\.own\.([^.]+)/;
/** Key under which a state that could not be read is put aside instead of being overwritten. */
const UNREAD = "assur.state.unread";

/** Key, in the session storage, of two addresses: the one that a reload may still load, and the intended one. */
const LEFT = "assur.left";

/** Shortest interval between writes, in milliseconds: browsers limit how often a page may change its address. */
const PERIOD = 400;

/** @type {Map<string, string>} texts of lessons that the browser refused to keep, by name, until the page is left */
const untaken = new Map();
/** Whether there was room for the last text of a lesson. */
let lessonFits = true;
/** Reports that there is no room for a text of a lesson. */
let sayUnfit = () => {};

/** @returns {string | null} the state that was kept last */
export function stored() {
  return orNull(() => localStorage.getItem(KEY));
}

/**
 * @param {string} name of a small value outside the state
 * @returns {string | null} the value that was kept last
 */
export function kept(name) {
  return untaken.get(name) ?? orNull(() => localStorage.getItem(`assur.${name}`));
}

/**
 * @param {string} name
 * @param {string} text
 */
export function keep(name, text) {
  orNull(() => localStorage.setItem(`assur.${name}`, text));
}

/**
 * Keeps a text of a lesson. If too many lecturers' lessons have texts, the texts of the least recently used lessons are
 * removed.
 * @param {string} name id of the lesson; for a lecturer's lesson, `own.` and its digest, followed for answers by a dot and a key of the reader
 * @param {string} text
 */
export function keepLesson(name, text) {
  const key = `assur.lesson.${name}`;
  const digest = lessonOf(key);
  if (digest) orNull(() => forgetLessons(digest));
  const fits = fit(key, text);
  if (orNull(() => localStorage.getItem(key)) === text) untaken.delete(`lesson.${name}`);
  else untaken.set(`lesson.${name}`, text);
  if (lessonFits && !fits) sayUnfit();
  lessonFits = fits;
}

/** @param {string} digest of the lesson in use */
function forgetLessons(digest) {
  const keys = Array.from({ length: localStorage.length }, (_, i) => localStorage.key(i) ?? "");
  const listed = (localStorage.getItem(LESSONS) ?? "").split(" ");
  const older = [...keys.map(lessonOf).filter((one) => !listed.includes(one)), ...listed];
  const last = [...new Set(older.filter((one) => one !== "" && one !== digest)), digest].slice(-MAX_LESSONS);
  for (const key of keys) if (![...last, ""].includes(lessonOf(key))) localStorage.removeItem(key);
  localStorage.setItem(LESSONS, last.join(" "));
}

/**
 * @param {string} key
 * @returns {string} digest of the lecturer's lesson to which the key belongs, or an empty string
 */
function lessonOf(key) {
  return OF_LESSON.exec(key)?.[1] ?? "";
}

/** @param {string} text */
export function putAside(text) {
  orNull(() => localStorage.setItem(UNREAD, text));
}

/**
 * Restores the intended address after a reload. If the last change came just as the page was left, the browser may load
 * an older address. An address to which the reader navigates is not replaced.
 */
export function takeUpAddress() {
  orNull(() => {
    const [left, meant] = JSON.parse(sessionStorage.getItem(LEFT) ?? "[]");
    sessionStorage.removeItem(LEFT);
    const [entry] = performance.getEntriesByType("navigation");
    const again = entry instanceof PerformanceNavigationTiming && entry.type !== "navigate";
    if (again && left === location.href) history.replaceState(null, "", meant);
  });
}

/**
 * Keeps every change in the browser's storage and in the address. The input of a motion is kept when the motion stops or
 * the page is hidden or left.
 * @param {import("assur/state/store.js").Store<State>} store
 * @param {import("assur/state/address.js").Address} address
 * @param {(state: State) => boolean} accepts whether the engine takes the state; a refused state is not kept
 * @param {boolean} ours whether the state is kept in the browser's storage; a page in a frame of another page keeps it in the address only
 * @param {(...what: ("picture" | "state" | "lesson" | "tab")[]) => void} unkept called when there is no room for an image, a state or answers in a lesson, and
 * once when another tab keeps its own mechanism instead of this one
 */
export function persist(store, address, accepts, ours, unkept) {
  let timer = 0;
  let changed = false;
  let fitted = true;
  /** The address before its last change. A browser that is already reloading the page may load this one. */
  let before = location.href;
  const images = new KeptImage();
  const save = () => {
    clearTimeout(timer);
    timer = 0;
    const state = store.get();
    if (!changed || !accepts(state)) return;
    changed = false;
    if (ours) {
      const fits = fit(KEY, toFile(withoutImage(state)));
      /** @type {("picture" | "state")[]} */
      const lost = fitted && !fits ? ["state"] : [];
      fitted = fits;
      if (!images.keep(state.picture?.image ?? "")) lost.push("picture");
      if (lost.length > 0) unkept(...lost);
    }
    const shown = location.href;
    address.show(state);
    if (location.href !== shown) before = shown;
  };
  sayUnfit = ours ? () => unkept("lesson") : () => {};
  let alone = true;
  const onStorage = (/** @type {StorageEvent} */ { key, newValue }) => {
    if (key === IMAGE) images.forget();
    const state = store.get();
    if (!alone || key !== KEY || newValue === null || !address.isOwn(state) || shows(newValue, state)) return;
    alone = false;
    unkept("tab");
  };
  if (ours) addEventListener("storage", onStorage);
  store.subscribe((state, previous) => {
    changed = true;
    // In motion the input changes in every frame, too often to be written each time.
    if (state.view.playing && previous.view.playing && hasOnlyMoved(state, previous)) return;
    timer ||= setTimeout(save, PERIOD);
  });
  addEventListener("pagehide", () => {
    save();
    if (location.href !== before) orNull(() => sessionStorage.setItem(LEFT, JSON.stringify([before, location.href])));
  });
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) save();
  });
}

/**
 * @param {State} state
 * @param {State} previous
 * @returns {boolean} whether both states are the same except for the input
 */
function hasOnlyMoved(state, previous) {
  const parts = /** @type {(keyof State)[]} */ (Object.keys(state));
  const views = /** @type {(keyof State["view"])[]} */ (Object.keys(state.view));
  /** @type {readonly string[]} */
  const moving = VIEW_KEYS;
  return parts.every((name) => name === "view" || state[name] === previous[name])
    && views.every((name) => moving.includes(name) || state.view[name] === previous.view[name]);
}

/** The image in the browser's storage: written when it changes, removed when there is none. */
class KeptImage {
  #last = "";

  /**
   * @param {string} image
   * @returns {boolean} whether there is room for the image
   */
  keep(image) {
    if (image === this.#last) return true;
    this.#last = image;
    // The previous image would occupy the room for the new one.
    orNull(() => localStorage.removeItem(IMAGE));
    return image === "" || fit(IMAGE, image);
  }

  /** Makes the next change write this page's image again, because another tab has written its own. */
  forget() {
    this.#last = "";
  }
}

/**
 * @param {string} key
 * @param {string} text
 * @returns {boolean} false if there is no room for the text; true if it was written or if storage is forbidden altogether
 */
function fit(key, text) {
  try {
    localStorage.setItem(key, text);
    return true;
  } catch (thrown) {
    return !(thrown instanceof DOMException) || thrown.name === "SecurityError";
  }
}

/**
 * @param {string} text state as it was kept
 * @param {State} state
 * @returns {boolean | null} whether both states are the same except for the view; null if the text cannot be read
 */
function shows(text, state) {
  const rest = (/** @type {Partial<State>} */ { view, ...more }) => JSON.stringify(more);
  return orNull(() => rest(JSON.parse(text)) === rest(withoutImage(state)));
}

/** @param {string} image */
function signOf(image) {
  return `${image.length} ${image.slice(-TAIL)}`;
}

/**
 * @param {State} state
 * @returns {State} the state with a short text in place of the image, by which {@link withImage} recognises it
 */
function withoutImage(state) {
  const { picture } = state;
  return picture ? withExtras(state, { picture: { ...picture, image: signOf(picture.image) } }) : state;
}

/**
 * @param {unknown} value state as it was kept
 * @returns {unknown} the state with its image, or without a picture if the image was not kept
 */
export function withImage(value) {
  const { picture, ...rest } = Object(value);
  if (!picture) return value;
  const image = orNull(() => localStorage.getItem(IMAGE));
  return image !== null && signOf(image) === picture.image ? { ...rest, picture: { ...picture, image } } : rest;
}

/**
 * @template T
 * @param {() => T} work
 * @returns {T | null} null if the work throws, as when the browser forbids storage
 */
export function orNull(work) {
  try {
    return work();
  } catch {
    return null;
  }
}
