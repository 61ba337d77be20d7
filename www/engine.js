// The engine for the page: one Simulator, exceptions turned into problems, and recovery after a trap in its wasm.
import { fetched } from "assur/core/fetched.js";
import { Refusal, attempt } from "assur/core/problem.js";
import { Compared, discard } from "assur/state/compared.js";
import { alone, contains } from "assur/state/state.js";
import init, * as module from "assur/pkg/assur_web.js";

/**
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/state/state.js").Kind} Kind
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/state.js").Frozen<import("assur/types/file.js").Preset>} Preset of the catalogue
 * @typedef {Readonly<import("assur/types/file.js").Shelf>} Shelf place of a mechanism in the gallery
 * @typedef {import("assur/types/web.js").Between} Swing
 * @typedef {import("assur/types/web.js").CycleSummary} Cycle
 * @typedef {import("assur/types/web.js").MarkLayout} Mark
 * @typedef {import("assur/types/web.js").ListedSummary} Listed
 * @typedef {import("assur/types/web.js").OutputSummary} Output
 * @typedef {import("assur/types/web.js").ProfileSummary} Profile
 * @typedef {import("assur/types/web.js").EquationSummary} Equation
 * @typedef {import("assur/types/web.js").RelationHere} Relation
 * @typedef {{ number: number, count: number, whole: boolean } | null} Assembled the moving assembly at the drawn
 * input; null if unknown. `number`: its number, from 1. `count`: how many are known there. `whole`: whether all are
 * @typedef {import("assur/types/web.js").MotionSummary & { readonly assembled: Assembled }} MotionSummary
 * @typedef {import("assur/types/web.js").MixerSummary} MixerSummary
 * @typedef {import("assur/types/web.js").DimensionSummary} Dimension
 * @typedef {import("assur/types/web.js").LinkageSummary} LinkageSummary
 * @typedef {{ [K in Kind]: import("assur/types/web.js").Summaries[K] & (import("assur/types/web.js").Summaries[K] extends { home: number, groups: unknown } ? { readonly assembled: Assembled } : {}) }} Summaries
 * Summaries that the engine makes of documents, by kind. The assemblies of a linkage take time to find, and so are
 * found only on the first access to `assembled`.
 * @typedef {Summaries[Kind]} Summary
 * @typedef {{ frame: Float64Array, handles: Float64Array, readouts: Readouts | null, plotted: Float64Array | null }} Here
 * The mechanism at an input. `frame`: poses of the bodies, and a display list of all shapes that are not rigid.
 * `handles`: x and y of each handle. `readouts`: values by name. `plotted`: value and both derivatives of each series
 * of the plots, or abscissa and ordinate if one quantity is plotted against another. `readouts` and `plotted` are
 * null if derivatives are unbounded.
 * @typedef {import("assur/types/web.js").PanelLayout} Panel
 * @typedef {import("assur/types/web.js").AgainstLayout} Field plot of one quantity against another
 * @typedef {import("assur/types/web.js").AxisLayout} FieldAxis
 * @typedef {Readonly<Record<string, number>>} Readouts
 * @typedef {{ input?: number, document?: import("assur/state/state.js").Change }} Changed the new input, and the changed fields of the document
 * @typedef {import("assur/types/web.js").SweepTable} SweepTable
 */

/** Number of lists that the engine returns for an input, one for each field of `Here`. */
const LISTS = 4;

/** @type {Promise<WebAssembly.Module> | null} */
let compiled = null;

/** @returns {Promise<WebAssembly.Module>} the engine, compiled once for the page and its workers; after a failure, the next call tries again */
export function compiledWasm() {
  if (!compiled) {
    compiled = fetched("assur/pkg/assur_web_bg.wasm", "application/wasm").then(compile);
    compiled.catch(() => (compiled = null));
  }
  return compiled;
}

/**
 * Compiles wasm while it is loading if the server sends it with the media type of wasm, otherwise afterwards.
 * @param {Response} response
 */
