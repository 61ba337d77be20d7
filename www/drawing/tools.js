// The drawing tools, and the effect of a press with each tool. Presses are remembered until a tool has enough of them.
import { edit, refuse } from "assur/drawing/edit.js";
import { BackPicture } from "assur/drawing/picture.js";

/**
 * @typedef {import("assur/types/edit.js").End} End
 * @typedef {import("assur/types/edit.js").Outer} Outer
 * @typedef {readonly [number, number]} Point in the model
 * @typedef {{ point: string | null, link: string | null, wheel: string | null, at: Point }} Target target of a press: a
 * point, or else a link, or else the paper. `wheel`: the wheel under the press, even if a point or link lies over the
 * wheel; an internal gear is hit only at its rim
 * @typedef {Readonly<{ name: string, key: string, icon: string, prompts: readonly string[] }>} Tool `key`: key that
 * chooses the tool, together with Alt. `prompts`: names of the prompts in order; for a dyad, by kind of pair
 * @typedef {{ pressed: Target[], loose: boolean }} Chain unfinished bars, with the presses from which they go on.
 * `loose`: whether the last bar ends at a new point that is neither on another link nor on the frame
 */

/** Greatest slope, to the horizontal or the vertical, of a line that is made exactly horizontal or vertical. */
const LEVEL = Math.tan(Math.PI / 24);

/** The five dyads by their pairs, in the order first outer pair, inner pair, last outer pair. */
export const DYADS = Object.freeze(["RRR", "RRP", "RPR", "PRP", "RPP"]);

/** @type {readonly Tool[]} */
export const TOOLS = Object.freeze([
  { name: "select", key: "V", icon: "M6 3l12 9-6 1 3 6-2.5 1-3-6L6 18z", prompts: ["select_1"] },
  { name: "bars", key: "B", icon: "M5 19 12 7l7 9M5 19h.01M12 7h.01M19 16h.01", prompts: ["bars_1", "bars_2"] },
  { name: "plate", key: "C", icon: "M5 18 11 5l8 10z", prompts: ["plate_1", "plate_2"] },
  { name: "slide", key: "K", icon: "M3 17h18M8 9h8v6H8zM12 12h.01", prompts: ["slide_1", "slide_2"] },
  { name: "fix", key: "F", icon: "M12 5 7 15h10zM4 15h16M6 15l-2 4M11 15l-2 4M16 15l-2 4", prompts: ["fix_1"] },
  { name: "drive", key: "D", icon: "M5.5 13.5a7 7 0 1 1 2.6 5.2M12 12l4-5M4 9l1.5 4.5L10 12", prompts: ["drive_1"] },
  { name: "dyad", key: "Y", icon: "M4 18 12 6l8 12M4 18h.01M12 6h.01M20 18h.01M9 19h6", prompts: ["dyad_R", "dyad_P"] },
  { name: "triad", key: "3", icon: "M9 9h6l-3 6zM9 9 4 5M15 9l5-4M12 15v5", prompts: ["triad_1", "triad_2", "triad_3"] },
  { name: "wheel", key: "W", icon: "M12 5a7 7 0 1 0 .01 0zM12 12h.01M12 2v3M12 19v3M2 12h3M19 12h3", prompts: ["wheel_1"] },
  { name: "mesh", key: "M", icon: "M7 7a5 5 0 1 0 .01 0zM17.5 9.5a3 3 0 1 0 .01 0z", prompts: ["mesh_1", "mesh_2"] },
  { name: "tracer", key: "T", icon: "M3 17C5 7 11 4 15 7s3 8-2 8M12 15h.01M18 15v6M15 18h6", prompts: ["tracer_1"] },
  { name: "mass", key: "S", icon: "M12 4a8 8 0 1 0 .01 0zM12 4v16M4 12h16", prompts: ["mass_1"] },
  { name: "picture", key: "P", icon: "M4 5h16v14H4zM4 16l5-5 4 4 3-3 4 4M15.5 9h.01", prompts: ["picture_none", "picture_1", "picture_2"] },
  { name: "remove", key: "X", icon: "M6 6l12 12M18 6 6 18", prompts: ["remove_1"] },
]);

