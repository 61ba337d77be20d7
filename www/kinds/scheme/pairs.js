// The table of pairs. It shows the kind, links, cuts, position and axis of each pair.
import { CardList } from "assur/controls/card-list.js";
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { section } from "assur/controls/section.js";
import { make, write } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { Seen } from "assur/core/seen.js";
import { edited } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/scheme/opening.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").Documents["scheme"]} Document
 * @typedef {Document["pairs"][number]} Pair
 * @typedef {import("assur/core/words.js").Words} Words
 */

/** Limit of the number of pairs in a drawing. */
const MAX_PAIRS = 60;

/** @type {readonly Pair["kind"][]} */
const FORMS = Object.freeze([
  "revolute", "prismatic", "screw", "cylindrical", "universal", "spherical", "planar", "sphere_in_cylinder", "cylinder_on_plane", "sphere_on_plane", "class",
]);

/** Value of the option that stands for a new link. */
const NEW = "";

/**
 * Position and axis of a pair. `part`: the field with three numbers. `said`: keys of the texts that name the three
 * numbers.
 */
const TRIPLES = Object.freeze(/** @type {const} */ ([
  { part: "at", said: ["field.pairs.at.x", "field.pairs.at.y", "field.pairs.at.z"] },
  { part: "axis", said: ["field.pairs.axis.x", "field.pairs.axis.y", "field.pairs.axis.z"] },
]));

export class PairsView {
  #page;
  #list;
  #planar = make("input", { id: "scheme-planar", type: "checkbox" });
  #shown = new Seen();

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#list = new CardList({
      kind: "scheme", name: "pairs", first: 1, least: 1, most: MAX_PAIRS, written: String,
      words: { add: "pairs.add", remove: "pairs.remove" },
      build: (index, _, drafts, remove) => this.#card(index, drafts, remove),
      another: ({ state: { document } }) => another(document),
      without: (index, { pairs, cut }) => ({ pairs: pairs.filter((_, at) => at !== index), cut: cut.filter((name) => !isOf(name, pairs[index].name)) }),
    }, page);
    this.#planar.addEventListener("change", () => this.#edit(() => ({ planar: this.#planar.checked })));
    section("scheme", "pairs.heading", "pairs", [
      this.#list.cards, this.#list.add,
      make("label", { class: "check" }, [this.#planar, " ", make("span", { "data-t": "pairs.planar" })]),
    ]);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, problems, words, summary } = snapshot;
    const wrong = new Set(problems.map(({ field }) => field));
    if (this.#shown.same(state.document, words, summary, ...wrong)) return;
    this.#list.show(snapshot, wrong);
    this.#planar.checked = state.document.planar;
  }

  /** @param {(document: Document) => Partial<Document>} change */
  #edit(change) {
    this.#page.store.update((state) => edited(state, "scheme", change));
  }

  /**
   * @param {number} index
   * @param {(pair: Pair) => Pair} change
   */
  #put(index, change) {
    this.#edit(({ pairs }) => ({ pairs: pairs.map((pair, at) => (at === index ? change(pair) : pair)) }));
  }

  /**
   * @param {number} index
   * @param {number} end index of the link among the links of the pair
   * @param {string} link
   */
  #join(index, end, link) {
    this.#edit((document) => {
      const { pairs, cut } = document;
      const name = link === NEW ? newLink(document) : link;
      const links = pairs[index].links.map((one, at) => (at === end ? name : one));
      return { pairs: pairs.map((pair, at) => (at === index ? { ...pair, links } : pair)), cut: cut.filter((one) => !isOf(one, pairs[index].name)) };
    });
  }

  /**
   * @param {number} index
   * @param {import("assur/state/drafts.js").Drafts} drafts
   * @param {HTMLButtonElement} remove
   * @returns {{ lines: HTMLElement[], show: (pair: Pair, snapshot: Snapshot, wrong: ReadonlySet<string | undefined>) => void }}
   */
  #card(index, drafts, remove) {
    const n = String(index + 1);
    const name = make("b");
    const form = make("select", { id: `pair-form-${n}`, class: "control", "data-t-label": "field.pairs.kind", "data-n": n }, FORMS.map((value) => make("option", { value, "data-t": `pair.${value}` })));
    form.addEventListener("change", () => this.#put(index, (pair) => shaped(pair, /** @type {Pair["kind"]} */ (form.value))));
    const freedoms = make("select", { id: `pair-freedoms-${n}`, class: "control", "data-t-label": "field.pairs.freedoms", "data-n": n }, ["1", "2", "3", "4", "5"].map((value) => make("option", { value }, [value])));
    freedoms.addEventListener("change", () => this.#put(index, (pair) => ({ ...pair, freedoms: Number(freedoms.value) })));
    const links = make("span", { class: "pair-links" });
    const cuts = make("span", { class: "pair-cuts" });
    const boxes = TRIPLES.flatMap(({ part, said }) => said.map((label, k) => {
      const axis = "xyz"[k];
      const field = `pairs[${index}].${part}.${axis}`;
      const input = numberField({ id: `pair-${part}-${axis}-${n}`, "data-t-label": label, "data-n": n });
      const box = new NumberBox(input, field, drafts, (value) => (
        this.#put(index, (pair) => ({ ...pair, [part]: withCoordinate(pair[part], k, value, part === "at" && this.#planar.checked) }))
      ));
      return { part, k, box, field, element: make("label", { class: "pair-number" }, [make("b", {}, [axis]), input]) };
    }));
    const triples = TRIPLES.map(({ part }) => make("div", { class: "pair-numbers" }, [
      make("span", { "data-t": `pairs.${part}` }), ...boxes.filter((box) => box.part === part).map(({ element }) => element),
    ]));
    const more = make("details", {}, [make("summary", { "data-t": "pairs.more" }), ...triples]);
    return {
      lines: [make("div", { class: "pair" }, [name, form, freedoms, links, cuts, remove]), more],
      show: (pair, { state: { document }, summary, words }, wrong) => {
        write(name, pair.name);
        form.value = pair.kind;
        freedoms.hidden = pair.kind !== "class";
        freedoms.value = String(pair.freedoms ?? 1);
        this.#showLinks(links, index, pair, document, words);
        const known = summary.pairs.find((one) => one.name === pair.name)?.cuts ?? [];
        render(known.map((name, at) => this.#cut(name, known.length > 1 ? `cut-${n}-${at + 1}` : `cut-${n}`, known.length > 1 ? `✂ ${name}` : words.text("pairs.cut"), document)), cuts);
        for (const { part, k, box, field, element } of boxes) {
          const value = pair[part]?.[k];
          element.hidden = part === "at" && k === 2 && document.planar;
          box.show(value ?? 0, value === undefined ? { brief: "", full: "" } : { brief: words.numbers.brief(value), full: words.numbers.exact(value) }, wrong.has(field));
        }
      },
    };
  }

  /**
   * @param {HTMLElement} container
   * @param {number} index
   * @param {Pair} pair
   * @param {Document} document
   * @param {Words} words
   */
  #showLinks(container, index, pair, document, words) {
    const all = [...new Set([document.ground, ...document.pairs.flatMap(({ links }) => links)])];
    render(pair.links.map((_, at) => html`<select id="pair-link-${index + 1}-${at + 1}" class="control"
      aria-label=${words.text("field.pairs.link", { n: String(index + 1), place: String(at + 1) })}
      @change=${(/** @type {Event & { target: HTMLSelectElement }} */ { target }) => this.#join(index, at, target.value)}>
      ${all.map((link) => html`<option value=${link}>${called(link, words)}</option>`)}
      <option value=${NEW}>${words.text("pairs.new_link")}</option></select>`), container);
    [...container.querySelectorAll("select")].forEach((select, at) => (select.value = pair.links[at]));
  }

  /**
   * @param {string} name of a cut
   * @param {string} id
   * @param {string} said
   * @param {Document} document
   */
  #cut(name, id, said, { cut }) {
    const act = (/** @type {Event & { target: HTMLInputElement }} */ { target }) => this.#edit((document) => (
      { cut: target.checked ? [...document.cut, name] : document.cut.filter((one) => one !== name) }
    ));
    return html`<label class="check"><input id=${id} type="checkbox" data-cut=${name} .checked=${cut.includes(name)} @change=${act}> ${said}</label>`;
  }
}

