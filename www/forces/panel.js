// Reactions, torques of the drivers and applied forces at the current input, with the greatest of each over the motion. Loaded on demand.
import "assur/forces/style.js";
import { byId, make } from "assur/core/dom.js";
import { degrees } from "assur/core/angles.js";
import { html, nothing, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { attempt } from "assur/core/problem.js";
import { subscript } from "assur/core/symbols.js";
import { sentence } from "assur/controls/problems.js";
import { measured } from "assur/core/units.js";
import { unitText } from "assur/forces/fields.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/types/web.js").ForcesHere} Here
 * @typedef {Here["reactions"][number]} Reaction
 */

/** Share of the greatest force below which a force is written as zero. */
const ROUNDING = 1e-12;
/** Sign for a statically indeterminate quantity. */
const INDETERMINATE = "?";
/** Sign for what has no value. */
const NONE = "—";

export class Forces {
  #page;
  #none = make("p", { id: "forces-none" });
  #tables = make("div", { class: "forces-tables" });
  #revision = -1;
  /** @type {import("assur/types/web.js").GreatestForces} */
  #greatest = { greatest: [], poses: 0, locked: 0 };

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.element = make("section", { id: "forces-shown", "data-field": "forces" }, [make("h2", { "data-t": "forces.heading" }), this.#none, this.#tables]);
    byId("readouts", HTMLTableElement).after(this.element);
    page.words.fill(this.element);
    page.furtherPlots = () => this.#plots();
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, stale, frameInput, revision, words, numbersDue } = snapshot;
    if (stale) return;
    this.element.hidden = !state.view.forces;
    if (this.element.hidden || !numbersDue) return;
    const { simulator } = this.#page.engine;
    const { value: here, problems } = attempt(() => simulator.forces(frameInput));
    this.#none.textContent = problems.map((problem) => sentence(problem, words, state.document)).join(" ");
    this.#tables.hidden = !here;
    if (!here) return;
    if (revision !== this.#revision) {
      this.#revision = revision;
      this.#greatest = simulator.greatestForces();
    }
    render(this.#written(here, snapshot), this.#tables);
  }

  /** @returns {import("assur/plots/pairs.js").Further[]} choices for the list of plots: the forces of the drawn linkage */
  #plots() {
    const { engine, model, words } = this.#page;
    const { value } = attempt(() => engine.simulator.forces(model.home));
    if (!value) return [];
    return [
      ...value.drives.map(({ name, link, kind }) => ({ name, text: words.text(`forces.drive.${kind}`, { name: called(link, words) }) })),
      ...value.reactions.map((reaction) => {
        const text = pairText(reaction, words);
        return { name: reaction.name, text: words.text("forces.reaction_of", { name: text }), vector: words.text("forces.hodograph_of", { name: text }) };
      }),
      { name: value.shaking.name, text: words.text("forces.shaking_of"), vector: words.text("forces.hodograph_of_shaking") },
    ];
  }

