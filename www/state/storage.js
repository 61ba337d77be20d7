// Where the state outlives the page: the address and the browser's own store. Both may be forbidden; the page then does without.
import { toFile } from "assur/state/codec.js";
import { withFurther } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 */

const KEY = "assur.state";
/** The image of a picture behind the drawing by itself: it is long, and seldom another. */
const IMAGE = "assur.image";
/** Characters at the end of an image that distinguish it from others of its length. */
const TAIL = 48;
/** Digests of the lecturers' lessons of which answers and names are kept, the one that was worked on last at the end. */
const LESSONS = "assur.lessons";
/** How many they may be: on a machine in a classroom they would become ever more. */
const MOST_LESSONS = 40;
const OF_LESSON = /^assur\.lesson\.own\.([^.]+)/;
/** What could not be read is not written over but put aside. */
const ASIDE = "assur.state.unread";

/** Of a visit: the address at which the page was left, and the one that was meant. */
const LEFT = "assur.left";

/** Not more often than this, in milliseconds: browsers limit how often an address may change. */
const PERIOD = 400;

/** @type {Map<string, string>} what lessons gave to be kept and the browser did not take, by name: there until the page is left */
const untaken = new Map();
/** Whether the last that a lesson gave did fit. */
let lessonFits = true;
/** Says that what a lesson gave does not fit. */
let sayUnfit = () => {};

/** @returns {string | null} what was kept last */
export function stored() {
  return guarded(() => localStorage.getItem(KEY));
}

/**
 * @param {string} name of something small that is no part of the state
 * @returns {string | null} what was kept of it last
 */
export function kept(name) {
  return untaken.get(name) ?? guarded(() => localStorage.getItem(`assur.${name}`));
}

/**
 * @param {string} name
 * @param {string} text
 */
export function keep(name, text) {
  guarded(() => localStorage.setItem(`assur.${name}`, text));
}

/**
 * Keeps what belongs to a lecturer's lesson; that of the lessons that were worked on longest ago is forgotten.
 * @param {string} name `own`, the digest of the lesson, and what more tells it from the rest of that lesson
 * @param {string} text
 */
export function keepLesson(name, text) {
  const key = `assur.lesson.${name}`;
  const digest = lessonOf(key);
  if (digest) guarded(() => forgetLessons(digest));
  const fits = fit(key, text);
  if (guarded(() => localStorage.getItem(key)) === text) untaken.delete(`lesson.${name}`);
  else untaken.set(`lesson.${name}`, text);
  if (lessonFits && !fits) sayUnfit();
  lessonFits = fits;
}

/** @param {string} digest of the lesson that is worked on */
function forgetLessons(digest) {
  const keys = Array.from({ length: localStorage.length }, (_, i) => localStorage.key(i) ?? "");
  const listed = (localStorage.getItem(LESSONS) ?? "").split(" ");
  const older = [...keys.map(lessonOf).filter((one) => !listed.includes(one)), ...listed];
  const last = [...new Set(older.filter((one) => one !== "" && one !== digest)), digest].slice(-MOST_LESSONS);
  for (const key of keys) if (![...last, ""].includes(lessonOf(key))) localStorage.removeItem(key);
  localStorage.setItem(LESSONS, last.join(" "));
}

/**
 * @param {string} key
 * @returns {string} the digest of the lecturer's lesson to which it belongs; none where it belongs to none
 */
function lessonOf(key) {
  return OF_LESSON.exec(key)?.[1] ?? "";
}

/** @param {string} text */
export function putAside(text) {
  guarded(() => localStorage.setItem(ASIDE, text));
}

/**
 * A page that is left writes its last change into an address that the browser may have taken already, to load it anew:
 * then the one that was meant is put there. What somebody goes to is what it says.
 */
export function takeUpAddress() {
  guarded(() => {
    const [left, meant] = JSON.parse(sessionStorage.getItem(LEFT) ?? "[]");
    sessionStorage.removeItem(LEFT);
    const [entry] = performance.getEntriesByType("navigation");
    const again = entry instanceof PerformanceNavigationTiming && entry.type !== "navigate";
    if (again && left === location.href) history.replaceState(null, "", meant);
  });
}