/**
 * @param {string} cut
 * @param {string} pair
 * @returns {boolean} whether the cut is one of the pair's cuts
 */
function isOf(cut, pair) {
  return cut === pair || cut.startsWith(`${pair}:`);
}

/**
 * @param {Pair} pair
 * @param {Pair["kind"]} kind
 * @returns {Pair} the pair changed to another kind, without its previous axis
 */
function shaped({ name, links, at }, kind) {
  const position = at ? { at } : {};
  return { name, kind, links, ...position, ...(kind === "class" ? { freedoms: 1 } : {}), ...(kind === "screw" ? { pitch: 1 } : {}) };
}

/**
 * @param {readonly number[] | null | undefined} before
 * @param {number} k index of the number
 * @param {number} value
 * @param {boolean} flat whether only x and y are kept
 */
function withCoordinate(before, k, value, flat) {
  const numbers = [0, 0, 0].map((zero, i) => (i === k ? value : (before?.[i] ?? zero)));
  return /** @type {[number, number, number]} */ (flat ? numbers.slice(0, 2) : numbers);
}

/**
 * @param {Document} document
 * @returns {Pair} a hinge between the fixed link and a new link
 */
function another(document) {
  const taken = new Set(document.pairs.map(({ name }) => name));
  let name = [..."ABCDEFGHIJKLMNPQRSTUVWXYZ"].find((letter) => !taken.has(letter));
  for (let n = 1; name === undefined; n += 1) if (!taken.has(`P${n}`)) name = `P${n}`;
  return { name, kind: "revolute", links: [document.ground, newLink(document)] };
}

/**
 * @param {Document} document
 * @returns {string} the lowest unused number, as the name of a link
 */
function newLink({ pairs }) {
  const taken = new Set(pairs.flatMap(({ links }) => links));
  let n = 1;
  while (taken.has(String(n))) n += 1;
  return String(n);
}
