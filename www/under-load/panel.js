// Motion under load: motor, run in time, steady cycle, flywheel. Loaded on demand.
import "assur/under-load/style.js";
import { called } from "assur/core/names.js";
import { degrees } from "assur/core/angles.js";
import { byId, make, write } from "assur/core/dom.js";
import { download } from "assur/core/download.js";
import { html, nothing, render } from "assur/core/html.js";
import { attempt } from "assur/core/problem.js";
import { sentence } from "assur/controls/problems.js";
import { NumberBox, numberField } from "assur/controls/number-box.js";
import { Cycle } from "assur/under-load/cycle.js";
import { Fields, drivenLink, unitOf } from "assur/under-load/fields.js";
import { plot } from "assur/under-load/plot.js";
import { LoadRun } from "assur/under-load/run.js";

/**
 * @typedef {import("assur/state/model.js").Snapshot} Snapshot
 * @typedef {import("assur/core/problem.js").Problem} Problem
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {import("assur/state/state.js").LinkageDocument} LinkageDocument
 */

/** Factors of time in which a run is played. */
const PACES = Object.freeze([1, 0.3, 0.1, 0.03, 0.01]);
/** Most points of a curve. */
const POINTS = 400;
/** Part of the greatest energy that may be rounding. */
const ROUNDING = 1e-9;
/** Names of the columns of a reading in a table. */
const COLUMNS = Object.freeze(["t", "input", "rate", "acceleration", "kinetic", "potential", "work", "lost"]);
/** Energies in a reading: place, key of the name, colour. */
const ENERGIES = Object.freeze(/** @type {const} */ ([[4, "under_load.kinetic", "accent1"], [5, "under_load.potential", "accent2"], [6, "under_load.work", "accent3"], [7, "under_load.lost", "accent4"]]));

/** Colours of the drivers. */
const ROLES = Object.freeze(/** @type {const} */ (["accent1", "accent2", "accent3", "accent4"]));

export class UnderLoad {
  #page;
  /** @type {Fields[]} of each driver */
  #fields;
  #motors = make("div", {});
  #run;
  #cycle;
  #go = this.#button("run-go", "under_load.run", () => this.#begin());
  #stop = this.#button("run-stop", "under_load.stop", () => this.#run.stop());
  #rewind = this.#button("run-rewind", "under_load.rewind", () => this.#run.rewind());
  #save = this.#button("run-csv", "under_load.csv", () => this.#download());
  #pace = make("select", { id: "run-pace", class: "control", "data-t-label": "under_load.pace" });
  #until = numberField({ id: "run-until", "data-t-label": "field.run.until" });
  #untilBox;
  #across = make("select", { id: "run-across", class: "control", "data-t-label": "under_load.across" });
  #status = make("p", { id: "run-status", role: "status" });
  #account = make("p", { id: "run-account" });
  #plots = make("div", { class: "load-plots", id: "run-plots" });
  #note = make("p", {});
  #none = make("p", { id: "under-load-none", "data-t": "under_load.linkage_only" });
  #body;
  #drawn = -1;
  /** @type {readonly Problem[]} why the last run did not begin */
  #refused = [];
  /** @type {Snapshot["state"]["document"] | null} document of the problems */
  #checked = null;
  /** @type {readonly Problem[]} of the forces of the document */
  #problems = [];
  /** @type {Words | null} */
  #words = null;

