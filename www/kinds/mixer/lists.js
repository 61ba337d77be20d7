// The lists of the document in the rail, the peripheral wheels and the traced points: a card for each, one more, one less.
import { NumberRow } from "assur/controls/number-row.js";
import { degrees } from "assur/core/angles.js";
import { make } from "assur/core/dom.js";
import { numberEntries } from "assur/core/names.js";
import { subscript } from "assur/core/symbols.js";
import { WHEELS, wheelLink, wheelOf } from "assur/kinds/mixer/wheels.js";
import { TRACERS, edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/engine.js").MixerSummary} Summary
 * @typedef {import("assur/state/model.js").OwnSnapshot<"mixer">} Snapshot
 * @typedef {import("assur/state/drafts.js").Drafts} Drafts
 * @typedef {import("assur/state/state.js").MixerDocument} MixerDocument
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {MixerDocument["wheels"][number]} Wheel
 * @typedef {MixerDocument["tracers"][number]} Tracer
 * @typedef {Wheel | Tracer} Entry
 * @typedef {(change: Partial<Wheel & Tracer>) => void} Put
 */

/**
 * @template {Entry} E
 * @typedef {(entry: E, snapshot: Snapshot, wrong: ReadonlySet<string | undefined>) => void} Show
 */

/**
 * @template {Entry} E
 * @typedef {(index: number, put: Put, drafts: Drafts, remove: HTMLButtonElement) => { lines: HTMLElement[], show: Show<E> }} Build
 */

/** Of each list the number of its first entry as readers count, how a number is written, and how many entries it may have. */
const LISTS = Object.freeze({
  wheels: Object.freeze({ ...WHEELS, written: String }),
  tracers: Object.freeze({ ...TRACERS, first: 1, least: 0, written: (/** @type {number} */ number) => subscript(String(number)) }),
});

/** Says elsewhere how the entries of the lists are numbered. */
export function numberLists() {
  for (const [name, { first, written }] of Object.entries(LISTS)) numberEntries(name, (index) => written(index + first));
}

export const TEETH = Object.freeze({ min: 6, max: 72, step: 1 });

/** The links that are no wheels, and the keys of their names. */
const LINKS = Object.freeze({ crank: "name.l1", coupler: "name.l2", rocker: "name.l3" });

const ADDITION = Object.freeze({ wheels: "wheels.add", tracers: "tracers.add" });
const REMOVAL = Object.freeze({ wheels: "wheels.remove", tracers: "tracers.remove" });

/**
 * @template {Entry} E
 */
export class RailList {
  #name;
  #build;
  #store;
  #drafts;
  /** The button for one more. */
  add;
  /** Where the cards are. */
  cards;
  /** @type {{ show: Show<E>, element: HTMLElement, remove: HTMLButtonElement }[]} */
  #cards = [];
  /** @type {Summary | null} */
  #summary = null;

  /**
   * @param {keyof typeof LISTS} name
   * @param {Build<E>} build
   * @param {(document: MixerDocument, summary: Summary) => E} another
   * @param {import("assur/state/store.js").Store<import("assur/state/state.js").State>} store
   * @param {Drafts} drafts
   */
  constructor(name, build, another, store, drafts) {
    this.#name = name;
    this.#build = build;
    this.#store = store;
    this.#drafts = drafts;
    this.cards = make("div", { id: name });
    this.add = make("button", { id: `${name}-add`, class: "control add", type: "button", "data-t": ADDITION[name] });
    this.add.addEventListener("click", () => {
      const summary = this.#summary;
      if (summary) this.#change((entries, document) => ({ [name]: [...entries, another(document, summary)] }));
    });
  }

  /**
   * @param {Snapshot} snapshot
   * @param {ReadonlySet<string | undefined>} wrong fields with a problem
   */
  show(snapshot, wrong) {
    this.#summary = snapshot.summary;
    const entries = /** @type {readonly E[]} */ (snapshot.state.document[this.#name]);
    const { least, most } = LISTS[this.#name];
    while (this.#cards.length < entries.length) {
      const card = this.#card(this.#cards.length);
      this.#cards.push(card);
      this.cards.append(card.element);
      snapshot.words.fill(card.element);
    }
    const focused = document.activeElement;
    for (const [index, card] of this.#cards.entries()) {
      card.element.hidden = index >= entries.length;
      card.remove.hidden = entries.length <= least;
      if (entries[index]) card.show(entries[index], snapshot, wrong);
    }
    this.add.disabled = entries.length >= most;
    // A button that is there no more gives the focus away, else it would be lost.
    if (focused === this.add && this.add.disabled) this.#cards[entries.length - 1].remove.focus();
    if (this.#cards.some(({ remove }) => remove === focused && remove.offsetParent === null)) this.add.focus();
  }

  /** @param {number} index */
  #card(index) {
    const { first, written } = LISTS[this.#name];
    const remove = make("button", {
      id: `${this.#name}-remove-${index + first}`,
      type: "button",
      class: "control icon",
      "data-t-label": REMOVAL[this.#name],
      "data-t-title": REMOVAL[this.#name],
      "data-n": written(index + first),
    }, ["×"]);
    remove.addEventListener("click", () => this.#change((entries, document) => removed(this.#name, index, entries, document)));
    /** @type {Put} */
    const put = (change) => {
      this.#store.update((state) => edited(state, "mixer", (document) => (
        { [this.#name]: document[this.#name].map((entry, at) => (at === index ? { ...entry, ...change } : entry)) }
      )));
    };
    const { lines, show } = this.#build(index, put, this.#drafts, remove);
    return { element: make("div", { class: "card" }, lines), remove, show };
  }

  /** @param {(entries: readonly Entry[], document: MixerDocument) => Partial<MixerDocument>} change */
  #change(change) {
    this.#drafts.dropAll([this.#name]);
    this.#store.update((state) => edited(state, "mixer", (document) => change(document[this.#name], document)));
  }
}

/**
 * The document without an entry. What is traced of the wheels behind a removed one stays on them.
 * @param {keyof typeof LISTS} name
 * @param {number} index
 * @param {readonly Entry[]} entries
 * @param {MixerDocument} document
 * @returns {Partial<MixerDocument>}
 */
function removed(name, index, entries, { tracers }) {
  const rest = { [name]: entries.filter((_, at) => at !== index) };
  if (name !== "wheels") return rest;
  const others = tracers.filter(({ link }) => wheelOf(link) !== index);
  const renamed = others.map((tracer) => {
    const wheel = wheelOf(tracer.link);
    return wheel > index ? { ...tracer, link: wheelLink(wheel - 1) } : tracer;
  });
  return { ...rest, tracers: renamed };
}

/**
 * @param {readonly Tracer[]} tracers
 * @param {readonly Wheel[]} wheels
 * @returns {Tracer[]} those that are not of a wheel there is no more
 */
export function staying(tracers, wheels) {
  return tracers.filter(({ link }) => wheelOf(link) < wheels.length);
}

/** @type {Build<Wheel>} */
export function wheelCard(index, put, drafts, remove) {
  const n = String(index + LISTS.wheels.first);
  const common = { n, role: "secondary" };
  const teeth = new NumberRow(
    { ...common, field: `wheels[${index}].z`, id: `z${n}`, key: "wheels.z", symbol: `z${subscript(n)}`, slider: TEETH, counted: "wheels.teeth" },
    drafts,
    (z) => put({ z }),
  );
  const line = new NumberRow(
    { ...common, field: `wheels[${index}].centre_line_deg`, id: `beta${n}`, key: "wheels.centre_line_deg", symbol: `β${subscript(n)}`, unit: "°" },
    drafts,
    (value) => put({ centre_line_deg: value }),
  );
  line.element.classList.add("with-remove");
  line.element.append(remove);
  return {
    lines: [teeth.element, line.element],
    show(wheel, { words, summary }, wrong) {
      const accent = `var(--role-${summary.roles[wheelLink(index)]})`;
      for (const { element } of [teeth, line]) element.style.setProperty("--accent", accent);
      teeth.show(wheel.z, words, wrong.has(teeth.field));
      line.show(wheel.centre_line_deg, words, wrong.has(line.field));
    },
  };
}

/** @type {Build<Tracer>} */
export function tracerCard(index, put, drafts, remove) {
  const id = `P${index + LISTS.tracers.first}`;
  const n = subscript(id.slice(1));
  const select = make("select", { id: `link-${id}`, class: "control", "data-t-label": "field.tracers.link", "data-n": n });
  select.addEventListener("change", () => put({ link: select.value }));
  const name = make("b", {}, [`P${n}`]);
  const head = make("div", { class: "row choosing" }, [make("label", { class: "name", for: select.id }, [name]), select, remove]);
  const rows = /** @type {const} */ (["x", "y"]).map((axis) =>
    new NumberRow(
      { n, role: "secondary", field: `tracers[${index}].${axis}`, id: `${id}-${axis}`, key: `tracers.${axis}`, symbol: axis },
      drafts,
      (value) => put({ [axis]: value }),
    ),
  );
  let offered = "";
  return {
    lines: [head, ...rows.map(({ element }) => element)],
    show(tracer, { words, state, summary }, wrong) {
      const { wheels } = state.document;
      if (offered !== `${wheels.length} ${words.lang}`) {
        offered = `${wheels.length} ${words.lang}`;
        const links = Object.entries(LINKS).map(([value, key]) => make("option", { value }, [words.text(key)]));
        const more = wheels.map((_, wheel) =>
          make("option", { value: wheelLink(wheel) }, [words.text("name.wheels.z", { n: String(wheel + LISTS.wheels.first) })]),
        );
        select.replaceChildren(...links, ...more);
      }
      select.value = tracer.link;
      head.style.setProperty("--accent", `var(--role-${summary.roles[tracer.link] ?? "secondary"})`);
      rows[0].show(tracer.x, words, wrong.has(rows[0].field));
      rows[1].show(tracer.y, words, wrong.has(rows[1].field));
    },
  };
}

/**
 * Like the last wheel, where there is most room.
 * @param {MixerDocument} document
 * @param {Summary} summary
 * @returns {Wheel}
 */
export function anotherWheel({ wheels }, summary) {
  return { ...wheels[wheels.length - 1], centre_line_deg: Math.round(degrees(summary.free_direction)) };
}

/**
 * A point beside the middle of the coupler, of which the curve is worth seeing.
 * @param {MixerDocument} document
 * @returns {Tracer}
 */
export function anotherTracer({ l2 }) {
  const rounded = (/** @type {number} */ length) => Number(length.toPrecision(3));
  return { link: "coupler", x: rounded(l2 / 2), y: rounded(l2 / 4) };
}
