// Lists of the mixer in the rail: the peripheral wheels and the traced points.
import { NumberRow } from "assur/controls/number-row.js";
import { degrees } from "assur/core/angles.js";
import { make } from "assur/core/dom.js";
import { html, render } from "assur/core/html.js";
import { subscript } from "assur/core/symbols.js";
import { WHEELS, wheelLink, wheelOf } from "assur/kinds/mixer/wheels.js";
import { TRACERS } from "assur/state/state.js";

/**
 * @typedef {import("assur/kinds/mixer/rail.js").Snapshot} Snapshot
 * @typedef {import("assur/state/state.js").MixerDocument} MixerDocument
 * @typedef {MixerDocument["wheels"][number]} Wheel
 * @typedef {MixerDocument["tracers"][number]} Tracer
 */

/**
 * @template E
 * @typedef {import("assur/controls/card-list.js").ListKind<"mixer", E>} ListKind
 */

export const TEETH = Object.freeze({ min: 6, max: 72, step: 1 });

/** Links other than wheels, with the keys of their names. */
const LINKS = Object.freeze({ crank: "name.l1", coupler: "name.l2", rocker: "name.l3" });

/** @type {ListKind<Wheel>} */
export const WHEEL_LIST = Object.freeze({
  ...WHEELS, kind: "mixer", name: "wheels", written: String, words: { add: "wheels.add", remove: "wheels.remove" }, build: wheelCard, another: anotherWheel, without,
});

/** @type {ListKind<Tracer>} */
export const TRACER_LIST = Object.freeze({
  ...TRACERS, kind: "mixer", name: "tracers", first: 1, least: 0, written: (number) => subscript(String(number)), words: { add: "tracers.add", remove: "tracers.remove" },
  build: tracerCard, another: anotherTracer,
});

/**
 * Removes a wheel and its traced points from the document. The number of each later wheel falls by one, and its
 * traced points follow it.
 * @param {number} index
 * @param {MixerDocument} document
 * @returns {Partial<MixerDocument>}
 */
function without(index, { wheels, tracers }) {
  const others = tracers.filter(({ link }) => wheelOf(link) !== index);
  const renamed = others.map((tracer) => {
    const wheel = wheelOf(tracer.link);
    return wheel > index ? { ...tracer, link: wheelLink(wheel - 1) } : tracer;
  });
  return { wheels: wheels.filter((_, at) => at !== index), tracers: renamed };
}

/**
 * @param {readonly Tracer[]} tracers
 * @param {readonly Wheel[]} wheels
 * @returns {Tracer[]} the traced points except those on missing wheels
 */
export function staying(tracers, wheels) {
  return tracers.filter(({ link }) => wheelOf(link) < wheels.length);
}

/** @type {ListKind<Wheel>["build"]} */
function wheelCard(index, put, drafts, remove) {
  const n = String(index + WHEELS.first);
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

/** @type {ListKind<Tracer>["build"]} */
function tracerCard(index, put, drafts, remove) {
  const id = `P${index + 1}`;
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
        const links = Object.entries(LINKS).map(([value, key]) => [value, words.text(key)]);
        const more = wheels.map((_, wheel) => [wheelLink(wheel), words.text("name.wheels.z", { n: String(wheel + WHEELS.first) })]);
        render([...links, ...more].map(([value, text]) => html`<option value=${value}>${text}</option>`), select);
      }
      select.value = tracer.link;
      head.style.setProperty("--accent", `var(--role-${summary.roles[tracer.link] ?? "secondary"})`);
      rows[0].show(tracer.x, words, wrong.has(rows[0].field));
      rows[1].show(tracer.y, words, wrong.has(rows[1].field));
    },
  };
}

/**
 * Makes a wheel like the last one, in the widest gap between wheels.
 * @param {Snapshot} snapshot
 * @returns {Wheel}
 */
function anotherWheel({ state: { document: { wheels } }, summary }) {
  return { ...wheels[wheels.length - 1], centre_line_deg: Math.round(degrees(summary.free_direction)) };
}

/**
 * Makes a traced point beside the middle of the coupler, where its path is interesting.
 * @param {Snapshot} snapshot
 * @returns {Tracer}
 */
function anotherTracer({ state: { document: { l2 } } }) {
  const rounded = (/** @type {number} */ length) => Number(length.toPrecision(3));
  return { link: "coupler", x: rounded(l2 / 2), y: rounded(l2 / 4) };
}