/**
 * From now on every change is kept, in the browser and in the address; a turning crank alone is none.
 * @param {import("assur/state/store.js").Store<State>} store
 * @param {import("assur/state/address.js").Address} address
 * @param {(state: State) => boolean} sound whether the engine takes the state; another is not kept
 * @param {boolean} ours whether the browser keeps it: what another page shows in a frame is in the address only
 * @param {(...what: ("picture" | "state" | "lesson" | "tab")[]) => void} unkept called where an image, a state, or answers in a lesson, do not fit into what it keeps, and
 * once where another tab keeps its own mechanism instead of this one
 */
export function persist(store, address, sound, ours, unkept) {
  let timer = 0;
  let changed = false;
  let fitted = true;
  const images = new KeptImage();
  const save = () => {
    clearTimeout(timer);
    timer = 0;
    const state = store.get();
    if (!changed || !sound(state)) return;
    changed = false;
    if (ours) {
      const fits = fit(KEY, toFile(withoutImage(state)));
      /** @type {("picture" | "state")[]} */
      const lost = fitted && !fits ? ["state"] : [];
      fitted = fits;
      if (!images.keep(state.picture?.image ?? "")) lost.push("picture");
      if (lost.length > 0) unkept(...lost);
    }
    address.show(state);
  };
  sayUnfit = ours ? () => unkept("lesson") : () => {};
  let alone = true;
  const hear = (/** @type {StorageEvent} */ { key, newValue }) => {
    if (key === IMAGE) images.forget();
    const state = store.get();
    if (!alone || key !== KEY || newValue === null || !address.isOwn(state) || shows(newValue, state)) return;
    alone = false;
    unkept("tab");
  };
  if (ours) addEventListener("storage", hear);
  store.subscribe((state, previous) => {
    changed = true;
    // A turning crank alone is written when the page is left.
    if (state.view.playing && previous.view.playing && state.document === previous.document) return;
    timer ||= setTimeout(save, PERIOD);
  });
  addEventListener("pagehide", () => {
    const left = location.href;
    save();
    if (location.href !== left) guarded(() => sessionStorage.setItem(LEFT, JSON.stringify([left, location.href])));
  });
  document.addEventListener("visibilitychange", () => {
    if (document.hidden) save();
  });
}

/** The image that is kept: written where it is another than the last, taken away where there is none any more. */
class KeptImage {
  #last = "";

  /**
   * @param {string} image
   * @returns {boolean} whether there is room for it
   */
  keep(image) {
    if (image === this.#last) return true;
    this.#last = image;
    // The one before would take the room.
    guarded(() => localStorage.removeItem(IMAGE));
    return image === "" || fit(IMAGE, image);
  }

  /** Another tab has written its own: with the next change that of this one is written again. */
  forget() {
    this.#last = "";
  }
}

/**
 * @param {string} key
 * @param {string} text
 * @returns {boolean} false where there is no room for it; what is forbidden altogether is no want of room
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
 * @param {string} text what was kept
 * @param {State} state
 * @returns {boolean | null} whether it is the same but for the view; null where it cannot be read
 */
function shows(text, state) {
  const rest = (/** @type {Partial<State>} */ { view, ...more }) => JSON.stringify(more);
  return guarded(() => rest(JSON.parse(text)) === rest(withoutImage(state)));
}

/** @param {string} image */
function signOf(image) {
  return `${image.length} ${image.slice(-TAIL)}`;
}

/**
 * @param {State} state
 * @returns {State} with a sign of the image of its picture instead of the image
 */
function withoutImage(state) {
  const { picture } = state;
  return picture ? withFurther(state, { picture: { ...picture, image: signOf(picture.image) } }) : state;
}

/**
 * @param {unknown} value what was kept of a state
 * @returns {unknown} the same with the image of its picture; where that was not kept, without a picture
 */
export function withImage(value) {
  const { picture, ...rest } = Object(value);
  if (!picture) return value;
  const image = guarded(() => localStorage.getItem(IMAGE));
  return image !== null && signOf(image) === picture.image ? { ...rest, picture: { ...picture, image } } : rest;
}

/**
 * @template T
 * @param {() => T} work
 * @returns {T | null} null where the browser forbids it
 */
export function guarded(work) {
  try {
    return work();
  } catch {
    return null;
  }
}
