// Export of motion: animations, and several poses in one picture. The modules that write the files load on demand.
import { awaited } from "assur/app/busy.js";
import { LOST } from "assur/app/notices.js";
import { sentence } from "assur/controls/problems.js";
import { make } from "assur/core/dom.js";
import { download } from "assur/core/download.js";
import { problemsOf } from "assur/core/problem.js";
import { measured } from "assur/core/units.js";

/** @typedef {import("assur/export/moments.js").Job} Job */

/**
 * Choices in the dialog. `WIDTHS`: in pixels. `MOMENTS`: pictures per period. `SECONDS`: duration of a period.
 * `POSES`: number of poses in one picture. `USUAL`: the initial choices.
 */
const WIDTHS = Object.freeze([320, 480, 640, 800, 1280]);
const MOMENTS = Object.freeze([12, 24, 36, 48, 72]);
const SECONDS = Object.freeze([2, 3, 4, 6, 12]);
const POSES = Object.freeze([4, 6, 8, 12, 18, 24]);
/** Least width at which drawing and plots together can be read, in pixels. */
const WIDE = 800;
const USUAL = Object.freeze({ width: 480, moments: 48, seconds: 4, poses: 8 });

/**
 * Makes the part of the export dialog for animations and for several poses in one picture.
 * @param {import("assur/app/page.js").Page} page
 * @param {import("assur/canvas/theme.js").Theme} theme
 * @param {string} name first part of the file names
 * @param {() => string} title gives a description of the picture
 * @param {HTMLElement} said element for the result: the name of the written file, the reason for a failure, or a note that the work was cancelled
 * @returns {{ rows: (Node | string)[], working: HTMLElement, stop: () => void }} `rows`: elements of the dialog. `working`: progress, shown while a
 * file is written. `stop`: cancels the work
 */
export function animations(page, theme, name, title, said) {
  const { words } = page;
  const bar = make("progress", { id: "export-progress", max: "1", value: "0", "data-t-label": "export.progress" });
  const cancel = make("button", { id: "export-cancel", class: "control", type: "button", "data-t": "export.cancel" });
  const working = make("div", { id: "export-working", hidden: "" }, [bar, cancel]);
  /** @type {AbortController | null} */
  let running = null;
  /** @type {HTMLButtonElement[]} */
  const buttons = [];

  /**
   * Writes a file, unless another is being written. No file is saved if the work is cancelled.
   * @param {string} file
   * @param {(work: Job) => Promise<Blob>} make
   */
  const write = async (file, make) => {
    if (running) return;
    const own = new AbortController();
    running = own;
    bar.value = 0;
    working.hidden = false;
    said.textContent = "";
    for (const button of buttons) button.setAttribute("aria-disabled", "true");
    try {
      const blob = await make({ signal: own.signal, tell: (share) => { bar.value = share; } });
      own.signal.throwIfAborted();
      download(blob, file);
      said.textContent = words.text("export.written", { name: file, size: words.numbers.upTo(blob.size / 1000, 0) });
    } catch (thrown) {
      const problems = problemsOf(thrown);
      if (own.signal.aborted || (thrown instanceof DOMException && thrown.name === "AbortError")) said.textContent = words.text("export.cancelled");
      else if (problems) said.textContent = problems.map((problem) => sentence(problem, words)).join(" ");
      else {
        console.error(thrown);
        page.notices.tell(LOST);
      }
    } finally {
      running = null;
      // Moves the focus away before the cancel button disappears.
      if (document.activeElement === cancel) buttons[0]?.focus();
      working.hidden = true;
      for (const button of buttons) button.removeAttribute("aria-disabled");
    }
  };
  cancel.addEventListener("click", () => running?.abort());

  const select = (/** @type {keyof typeof USUAL} */ what, /** @type {readonly number[]} */ values, /** @type {(value: number) => string} */ text) => {
    const made = make("select", { id: `export-${what}`, class: "control", "aria-labelledby": `export-${what}-name` });
    made.append(...values.map((value) => make("option", { value: `${value}` }, [text(value)])));
    made.value = `${USUAL[what]}`;
    return made;
  };
  const width = select("width", WIDTHS, (value) => words.text("export.pixels", { n: `${value}` }));
  const moments = select("moments", MOMENTS, String);
  const seconds = select("seconds", SECONDS, (value) => measured(`${value}`, words.text("unit.s")));
  const poses = select("poses", POSES, String);
  const head = (/** @type {string} */ id, /** @type {string} */ key) => make("span", { id, "data-t": key });
  const button = (/** @type {string} */ part, /** @type {string} */ format, /** @type {(work: Job) => Promise<Blob>} */ make_) => {
    const id = `export-${part}-${format}`;
    const made = make("button", { id, class: "control", type: "button", "aria-labelledby": `export-${part} ${id}` }, [format === "webm" ? "WebM" : format.toUpperCase()]);
    made.addEventListener("click", () => write(`${name}-${part}.${format}`, make_));
    buttons.push(made);
    return made;
  };
  const shows = make("select", { id: "export-shows", class: "control", "aria-labelledby": "export-shows-name" });
  shows.append(make("option", { value: "drawing", "data-t": "export.shows.drawing" }), make("option", { value: "plots", "data-t": "export.shows.plots" }));
  shows.addEventListener("change", () => {
    if (shows.value === "plots" && Number(width.value) < WIDE) width.value = `${WIDE}`;
  });
  const wishes = () => ({ plots: shows.value === "plots", width: Number(width.value), moments: Number(moments.value), seconds: Number(seconds.value) });

  const gif = button("animation", "gif", async (work) => {
    const { toGif } = await awaited(import("assur/export/gif.js"));
    return toGif(page, theme, wishes(), work);
  });
  const svg = button("animation", "svg", async (work) => {
    const { toMovingSvg } = await awaited(import("assur/export/moving-svg.js"));
    return toMovingSvg(page, theme, wishes(), work, title());
  });
  const webm = button("animation", "webm", async (work) => {
    const { toWebm } = await awaited(import("assur/export/webm.js"));
    return toWebm(page, theme, wishes(), work);
  });
  const silent = make("span", { id: "export-no-webm", class: "note", "data-t": "export.no_webm" });
  const posesSvg = button("several", "svg", async (work) => {
    const { posesAsSvg } = await awaited(import("assur/export/moving-svg.js"));
    return posesAsSvg(page, theme, Number(poses.value), work, title());
  });
  const posesPng = button("several", "png", async (work) => {
    const { posesAsPng } = await awaited(import("assur/export/moving-svg.js"));
    return posesAsPng(page, theme, Number(poses.value), work);
  });
  const rows = [
    head("export-animation", "export.animation"),
    make("div", {}, [gif, svg, ...(records() ? [webm] : [silent])]),
    head("export-shows-name", "export.shows"),
    make("div", {}, [shows]),
    head("export-width-name", "export.width"),
    make("div", {}, [width]),
    head("export-moments-name", "export.moments"),
    make("div", {}, [moments]),
    head("export-seconds-name", "export.seconds"),
    make("div", {}, [seconds]),
    head("export-several", "export.poses"),
    make("div", {}, [posesSvg, posesPng, head("export-poses-name", "export.poses.count"), poses]),
  ];
  return { rows, working, stop: () => running?.abort() };
}

/** @returns {boolean} whether the browser can record a canvas */
function records() {
  return typeof MediaRecorder !== "undefined" && "captureStream" in HTMLCanvasElement.prototype && MediaRecorder.isTypeSupported("video/webm");
}