/** State that the tools share, and the edits that they make. */
export class Work {
  #page;
  /** Name of the tool in use. */
  tool = "select";
  /** Pairs of the dyad to add. */
  dyad = DYADS[0];
  /** Numbers of teeth of wheels to be meshed. */
  teeth = /** @type {[number, number]} */ ([20, 40]);
  internal = false;
  picture;
  /** @type {Target[]} presses not yet used */
  pressed = [];
  #loose = false;
  /** @type {WeakMap<object, Chain>} chains by the drawings that their presses made, to which undo and redo return */
  #chains = new WeakMap();
  /** Drawing for which `pressed` is valid. */
  #known = {};

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.picture = new BackPicture(page);
  }

  /** @param {string} tool tool to use; presses not yet used are forgotten */
  take(tool) {
    this.tool = tool;
    this.rest();
  }

  /** Index of the current prompt of the tool in use. */
  get stage() {
    if (this.tool !== "picture") return this.pressed.length;
    return this.picture.there ? 1 + (this.picture.marks.length % 2) : 0;
  }

  /** Forgets the presses not yet used, and all chains. */
  rest() {
    this.#chains = new WeakMap();
    this.#end();
  }

  /**
   * Applies a press to the tool in use. The state of unfinished bars is remembered for undo and redo.
   * @param {Target} target
   */
  press(target) {
    const act = ACTS[this.tool];
    if (act) act(this, target);
    this.#known = this.#document;
    if (this.tool === "bars") this.#chains.set(this.#document, { pressed: this.pressed, loose: this.#loose });
  }

  /**
   * Adapts the presses to a drawing that was not changed by a press: after undo and redo, bars go on from the last point
   * that the drawing then has. Presses on points that no longer exist are forgotten.
   */
  follow() {
    const document = this.#document;
    if (document === this.#known) return;
    this.#known = document;
    const chain = this.#chains.get(document);
    const names = new Set(document.points.map(({ name }) => name));
    if (chain) [this.pressed, this.#loose] = [chain.pressed, chain.loose];
    else if (this.pressed.some(({ point }) => point !== null && !names.has(point))) this.#end();
  }

  #end() {
    this.pressed = [];
    this.#loose = false;
  }

  get #document() {
    return /** @type {import("assur/state/state.js").LinkageDocument} */ (this.#page.store.get().document);
  }

  /**
   * @param {import("assur/types/edit.js").Edit} wanted
   * @returns {import("assur/drawing/edit.js").Drawn | null}
   */
  do(wanted) {
    return edit(this.#page, wanted);
  }

  /** @param {string} code of a problem with the press */
  refuse(code) {
    refuse(this.#page, code);
  }

  /**
   * Shows the message that a new end lies on a link, because the press may have hit the link by accident.
   * @param {Target} target
   * @param {string | null | undefined} made name of the new end
   */
  #tell({ point, link }, made) {
    // The link may be named after its points, so its name may have changed. Bars made with the end come after the link.
    const name = made && this.#document.links.find(({ points }) => points.includes(made))?.name;
    if (!point && link && name) refuse(this.#page, "on_link", { point: made, link: name });
  }

  /**
   * Moves the target of a press on a link to the link's first point: that point will slide, and its guide starts there.
   * @param {Target} target
   * @returns {Target}
   */
  guided(target) {
    if (target.point || !target.link) return target;
    const first = this.#document.links.find(({ name }) => name === target.link)?.points[0];
    const joint = this.#page.mechanism.joints().find(({ name }) => name === first);
    return joint ? { ...target, at: [joint.x, joint.y] } : target;
  }

  /**
   * Collects presses until there are enough.
   * @param {Target} target
   * @param {number} count
   * @returns {readonly Target[] | null}
   */
  gather(target, count) {
    this.pressed.push(target);
    if (this.pressed.length < count) return null;
    const all = this.pressed;
    this.pressed = [];
    return all;
  }

  /**
   * Draws bar after bar. A first end on the paper is fixed to the frame. A second press on the last end finishes the
   * bars; a last end on the paper is then fixed to the frame, too.
   * @param {Target} target
   */
  bars(target) {
    const [from] = this.pressed;
    if (!from) {
      this.#begin(target);
      return;
    }
    if (target.point === from.point && from.point) {
      if (this.#loose) this.do({ edit: "fix", point: from.point });
      this.#end();
      return;
    }
    const made = this.do({ edit: "bar", ends: [end(from), end(target)] });
    if (!made) return;
    this.#tell(target, made.point);
    // A bar that ends at an existing point is the last one.
    this.pressed = target.point || !made.point ? [] : [{ ...target, point: made.point, link: null, wheel: null }];
    this.#loose = !target.point && !target.link;
  }

  /** @param {Target} target */
  #begin(target) {
    this.#loose = false;
    if (target.point) {
      this.pressed = [target];
      return;
    }
    const { link, at } = target;
    const made = this.do(link ? { edit: "corner", link, end: { at: [...at] } } : { edit: "point", at: [...at], fixed: true });
    this.#tell(target, made?.point);
    if (made?.point) this.pressed = [{ ...target, point: made.point, link: null, wheel: null }];
  }
}

/** @type {Readonly<Record<string, (work: Work, target: Target) => void>>} */
const ACTS = Object.freeze({
  bars: (work, target) => work.bars(target),
  plate: (work, target) => {
    const [first] = work.pressed;
    if (!first && !target.link) work.refuse("press_link");
    else {
      const both = work.gather(target, 2);
      if (both?.[0].link) work.do({ edit: "corner", link: both[0].link, end: both[1].point ? { point: both[1].point } : { at: [...both[1].at] } });
    }
  },
  slide: (work, target) => {
    const both = work.gather(work.pressed.length === 0 ? work.guided(target) : target, 2);
    if (!both) return;
    const [first, second] = both;
    const along = second.link && !second.point ? { link: second.link } : { toward: level(first.at, second.at) };
    if (!first.point && first.link) work.do({ edit: "slide", link: first.link, along });
    else work.do({ edit: "block", end: end(first), along });
  },
  fix: (work, { point, wheel, at }) => {
    if (point) work.do({ edit: "fix", point });
    else if (wheel) work.do({ edit: "weld", links: [wheel, "frame"] });
    else work.do({ edit: "point", at: [...at], fixed: true });
  },
  drive: (work, { link }) => {
    if (link) work.do({ edit: "drive", link });
    else work.refuse("press_link");
  },
  dyad: (work, target) => {
    const both = work.gather(target, 2);
    if (!both) return;
    const [first, inner, last] = work.dyad;
    const outer = /** @type {[Outer, Outer]} */ ([outerPair(first, both[0]), outerPair(last, both[1])]);
    work.do({ edit: "dyad", outer, inner: inner === "R" ? "hinge" : "slide" });
  },
  triad: (work, target) => {
    const three = work.gather(target, 3);
    if (three) work.do({ edit: "triad", ends: /** @type {[End, End, End]} */ (three.map(pivot)) });
  },
  wheel: (work, target) => work.do({ edit: "wheel", end: pivot(target) }),
  mesh: (work, pressed) => {
    const target = { ...pressed, link: pressed.wheel ?? pressed.link };
    if (!target.link) work.refuse("press_link");
    else {
      const both = work.gather(target, 2);
      if (both?.[0].link && both[1].link) work.do({ edit: "mesh", links: [both[0].link, both[1].link], teeth: [...work.teeth], internal: work.internal });
    }
  },
  tracer: (work, { link, at }) => {
    if (link) work.do({ edit: "trace", link, at: [...at] });
    else work.refuse("press_link");
  },
  mass: (work, { link, at }) => {
    if (link) work.do({ edit: "mass", link, at: [...at] });
    else work.refuse("press_link");
  },
  picture: ({ picture }, { at }) => picture.mark(at),
  remove: (work, { point, link, wheel }) => {
    // A wheel at a point is removed alone. The other links keep the point.
    const gone = (point && wheel) || (point ? null : link);
    if (gone) work.do({ edit: "remove", points: [], links: [gone] });
    else if (point) work.do({ edit: "remove", points: [point], links: [] });
  },
});

/**
 * @param {Target} target
 * @returns {End}
 */
function end({ point, link, at }) {
  if (point) return { point };
  return link ? { on: [link, [...at]] } : { at: [...at] };
}

/**
 * An outer joint of a new part: on the paper it is fixed to the frame.
 * @param {Target} target
 * @returns {End}
 */
function pivot(target) {
  return target.point || target.link ? end(target) : { fixed: [...target.at] };
}

/**
 * @param {string} letter of the pair: R or P
 * @param {Target} target
 * @returns {Outer}
 */
function outerPair(letter, target) {
  if (letter === "R") return { hinge: pivot(target) };
  return target.link ? { slide: [target.link, [...target.at]] } : { level: [...target.at] };
}

/**
 * @param {Point} from
 * @param {Point} to
 * @returns {[number, number]} the second point, moved if need be so that a nearly horizontal or vertical line is exact
 */
export function level([x, y], [right, up]) {
  const [dx, dy] = [right - x, up - y];
  if (Math.abs(dy) <= LEVEL * Math.abs(dx)) return [right, y];
  return Math.abs(dx) <= LEVEL * Math.abs(dy) ? [x, up] : [right, up];
}