  /**
   * @param {Here} here
   * @param {Snapshot} snapshot
   */
  #written({ reactions, drives, applied, shaking, lost, efficiency }, snapshot) {
    const { words } = snapshot;
    const { numbers } = words;
    // A force that is zero by equilibrium is written as zero instead of its rounding error.
    const least = ROUNDING * Math.max(...reactions.map(({ value }) => value ?? 0), ...applied.map(({ value }) => value));
    const number = (/** @type {number | null} */ value) => (value === null ? INDETERMINATE : numbers.short(Math.abs(value) < least ? 0 : value));
    const angle = (/** @type {Pick<Reaction, "value" | "direction">} */ { value, direction }) => (value === null ? INDETERMINATE : direction === null || value < least ? NONE : `${numbers.fixed(degrees(direction), 1)}°`);
    const unit = (/** @type {"newton" | "newton_metre"} */ name, /** @type {string} */ symbol) => [symbol, unitText(name, words)].filter(Boolean).join(", ");
    const [newton, moment] = [unit("newton", "R"), unit("newton_metre", "M")];
    const moments = reactions.some(({ kind }) => kind !== "hinge");
    const columns = moments ? 5 : 4;
    const text = (/** @type {string} */ key) => words.text(`forces.${key}`);
    const { locked, poses } = this.#greatest;
    return html`
      <table id="drives">
        <thead><tr><th scope="col">${text("drivers")}</th><th scope="col">${text("now")}</th><th scope="col">${text("greatest")}</th><th scope="col">${text("at")}</th></tr></thead>
        <tbody>${drives.map(({ name, link, kind, value }) => html`<tr data-name=${name}><th scope="row">${words.text(`forces.drive.${kind}`, { name: called(link, words) })}</th><td>${value === null ? INDETERMINATE : measured(numbers.short(value), unitText(kind === "torque" ? "newton_metre" : "newton", words))}</td>${this.#most(name, snapshot)}</tr>`)}</tbody>
      </table>
      <table id="reactions">
        <caption>${text("pair")}</caption>
        <thead>
          <tr><td colspan=${columns - 2}></td><th scope="col">${text("greatest")}</th><th scope="col">${text("at")}</th></tr>
          <tr><th scope="col">${newton}</th><th scope="col">∠</th><th scope="col">Rₓ</th><th scope="col">R<sub>y</sub></th>${moments ? html`<th scope="col">${moment}</th>` : nothing}</tr>
        </thead>
        ${reactions.map((one) => html`<tbody data-name=${one.name}>
          <tr><th scope="rowgroup" colspan=${columns - 2}>${pairText(one, words)}</th>${this.#most(one.name, snapshot)}</tr>
          <tr><td>${number(one.value)}</td><td>${angle(one)}</td><td>${number(one.x)}</td><td>${number(one.y)}</td>${moments ? html`<td>${one.kind === "hinge" ? NONE : number(one.moment)}</td>` : nothing}</tr>
        </tbody>`)}
      </table>
      ${reactions.some(({ x, y, moment }) => [x, y, moment].includes(null)) ? html`<p>${words.text("forces.indeterminate", { sign: INDETERMINATE })}</p>` : nothing}
      <p id="shaking">${words.text("forces.shaking", { force: measured(number(shaking.value), unitText("newton", words)), direction: angle(shaking), moment: measured(number(shaking.moment), unitText("newton_metre", words)) })}</p>
      ${locked > 0 ? html`<p id="forces-locked">${words.text("forces.locked", { n: numbers.exact(locked), count: numbers.exact(poses) })}</p>` : nothing}
      ${lost === null ? nothing : html`<p id="friction-loss">${words.text("forces.lost", { power: measured(numbers.short(lost), unitText("watt", words)) })} ${efficiency === null ? "" : words.text(efficiency > 0 ? "forces.efficiency" : "forces.no_return", { value: numbers.fixed(efficiency, 3) })}</p>`}
      ${words.unit === "" ? html`<p>${text("consistent")}</p>` : nothing}
      <details id="applied-forces" class="fold within">
        <summary>${text("applied")}</summary>
        <table>
          <thead><tr><th scope="col">${text("source")}</th><th scope="col">${text("link")}</th><th scope="col">${unit("newton", "Fₓ")}</th><th scope="col">F<sub>y</sub></th><th scope="col">${moment}</th></tr></thead>
          <tbody>${applied.map(({ kind, index, link, x, y, couple }) => html`<tr><th scope="row">${words.text(`forces.of.${kind}`)}${index === null ? "" : ` ${numbers.exact(index + 1)}`}</th><td>${called(link, words)}</td><td>${number(x)}</td><td>${number(y)}</td><td>${number(couple)}</td></tr>`)}</tbody>
        </table>
      </details>`;
  }

  /**
   * Cells of the greatest value and of the input at which it is reached; a press on the input goes there.
   * @param {string} name of a quantity
   * @param {Snapshot} snapshot
   */
  #most(name, { coordinate, words }) {
    const most = this.#greatest.greatest.find((one) => one.name === name);
    if (!most || most.value === null) return html`<td>${NONE}</td><td></td>`;
    const shown = coordinate.inputShown(most.input);
    return html`<td>${words.numbers.short(most.value)}</td><td><button class="at" type="button" @click=${() => this.#page.drive(shown)}>${coordinate.short(most.input, words, 1)}</button></td>`;
  }
}

/**
 * @param {Reaction} reaction
 * @param {Words} words
 * @returns {string} the pair, and the links between which the reaction acts
 */
function pairText({ pair, kind, on, from }, words) {
  const name = kind === "mesh" ? pair.split(" ").map((wheel) => called(wheel, words)).join(" – ") : subscript(pair);
  return words.text("forces.on_from", { name, on: called(on, words), from: called(from, words) });
}
