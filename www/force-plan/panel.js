// Force plans, Zhukovsky's lever and free bodies at the current input. Loaded on demand.
import "assur/force-plan/style.js";
import { sentence } from "assur/controls/problems.js";
import { byId, make, write } from "assur/core/dom.js";
import { html, nothing, render } from "assur/core/html.js";
import { called } from "assur/core/names.js";
import { attempt } from "assur/core/problem.js";
import { describeStep, freeBodyTable, leverTable, titleOf, unitsOf } from "assur/force-plan/equations.js";
import { Exercise } from "assur/force-plan/exercise.js";
import { Sheet } from "assur/force-plan/sheet.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/types/web.js").ForcePlanHere} Plan
 */

/** Number of steps to show that stands for all steps; no construction has so many. */
const ALL = 1e6;
/** Code of the engine's problem for a document that is not a linkage. */
const NO_LINKAGE = "bad_state";
/** Parts of the panel, with the keys of their names. */
const TABS = Object.freeze({ plan: "force_plan.tab.plan", lever: "force_plan.tab.lever", body: "force_plan.tab.body" });

/** @typedef {keyof typeof TABS} Tab */
const NAMES = Object.freeze(/** @type {Tab[]} */ (Object.keys(TABS)));

export class ForcePlan {
  #page;
  #shown = ALL;
  /** @type {Tab} */
  #tab = "plan";
  #none = make("p", { id: "force-plan-none" });
  #tabs = NAMES.map((tab) => make("button", { type: "button", class: "segment", id: `force-tab-${tab}`, "aria-pressed": "false", "aria-controls": `force-${tab}`, "data-t": TABS[tab], onclick: () => this.#turn(tab) }));
  #back = make("button", { type: "button", class: "control", id: "force-plan-back", "data-t": "polygons.back", onclick: () => this.#go(-1) });
  #next = make("button", { type: "button", class: "control", id: "force-plan-next", "data-t": "polygons.next", onclick: () => this.#go(1) });
  #all = make("button", { type: "button", class: "control", id: "force-plan-all", "data-t": "polygons.all", onclick: () => this.#go(ALL) });
  #step = make("p", { id: "force-plan-step", role: "status" });
  #steps = make("ol", { id: "force-plan-steps" });
  #lever = make("div", { id: "force-lever-numbers" });
  #link = make("select", { id: "force-body-link", class: "control", "aria-labelledby": "force-body-of", onchange: () => this.#page.redraw() });
  #acting = make("div", { id: "force-body-numbers", class: "amounts" });
  #exercise;
  #sheets;
  #folds;
  /** Note on friction circles, shown if there are any. */
  #circle;
  #shownParts;
  /** @type {Plan | null} */
  #here = null;
  #input = 0;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#exercise = new Exercise(page);
    this.#exercise.element.addEventListener("toggle", () => page.redraw());
    this.#sheets = { plan: new Sheet(page, "force-plan"), lever: new Sheet(page, "force-lever"), body: new Sheet(page, "free-body") };
    const beside = (/** @type {Sheet} */ sheet, /** @type {HTMLElement} */ numbers) => make("div", { class: "beside" }, [sheet.element, numbers]);
    const choice = make("div", { class: "bar" }, [make("span", { id: "force-body-of", "data-t": "force_plan.link" }), this.#link]);
    const bar = make("div", { class: "bar", role: "group", "data-t-label": "polygons.steps" }, [this.#back, this.#next, this.#all, this.#step]);
    this.#folds = {
      plan: make("div", { id: "force-plan" }, [bar, beside(this.#sheets.plan, this.#steps)]),
      lever: make("div", { id: "force-lever" }, [make("p", { class: "note", "data-t": "force_plan.lever_note" }), beside(this.#sheets.lever, this.#lever)]),
      body: make("div", { id: "force-body" }, [choice, beside(this.#sheets.body, make("div", {}, [this.#acting, this.#exercise.element]))]),
    };
    const notation = make("p", { class: "note", "data-t": "force_plan.notation" });
    this.#circle = make("p", { class: "note", id: "force-circle", "data-t": "force_plan.circle" });
    this.#shownParts = make("div", {}, [make("div", { class: "segments", role: "group", "data-t-label": "force_plan.heading" }, this.#tabs), ...Object.values(this.#folds), this.#circle, notation]);
    this.element = make("section", { id: "force-plan-shown", "data-field": "force_plan" }, [make("h2", { "data-t": "force_plan.heading" }), this.#none, this.#shownParts]);
    byId("readouts", HTMLTableElement).after(this.element);
    page.words.fill(this.element);
    page.onPaper.set("force_plan", (figure) => this.#onPaper(figure));
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, frameInput, stale, words } = snapshot;
    if (stale) return;
    this.element.hidden = !state.view.force_plan;
    this.#here = null;
    if (this.element.hidden) return;
    const { simulator, lengths } = this.#page.engine;
    const { value, problems } = attempt(() => simulator.forcePlan(frameInput, this.#shown));
    // A document that is not a linkage has no forces at any input.
    this.element.hidden = problems.some(({ code }) => code === NO_LINKAGE);
    this.#none.hidden = value !== null && value.loaded;
    this.#shownParts.hidden = !this.#none.hidden;
    if (!value?.loaded) {
      write(this.#none, problems.length > 0 ? problems.map((problem) => sentence(problem, words, state.document)).join(" ") : words.text("force_plan.none"));
      return;
    }
    this.#here = value;
    this.#input = frameInput;
    this.#tabs.forEach((button, k) => {
      button.ariaPressed = String(NAMES[k] === this.#tab);
      this.#folds[NAMES[k]].hidden = NAMES[k] !== this.#tab;
    });
    const units = unitsOf(words, lengths);
    const numbers = snapshot.numbersDue;
    this.#circle.hidden = true;
    if (this.#tab === "plan") this.#plan(value, units, snapshot);
    if (this.#tab === "lever") {
      const lever = simulator.forceLever(frameInput);
      this.#sheets.lever.show(lever.picture, words.text(TABS.lever));
      if (numbers) render(leverTable(lever, units, words), this.#lever);
    }
    if (this.#tab === "body") {
      const body = simulator.freeBody(frameInput, Math.max(this.#link.selectedIndex, 0));
      // These numbers contain the answers of the exercise, so they are hidden while it is open.
      this.#acting.hidden = this.#exercise.open;
      const links = body.links.map(([number, name]) => `${number}: ${called(name, words)}`);
      render(links.map((link) => html`<option>${link}</option>`), this.#link);
      const at = Math.max(this.#link.selectedIndex, 0);
      this.#circle.hidden = this.#exercise.open || !body.acting.some(({ symbol }) => symbol.startsWith("Mᶠ"));
      const own = this.#exercise.open ? this.#exercise.show({ input: frameInput, link: at, name: links[at], units }) : null;
      this.#sheets.body.show(own ?? body.picture, `${words.text(TABS.body)}, ${links[at]}`);
      if (numbers) render(freeBodyTable(body.acting, units, words), this.#acting);
    }
  }

  /**
   * @param {Plan} plan
   * @param {import("assur/force-plan/equations.js").Units} units
   * @param {Snapshot} snapshot
   */
  #plan({ steps, picture }, units, { numbersDue, words }) {
    const at = Math.min(this.#shown, steps.length);
    const shown = steps.slice(0, at);
    const last = shown.at(-1);
    this.#sheets.plan.show(picture, last ? titleOf(last, words) : "");
    if (!numbersDue) return;
    write(this.#step, words.text("polygons.step", { n: words.numbers.exact(at), count: words.numbers.exact(steps.length) }));
    this.#back.disabled = at <= 1;
    render(shown.map((step, k) => html`<li aria-current=${k + 1 === at && at < steps.length ? "step" : nothing}>${describeStep(step, units, words)}</li>`), this.#steps);
  }

  /**
   * Shows more or fewer steps of the construction. After the last step, the first is shown alone again.
   * @param {number} by number of steps to add, or {@link ALL}
   */
  #go(by) {
    const count = this.#here?.steps.length ?? 0;
    const at = Math.min(this.#shown, count);
    this.#shown = by === ALL ? ALL : at + by > count ? 1 : Math.max(at + by, 1);
    this.#page.redraw();
  }

  /** @param {Tab} tab */
  #turn(tab) {
    this.#tab = tab;
    this.#page.redraw();
  }

  /**
   * @param {(picture: import("assur/export/pictures.js").Picture, said: string) => HTMLElement} figure
   * @returns {readonly HTMLElement[]} parts of the worksheet: the picture and the numbers of the shown part of the
   * panel
   */
  #onPaper(figure) {
    if (this.element.hidden || !this.#here) return [];
    const sheet = this.#sheets[this.#tab];
    const title = sheet.canvas.getAttribute("aria-label") ?? "";
    const pictures = this.#tab === "plan" ? this.#plansOnPaper(figure) : [figure(sheet.picture(), title)];
    const name = this.#tab === "plan" ? this.#page.words.text(TABS.plan) : title;
    const onPaper = (/** @type {Node} */ below) => [make("section", { class: "force-plan" }, [make("h2", {}, [name]), ...pictures, below])];
    if (this.#tab === "body" && this.#exercise.open) return onPaper(this.#exercise.onPaper());
    const numbers = { plan: this.#steps, lever: this.#lever, body: this.#acting }[this.#tab];
    const copy = numbers.cloneNode(true);
    if (copy instanceof HTMLElement) copy.removeAttribute("id");
    return onPaper(copy);
  }

  /**
   * @param {(picture: import("assur/export/pictures.js").Picture, said: string) => HTMLElement} figure
   * @returns {readonly HTMLElement[]} the polygon of each group, as far as the steps are shown
   */
  #plansOnPaper(figure) {
    const steps = this.#here?.steps.slice(0, this.#shown) ?? [];
    const last = steps.flatMap(({ kind, plan }, k) => {
      const later = steps.slice(k + 1).some((step) => step.plan === plan && isPolygon(step.kind));
      return isPolygon(kind) && !later ? [k + 1] : [];
    });
    const { words, engine } = this.#page;
    return last.map((shown) => {
      const { picture } = engine.simulator.forcePlan(this.#input, shown);
      return figure(this.#sheets.plan.picture(picture), titleOf(steps[shown - 1], words));
    });
  }
}

/** @param {import("assur/types/web.js").ForceStepHere["kind"]} kind */
function isPolygon(kind) {
  return kind === "polygon" || kind === "group";
}