  /** @param {import("assur/app/page.js").Page} page */
  constructor(page) {
    this.#page = page;
    this.#fields = [new Fields(page, 0)];
    this.#motors.append(this.#fields[0].element);
    this.#run = new LoadRun(page);
    this.#cycle = new Cycle(page);
    this.#pace.addEventListener("change", () => {
      this.#run.pace = Number(this.#pace.value);
    });
    this.#across.addEventListener("change", () => {
      this.#drawn = -1;
      page.redraw();
    });
    this.#untilBox = new NumberBox(this.#until, "run.until", page.drafts, (value) => {
      if (value > 0) this.#run.until = value;
      page.redraw();
      return this.#run.until;
    });
    const until = make("label", { class: "load-field" }, [make("span", { "data-t": "under_load.until" }), this.#until]);
    const buttons = make("div", { class: "load-buttons", role: "group", "data-t-label": "under_load.heading" }, [this.#go, this.#stop, this.#rewind, this.#pace, until]);
    const shown = make("div", { class: "load-buttons" }, [this.#across, this.#save]);
    this.#body = make("div", {}, [this.#note, this.#motors, buttons, this.#status, shown, this.#plots, this.#account, this.#cycle.element]);
    this.element = make("section", { id: "under-load-shown", "data-field": "under_load" }, [make("h2", { "data-t": "under_load.heading" }), this.#none, this.#body]);
    byId("readouts", HTMLTableElement).after(this.element);
    page.words.fill(this.element);
  }

  /** @param {Snapshot} snapshot */
  render(snapshot) {
    const { state, stale, words, numbersDue, coordinate, problems } = snapshot;
    // A document whose forces are refused keeps its fields.
    if (stale) {
      if (state.kind === "linkage") this.#write(state.document, problems, words);
      return;
    }
    this.element.hidden = !state.view.under_load;
    if (this.element.hidden) {
      this.#run.forget();
      this.#cycle.close();
      return;
    }
    const isLinkage = state.kind === "linkage" && coordinate.moves !== "time";
    this.#none.hidden = isLinkage;
    this.#body.hidden = !isLinkage;
    this.#run.keep(snapshot);
    if (!numbersDue || state.kind !== "linkage") return;
    if (this.#words !== words) this.#translate(words);
    const turns = coordinate.moves === "angle";
    if (this.#checked !== state.document) this.#check(state.document);
    this.#write(state.document, [...this.#problems, ...this.#refused], words);
    this.#cycle.element.hidden = state.document.drivers.length > 1;
    this.#cycle.render(snapshot, words);
    this.#untilBox.show(this.#run.until, { brief: words.numbers.brief(this.#run.until), full: words.numbers.exact(this.#run.until) }, false);
    this.#tell(snapshot);
    const { readings } = this.#run;
    this.#save.disabled = this.#rewind.disabled = readings.length === 0;
    this.#stop.disabled = !(this.#run.exists && state.view.playing);
    if (this.#drawn === readings.length) return;
    this.#drawn = readings.length;
    this.#draw(state.document, turns, words);
  }

  /**
   * Shows the fields of each driver.
   * @param {LinkageDocument} document
   * @param {readonly Problem[]} problems
   * @param {Words} words
   */
  #write(document, problems, words) {
    const { drivers } = document;
    write(this.#note, words.text(drivers.length > 1 ? "under_load.several_freedoms" : "under_load.one_freedom"));
    while (this.#fields.length > Math.max(drivers.length, 1)) this.#fields.pop()?.element.remove();
    while (this.#fields.length < drivers.length) {
      const fields = new Fields(this.#page, this.#fields.length);
      this.#fields.push(fields);
      this.#motors.append(fields.element);
      words.fill(fields.element);
    }
    for (const fields of this.#fields) fields.render(document, problems, words);
  }

  /** @param {Words} words */
  #translate(words) {
    this.#words = words;
    this.#drawn = -1;
    const { numbers } = words;
    render(PACES.map((pace) => html`<option value=${pace}>${words.text("transport.times", { value: numbers.upTo(pace, 2) })}</option>`), this.#pace);
    render(["t", "φ"].map((name) => html`<option value=${name}>${words.text(name === "t" ? "under_load.over_time" : "under_load.over_input")}</option>`), this.#across);
  }

  /** @param {Snapshot["state"]["document"]} document */
  #check(document) {
    this.#checked = document;
    this.#refused = [];
    const { model, engine, store } = this.#page;
    const input = model.coordinate.input(model.coordinate.of(store.get()));
    // A run of the page is not replaced: it is gone with its document.
    this.#problems = attempt(() => engine.simulator.startRun(input, 0)).problems;
  }

  #begin() {
    const state = this.#page.store.get();
    if (state.kind !== "linkage") return;
    this.#refused = this.#run.go(state.document.initial_rate ?? 0);
    this.#page.redraw();
  }

  /** @param {Snapshot} snapshot */
  #tell({ state, words }) {
    const { end, at, time, exists, problems } = this.#run;
    const known = [...this.#problems, ...this.#refused];
    const others = known.filter(({ path, code }) => !/(^|\.)(motor|initial_rate|keeps_rate)$|^flywheel$/.test(String(path)) && code !== "flywheel_no_crank");
    const t = `${words.numbers.upTo(time, 3)} ${words.text("unit.s")}`;
    const links = at ? at.links.map((link) => called(link, words)).join(", ") : "";
    const said = others.length > 0
      ? others.map((problem) => sentence(problem, words, state.document)).join(" ")
      : end === "ended" && at
        ? words.text("under_load.end.dead", { t, why: words.text(`dead.${at.kind}`), links })
        : end === "ended" && problems.length > 0
        ? `${words.text("under_load.end.several", { t })} ${problems.map((problem) => sentence(problem, words, state.document)).join(" ")}`
        : end
          ? words.text({ ended: "under_load.end.stopped", locked: "under_load.end.locked", rests: "under_load.end.rests", over: "under_load.end.over" }[end], { t })
          : exists
            ? words.text(state.view.playing ? "under_load.runs" : "under_load.paused", { t })
            : "";
    write(this.#status, said);
  }

  /**
   * @param {LinkageDocument} document
   * @param {boolean} turns
   * @param {Words} words
   */
  #draw(document, turns, words) {
    const { readings, width } = this.#run;
    const { numbers } = words;
    const count = readings.length / width;
    const every = Math.max(1, Math.ceil(count / POINTS));
    const rows = Array.from({ length: Math.ceil(count / every) }, (_, k) => Math.min(k * every, count - 1) * width);
    if (count > 0) rows.push((count - 1) * width);
    const overTime = this.#across.value !== "φ";
    const x = (/** @type {number} */ row) => (overTime ? readings[row] : turns ? degrees(readings[row + 1]) : readings[row + 1]);
    const line = (/** @type {number} */ place) => rows.map((row) => /** @type {const} */ ([x(row), readings[row + place]]));
    const second = words.text("unit.s");
    const across = overTime ? `t, ${second}` : turns ? "φ, °" : `s${words.unit && `, ${words.unit}`}`;
    const rate = unitOf("rate", turns, words);
    const energy = words.unit === "" ? "" : `, ${words.text("under_load.unit.energy")}`;
    // Rates and accelerations of the drivers that move as the first one does; those of the others have another unit.
    const alike = document.drivers.map(({ crank }, k) => ({ k, turns: crank != null })).filter((driver) => driver.turns === turns);
    const ofDrivers = (/** @type {2 | 3} */ part) => alike.map(({ k }) => ({
      points: line(LoadRun.place(k, part)), role: ROLES[k % ROLES.length], name: alike.length > 1 ? called(drivenLink(document, k), words) : "",
    }));
    const energies = ENERGIES.map(([place, key, role]) => ({ points: line(place), role, name: words.text(key) }));
    render(count < 2 ? nothing : [
      plot({ id: "run-rate", across, up: `${turns ? "ω" : "v"}, ${rate}`, lines: ofDrivers(2), numbers }),
      plot({ id: "run-acceleration", across, up: `${turns ? "ε" : "a"}, ${rate}/${second}`.replace(`/${second}/${second}`, `/${second}²`), lines: ofDrivers(3), numbers }),
      plot({ id: "run-energies", across, up: words.text("under_load.energies") + energy, lines: energies, numbers }),
    ], this.#plots);
    const last = rows.at(-1);
    if (last === undefined || count < 2) return write(this.#account, "");
    const [kinetic, potential, work, lost] = [4, 5, 6, 7].map((place) => readings[last + place]);
    const gained = kinetic + potential - readings[4] - readings[5];
    const size = Math.max(Math.abs(gained), Math.abs(work), Math.abs(lost), Math.abs(kinetic));
    const amount = (/** @type {number} */ value) => numbers.short(Math.abs(value) <= ROUNDING * size ? 0 : value);
    write(this.#account, words.text("under_load.account", {
      gained: amount(gained), work: amount(work), lost: amount(lost), unit: energy.replace(", ", ""),
      rest: numbers.short(size > 0 ? (gained - work + lost) / size : 0),
    }));
  }

  #download() {
    const { readings, width } = this.#run;
    const { numbers } = this.#page.words;
    const state = this.#page.store.get();
    const further = state.kind === "linkage" ? state.document.drivers.slice(1).map((_, k) => drivenLink(state.document, k + 1)) : [];
    const columns = [...COLUMNS, ...further.flatMap((name) => ["input", "rate", "acceleration"].map((part) => `${name}.${part}`))];
    const number = (/** @type {number} */ value) => (numbers.comma ? `${value}`.replace(".", ",") : `${value}`);
    const separator = numbers.comma ? ";" : ",";
    const rows = Array.from({ length: readings.length / width }, (_, k) => readings.slice(k * width, (k + 1) * width).map(number));
    const text = [columns, ...rows].map((cells) => `${cells.join(separator)}\n`).join("");
    download(new Blob([text], { type: "text/csv" }), "run.csv");
  }

  /**
   * @param {string} id
   * @param {string} key
   * @param {() => void} act
   */
  #button(id, key, act) {
    return make("button", { type: "button", class: "control", id, "data-t": key, onclick: act });
  }
}
