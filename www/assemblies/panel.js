// Panel of all assemblies at the current input: a picture of each, the assemblies that can and cannot be reached from
// the shown one, and a map of the branches.
import "assur/assemblies/style.js";
import { BranchMap } from "assur/assemblies/map.js";
import { Motions } from "assur/assemblies/motions.js";
import { Transform } from "assur/canvas/transform.js";
import { byId, make, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { attempt } from "assur/core/problem.js";
import { subscript, symbol } from "assur/core/symbols.js";
import { Figure } from "assur/stage/figure.js";
import { change } from "assur/state/change.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").AssembliesHere} Here
 */

/** Margin around the linkage in a picture, in pixels. */
const MARGIN = 7;
/** Shortest time between two paintings of the pictures, in milliseconds; frames between are for the main drawing. */
const PERIOD = 30;

export class Assemblies {
  #page;
  #figure;
  #motions;
  #map;
  #count = make("p", { id: "assembly-count" });
  #pictures = make("div", { id: "assembly-pictures", class: "assembly-pictures", role: "group", "data-t-label": "assemblies.pictures" });
  #where = make("p", { id: "assembly-where", role: "status" });
  #reach = make("ul", { id: "assembly-reach" });
  #mapped = make("p", { id: "assembly-mapped" });
  /** @type {Here | null} */
  #here = null;
  /** @type {Snapshot | null} */
  #snapshot = null;
  /** `#bounds`: rectangle around all assemblies shown so far. `#revision`: revision of their linkage. */
  #bounds = [Infinity, Infinity, -Infinity, -Infinity];
  #revision = 0;
  /** `#painted`: time of the last painting. `#later`: whether another is scheduled. */
  #painted = -Infinity;
  #later = false;
  /** @type {object | null} data of the drawn map */
  #drawn = null;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#figure = new Figure(page.engine, page.theme);
    this.#motions = new Motions(() => page.redraw());
    this.#map = new BranchMap((input, output) => this.#choose(input, output));
    this.element = make("section", { id: "assemblies-shown", "data-field": "all_assemblies" }, [
      make("h2", { "data-t": "assemblies.heading" }),
      this.#count, this.#pictures, this.#where, this.#reach, this.#map.element, this.#mapped,
    ]);
    byId("fold-structure", HTMLElement).after(this.element);
    page.words.fill(this.element);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, frameInput, stale } = snapshot;
    if (stale) return;
    this.#snapshot = snapshot;
    // A document that is not a linkage has no assemblies.
    this.#here = (state.view.all_assemblies && attempt(() => this.#page.engine.simulator.assemblies(frameInput)).value) || null;
    this.element.hidden = !this.#here;
    if (!state.view.all_assemblies) this.#motions.close();
    if (!this.#here) return;
    this.#motions.of(snapshot.revision, state);
    this.#show(this.#here, snapshot);
    if (this.#due()) this.#paint(this.#here, snapshot);
    if (snapshot.numbersDue) this.#tell(this.#here, snapshot);
    this.#draw(this.#here, snapshot);
  }

  /** Returns whether the pictures are due now. If they are not, schedules another frame. */
  #due() {
    const now = performance.now();
    const due = now - this.#painted >= PERIOD;
    if (due) this.#painted = now;
    else if (!this.#later) {
      this.#later = true;
      setTimeout(() => {
        this.#later = false;
        this.#page.redraw();
      }, PERIOD);
    }
    return due;
  }

  /**
   * Shows a button for each assembly; the button of the shown assembly is pressed.
   * @param {Here} here
   * @param {Snapshot} snapshot
   */
  #show({ all, shown }, { words }) {
    render(all.map((one, k) => {
      const number = words.numbers.exact(one.number);
      return html`<button type="button" class="control" id="assembly-${k + 1}-picture" aria-pressed=${k === shown}
        aria-label=${words.text("assemblies.name", { number })} @click=${() => this.#follow(k)}><canvas aria-hidden="true"></canvas><span>${number}</span></button>`;
    }), this.#pictures);
  }

  /**
   * @param {Here} here
   * @param {Snapshot} snapshot
   */
  #paint({ all }, snapshot) {
    if (this.#revision !== snapshot.revision) this.#bounds = [...snapshot.summary.bounds];
    this.#revision = snapshot.revision;
    for (const { bodies } of all) this.#hold(bodies);
    this.#pictures.querySelectorAll("canvas").forEach((canvas, k) => {
      const { bodies } = all[k];
      const { clientWidth: width, clientHeight: height } = canvas;
      const context = canvas.getContext("2d");
      if (!context || width === 0) return;
      const ratio = globalThis.devicePixelRatio || 1;
      const [across, down] = [Math.round(width * ratio), Math.round(height * ratio)];
      if (canvas.width !== across) canvas.width = across;
      if (canvas.height !== down) canvas.height = down;
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clearRect(0, 0, across, down);
      this.#figure.take({ ...snapshot, frame: Float32Array.from(bodies) });
      this.#figure.paintMoving({ context, ratio }, Transform.fit(this.#bounds, width, height, MARGIN));
    });
  }

  /**
   * Enlarges the rectangle to contain the origins of the moving bodies.
   * @param {readonly number[]} bodies number of bodies, then x, y and angle of each; the first body is the frame
   */
  #hold(bodies) {
    const bounds = this.#bounds;
    for (let at = 4; at + 1 < bodies.length; at += 3) {
      const [x, y] = [bodies[at], bodies[at + 1]];
      if (x < bounds[0]) bounds[0] = x;
      if (y < bounds[1]) bounds[1] = y;
      if (x > bounds[2]) bounds[2] = x;
      if (y > bounds[3]) bounds[3] = y;
    }
  }

  /**
   * Writes the number of assemblies, and lists those that can and cannot be reached.
   * @param {Here} here
   * @param {Snapshot} snapshot
   */
  #tell({ all, shown, complex, whole }, { frameInput, state, words }) {
    const { numbers } = words;
    const count = complex === null ? words.counted("assemblies.count", all.length) : words.counted("assemblies.count_of", all.length, { complex: numbers.exact(complex) });
    write(this.#count, whole ? count : `${count} ${words.text("assemblies.partial")}`);
    if (shown === null) return;
    // The worker is asked only at rest. In motion, the branch stays the same.
    if (!state.view.playing) this.#motions.at(frameInput, shown);
    const { map, branch } = this.#motions;
    write(this.#where, map && branch !== null
      ? words.text("assemblies.where", {
          branch: numbers.exact(branch + 1), branches: numbers.exact(map.branches.length),
          circuit: numbers.exact(map.branches[branch].circuit + 1), circuits: numbers.exact(map.circuits),
        })
      : "");
    const groups = { same: /** @type {string[]} */ ([]), folds: /** @type {string[]} */ ([]), never: /** @type {string[]} */ ([]) };
    this.#motions.reached(frameInput, shown)?.forEach((through, k) => {
      if (k === shown) return;
      const group = through === null ? groups.never : through.length === 0 ? groups.same : groups.folds;
      group.push(numbers.exact(all[k].number));
    });
    const said = Object.entries(groups).flatMap(([group, of]) => (of.length > 0 ? [words.text(REACH[/** @type {keyof typeof REACH} */ (group)], { n: of.join(", ") })] : []));
    render(said.map((one) => html`<li>${one}</li>`), this.#reach);
  }

  /**
   * @param {Here} here
   * @param {Snapshot} snapshot
   */
  #draw({ all, shown }, snapshot) {
    const { summary, words, frameInput } = snapshot;
    const { map, current, lost, branch } = this.#motions;
    const { cycle, moves, input, numbers } = summary;
    // At rest the worker also finds which assemblies can be reached.
    const isAwaited = !lost && (!current || (!snapshot.state.view.playing && shown !== null && branch === null));
    this.element.setAttribute("aria-busy", String(isAwaited));
    if (map && (this.#drawn !== map || this.#map.lang !== words.lang)) {
      this.#drawn = map;
      this.#map.lang = words.lang;
      const output = symbol({ name: `${map.output}.angle` }, 0, false, words);
      const turns = moves === "angle";
      this.#map.draw(map, { turns, range: [cycle.start, cycle.end], input: turns ? angled(input) : "s", output: angled(numbers[map.output]), numbers: words.numbers });
      this.#map.element.setAttribute("aria-label", words.text("assemblies.map", { n: output }));
      write(this.#mapped, words.text(map.whole ? "assemblies.mapped" : "assemblies.mapped_partly", { n: output }));
    }
    this.#map.element.toggleAttribute("hidden", !map);
    // Space is reserved for an awaited map, so that the content below does not move when the map arrives.
    this.#map.element.classList.toggle("awaited", !map && !lost);
    if (map) {
      this.#map.element.classList.toggle("faded", !current);
      this.#map.mark({ input: frameInput, shown, angles: all.map(({ angle }) => angle) }, shown === null ? null : branch);
    } else write(this.#mapped, words.text(lost ? "assemblies.lost" : "assemblies.coming"));
  }

  /** @param {number} k index of the picture */
  #follow(k) {
    const here = this.#here;
    const snapshot = this.#snapshot;
    if (!here || !snapshot || k === here.shown || !here.all[k]) return;
    const { engine, history } = this.#page;
    history.step(() => change(() => engine.simulator.assemble(here.all[k].number, snapshot.frameInput), "assembly", this.#page));
  }

  /**
   * Goes to an input chosen on the map, and to the assembly whose output there is nearest to the chosen one.
   * @param {number} input
   * @param {number} output
   */
  #choose(input, output) {
    const { engine, history } = this.#page;
    const { value: here } = attempt(() => engine.simulator.assemblies(input));
    if (!here || here.all.length === 0) return;
    const off = (/** @type {number} */ angle) => Math.abs(Math.atan2(Math.sin(angle - output), Math.cos(angle - output)));
    const chosen = here.all.reduce((best, one) => (off(one.angle) < off(best.angle) ? one : best));
    history.step(() => change(() => ({ ...engine.simulator.assemble(chosen.number, input), input }), "assembly", this.#page));
  }
}

/** @param {string | undefined} number of a link; undefined if the link has none */
function angled(number) {
  return `φ${number ? subscript(number) : ""}`;
}

/** Keys of the texts on assemblies that can be reached without passing a fold, only through folds, or never. */
const REACH = Object.freeze({ same: "assemblies.same", folds: "assemblies.folds", never: "assemblies.never" });