async function compile(response) {
  const streams = response.headers.get("Content-Type") === "application/wasm";
  return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

/** @param {Float64Array} flat lengths of the lists, then the lists */
function lists(flat) {
  let end = LISTS;
  return [...flat.subarray(0, LISTS)].map((length) => flat.subarray(end, (end += length)));
}

/** Length to which texts of other programs are cut, as the engine's memory never shrinks. Texts so long are refused. */
const MAX_FOREIGN = 2 ** 20 + 1;

/** @param {string} text */
function begun(text) {
  return text.slice(0, MAX_FOREIGN);
}

export class Engine {
  #simulator = new module.Simulator();
  /** @type {State | null} the last state that the simulator accepted */
  #good = null;
  #compared = new Compared(() => new module.Simulator());

  /** Number of earlier instances of the module. */
  #instances = 0;
  /** Number of documents set so far. */
  #sets = 0;

  /** Whether the engine has failed since it last accepted a state. */
  trapped = false;
  /** @type {readonly string[]} */
  roles = module.roleNames();
  /** @type {readonly string[]} labels of the display lists */
  labels = [];
  /** @type {import("assur/types/file.js").LengthUnit} unit of lengths in the document */
  lengths = "none";
  /** Whether the document may choose the unit of lengths. */
  choosesLengths = false;
  /** @type {readonly Preset[]} */
  catalogue = module.catalogue();
  /** @type {readonly string[]} */
  #names = [];
  /** @type {readonly string[]} points whose coordinates can be plotted */
  points = [];
  /** @type {readonly string[]} links whose angles are read */
  links = [];
  /** @type {readonly string[]} quantities read with their derivatives */
  quantities = [];

  /** @returns {readonly Shelf[]} places of the mechanisms in the gallery */
  shelves() {
    return this.ask(() => module.shelves());
  }

  /**
   * @param {string} id
   * @returns {Preset | undefined} the mechanism of the catalogue
   */
  preset(id) {
    return this.catalogue.find((preset) => preset.id === id);
  }

  /**
   * @param {Pick<State, "kind" | "document">} state
   * @returns {Preset | undefined} preset that `origin` names; without this field, the preset with the same dimensions
   */
  presetOf({ kind, document }) {
    if ("origin" in document) return this.preset(document.origin ?? "");
    return this.catalogue.find((preset) => {
      const { tracers, ...dimensions } = /** @type {{ tracers?: unknown }} */ (preset.document);
      return preset.kind === kind && contains(document, dimensions);
    });
  }

  /**
   * @param {State} state
   * @returns {string} name of the state's files: that of its preset (`jansen`), or else that of its kind (`linkage`)
   */
  fileName(state) {
    return this.presetOf(state)?.id ?? state.kind;
  }

  /**
   * @param {string} text
   * @returns {Uint8Array | undefined} cells of the QR code, row by row, 1 for dark; undefined if the text is too long
   */
  code(text) {
    return this.ask(() => module.qr_code(text));
  }

  /** @returns {Promise<Engine>} */
  static async load() {
    await init({ module_or_path: compiledWasm() });
    return new Engine();
  }

  /**
   * @template {Kind} K
   * @param {import("assur/state/state.js").State<K>} state
   * @returns {Summaries[K]}
   */
  set(state) {
    const summary = this.ask((simulator) => {
      /** @type {Summaries[K]} */
      const taken = simulator.set(alone(state));
      this.#name(simulator.readoutNames());
      this.labels = simulator.labelNames();
      this.lengths = /** @type {import("assur/types/file.js").LengthUnit} */ (simulator.lengths());
      this.choosesLengths = simulator.choosesLengths();
      return /** @type {Summaries[K]} */ (this.#compared.follow(state, /** @type {Summary} */ (taken)));
    });
    this.#good = state;
    this.trapped = false;
    this.#outliveCompared();
    return this.#withAssembled(summary);
  }

  /**
   * @template {object} S
   * @param {S} summary of the document just set
   * @returns {S} the summary; that of a linkage has a field `assembled`, computed on first access
   */
  #withAssembled(summary) {
    if (!("groups" in summary && "home" in summary)) return summary;
    const [own, home] = [(this.#sets += 1), /** @type {number} */ (summary.home)];
    /** @type {Assembled | undefined} */
    let found;
    return Object.defineProperty(summary, "assembled", { get: () => {
      if (found === undefined && own === this.#sets) {
        const here = attempt(() => this.assemblies(home)).value;
        found = here ? { number: (here.shown ?? 0) + 1, count: here.all.length, whole: here.whole } : null;
      }
      return found ?? null;
    } });
  }

  /**
   * @param {unknown} value from outside
   * @returns {State} the state, read and checked
   */
  read(value) {
    return this.ask(() => module.readState(value));
  }

  /**
   * @param {unknown} value
   * @returns {import("assur/state/state.js").Written} the lesson, read and checked except for its documents
   */
  readLesson(value) {
    return this.ask(() => module.readLesson(value));
  }

  /**
   * @param {State} state
   * @returns {readonly import("assur/types/file.js").NumberField[]} numbers that a lesson may vary
   */
  numbers(state) {
    return this.ask(() => module.numbersOf(alone(state)));
  }

  /** @param {string} text JSON in which no key may occur twice: the browser would silently use the last one */
  checkKeys(text) {
    this.ask(() => module.checkKeys(text));
  }

  /**
   * @param {string} text
   * @returns {boolean} whether the text comes from another program
   */
  isForeign(text) {
    return this.ask(() => module.isImport(begun(text)));
  }

  /**
   * @param {string} text of another program
   * @returns {{ read: Pick<State, "kind" | "document">, left_out: readonly Problem[] }} the document, and problems of
   * the parts that could not be imported unchanged
   */
  readForeign(text) {
    return this.ask(() => module.readImport(begun(text)));
  }

  /**
   * @param {State} state state to draw; the state of the page does not change
   * @returns {{ bounds: readonly number[], scene: Float32Array, frame: Float64Array, labels: readonly string[] }} drawing
   * of the state at its drawn input
   */
  sketch(state) {
    return this.beside((other) => {
      const { bounds, home = 0 } = other.set(alone(state));
      return { bounds, scene: other.scene(), frame: lists(other.at(home))[0], labels: other.labelNames() };
    });
  }

  /**
   * @param {import("assur/pkg/assur_web.js").Simulator} other simulator with a state
   * @param {number} input
   * @returns {Readouts | null} values by name, null if derivatives are unbounded there
   */
  readoutsOf(other, input) {
    const { values } = this.placeOf(other, input);
    const entries = other.readoutNames().map((/** @type {string} */ name, /** @type {number} */ i) => [name, values[i]]);
    return values.length > 0 ? Object.fromEntries(entries) : null;
  }

  /**
   * @param {import("assur/pkg/assur_web.js").Simulator} other simulator with a state
   * @param {number} input
   * @returns {{ frame: Float64Array, values: Float64Array }} drawing and values at the input
   */
  placeOf(other, input) {
    const [frame, , values] = lists(other.at(input));
    return { frame, values };
  }

  /** Whether mechanism A is shown. */
  get compares() {
    return this.#compared.shown !== null;
  }

  /**
   * @param {number} input
   * @returns {import("assur/state/compared.js").Beside | null} mechanism A at the input; null if it is hidden or cannot be assembled
   */
  compared(input) {
    const beside = this.#compared.at(input, this);
    this.#outliveCompared();
    return beside;
  }

  /** Starts a new instance of the module if mechanism A broke the present one. */
  #outliveCompared() {
    if (!this.#compared.broken) return;
    this.#compared.hide();
    this.#renew();
  }

  /**
   * Puts questions to a separate simulator. The simulator of the page stays as it is.
   * @template T
   * @param {(other: module.Simulator) => T} questions
   * @returns {T}
   */
  beside(questions) {
    return this.ask(() => {
      const other = new module.Simulator();
      const instance = this.#instances;
      try {
        return questions(other);
      } finally {
        // If a new instance has replaced this one, its simulators are already gone.
        if (instance === this.#instances) discard(other);
      }
    });
  }

  /** @returns {Float32Array} display list of all rigid shapes */
  scene() {
    return this.ask((simulator) => simulator.scene());
  }

  /**
   * All values at an input, computed from one pose.
   * @param {number} input
   * @returns {Here}
   */
  at(input) {
    const [frame, handles, readouts, plotted] = lists(this.ask((simulator) => simulator.at(input)));
    const read = readouts.length > 0;
    return { frame, handles, readouts: read ? this.#named(readouts) : null, plotted: read ? plotted : null };
  }

  /**
   * @param {number} input
   * @returns {readonly Problem[]} reasons for a missing pose or missing derivatives
   */
  why(input) {
    return this.ask((simulator) => simulator.why(input));
  }

  /**
   * @param {number} input
   * @returns {Float64Array} value and both derivatives of each series of the plots
   */
  plotted(input) {
    return this.ask((simulator) => simulator.plotted(input));
  }

  /**
   * Change made by dragging a joint or a traced point to a place.
   * @param {string} point
   * @param {number} input the current input
   * @param {number} x
   * @param {number} y
   * @returns {Changed}
   */
  drag(point, input, x, y) {
    return this.ask((simulator) => simulator.drag(point, input, x, y));
  }

  /**
   * Change made by pressing a handle without dragging it.
   * @param {string} name of the handle
   * @returns {Changed}
   */
  press(name) {
    return this.ask((simulator) => simulator.press(name));
  }

  /**
   * @param {number} number
   * @returns {{ kind: "scheme", document: import("assur/state/state.js").Documents["scheme"] }} practice task with this number
   */
  task(number) {
    return this.ask(() => module.task(number));
  }

  /** @returns {Pick<State, "kind" | "document">} an empty sheet to draw on */
  blank() {
    return this.ask(() => module.blank());
  }

  /**
   * Converts the open document, in its pose at an input, into a document of another kind.
   * @template {Kind} K
   * @param {K} kind
   * @param {number} input
   * @returns {{ kind: K, document: import("assur/state/state.js").Documents[K] }}
   */
  asKind(kind, input) {
    return this.ask((simulator) => simulator.asKind(kind, input));
  }

  /**
   * Change made by setting a dimension. The assembly is followed from the current pose, and so stays the same.
   * @param {string} field of the dimension
   * @param {number} value
   * @param {number} input the current input
   * @returns {Changed}
   */
  setDimension(field, value, input) {
    return this.ask((simulator) => simulator.setDimension(field, value, input));
  }

  /**
   * Change that makes another link the driver. The assembly is followed from the current pose.
   * @param {string} link
   * @param {number} input the current input
   * @returns {Changed}
   */
  drive(link, input) {
    return this.ask((simulator) => simulator.drive(link, input));
  }

  /**
   * @param {number} input
   * @param {number} x
   * @param {number} y
   * @returns {import("assur/types/web.js").LinkHere | null} the link that is drawn nearest to the place (x, y)
   */
  linkAt(input, x, y) {
    return this.ask((simulator) => simulator.linkAt(input, x, y));
  }

  /**
   * @param {number} input
   * @returns {import("assur/types/web.js").AssembliesHere} all assemblies at the input
   */
  assemblies(input) {
    return this.ask((simulator) => simulator.assemblies(input));
  }

  /**
   * @param {number} input
   * @param {number} shown number of construction steps to draw
   * @returns {import("assur/types/web.js").PolygonsHere} the polygons of velocities and accelerations at the input
   */
  polygons(input, shown) {
    return this.ask((simulator) => simulator.polygons(input, shown));
  }

  /**
   * Change made by choosing another assembly.
   * @param {number} number of an assembly at the input
   * @param {number} input the current input
   * @returns {Changed}
   */
  assemble(number, input) {
    return this.ask((simulator) => simulator.assemble(number, input));
  }

  /**
   * Change made by tracing the point at the place (x, y).
   * @param {number} input the current input
   * @param {number} x
   * @param {number} y
   * @returns {{ document: { tracers: { name?: string, link: string }[] } & import("assur/state/state.js").Change }}
   */
  trace(input, x, y) {
    return this.ask((simulator) => simulator.trace(input, x, y));
  }

  /**
   * @param {number} input
   * @param {number} delta
   * @returns {{ input: number, sign: number }} new input; `sign`: −1 if the driver turned back at the end of its range
   */
  advance(input, delta) {
    const [next, sign] = this.ask((simulator) => simulator.advance(input, delta));
    return { input: next, sign };
  }

  /**
   * @param {import("assur/canvas/painter.js").Context} context
   * @param {import("assur/types/web.js").ChartRequest} request
   * @returns {{ panels: Panel[], against: Field | null }}
   */
  chart(context, request) {
    const on = /** @type {CanvasRenderingContext2D} */ (context);
    const { shown } = this.#compared;
    return this.ask((simulator) => (shown ? simulator.chartCompared(on, request, shown) : simulator.chart(on, request)));
  }

  /**
   * @param {number} steps number of steps in a turn, or in the range of a driven slide
   * @returns {SweepTable} the motion as a table, with that of mechanism A if it is shown
   */
  sweep(steps) {
    const { shown } = this.#compared;
    return this.ask((simulator) => (shown ? simulator.sweepCompared(steps, shown) : simulator.sweep(steps)));
  }

  /**
   * Puts a question to the simulator. Parts of the page that are loaded later use this, too.
   * @template T
   * @param {(simulator: module.Simulator) => T} question
   * @returns {T}
   */
  ask(question) {
    try {
      return question(this.#simulator);
    } catch (thrown) {
      if (Array.isArray(thrown)) throw new Refusal(thrown);
      console.error(thrown);
      this.trapped = true;
      this.#compared.takeAnew();
      this.#renew();
      throw new Refusal([{ code: "trapped" }]);
    }
  }

  /**
   * @param {Float64Array} values
   * @returns {Readouts} values by name, with ′ and ″ for the derivatives that the plots show
   */
  #named(values) {
    /** @type {Record<string, number>} */
    const named = {};
    for (let i = 0; i < this.#names.length; i++) named[this.#names[i]] = values[i];
    return named;
  }

  /** @param {readonly string[]} names of the read-outs */
  #name(names) {
    if (names.join() === this.#names.join()) return;
    this.#names = names;
    const of = (/** @type {string} */ what) => names.filter((name) => name.endsWith(what)).map((name) => name.slice(0, -what.length));
    this.points = of(".x");
    this.links = of(".angle");
    this.quantities = of("″");
  }

  /**
   * Starts a new instance of the module with the last good state. After a trap, the old instance is unusable: its
   * stack stays full and its objects stay borrowed. All simulators of the old instance are lost.
   */
  #renew() {
    module.__wbg_reset_state();
    this.#instances += 1;
    this.#simulator = new module.Simulator();
    const good = this.#good;
    if (!good) return;
    try {
      this.#simulator.set(alone(good));
    } catch (thrown) {
      console.error(thrown);
      this.#good = null;
      this.#renew();
    }
  }
}
