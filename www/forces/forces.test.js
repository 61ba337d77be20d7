// Tests of forces at the interface to the engine: masses, reactions, greatest values, plots and tables. Expected
// numbers are computed by hand.
import assert from "node:assert/strict";
import test from "node:test";
import { attempt } from "assur/core/problem.js";
import { initialState } from "assur/state/state.js";
import { Context } from "assur/tests/canvas.js";
import { newEngine } from "assur/tests/engine.js";

const engine = newEngine();
const G = 9.81;
const MASS = 2;

/**
 * A crank-rocker, in metres, whose crank of length 0.4 has a mass.
 * @param {object} [more] fields of the document
 */
function document(more = {}) {
  const at = { A: [0, 0], B: [0.4, 0], C: [1, 0.8], D: [1.2, 0] };
  return {
    unit: "m",
    points: Object.entries(at).map(([name, at]) => ({ name, at })),
    frame: ["A", "D"],
    links: [{ name: "crank", points: ["A", "B"], mass_kg: MASS }, { name: "coupler", points: ["B", "C"] }, { name: "rocker", points: ["D", "C"] }],
    drivers: [{ crank: "crank" }],
    gravity: [0, -G],
    ...more,
  };
}

/**
 * @param {object} more fields of the document
 * @param {object} [view]
 */
function open(more, view = {}) {
  engine.set(initialState("linkage", document(more), { omega: 1, epsilon: 0, ...view }));
  return engine.simulator;
}

/** @param {number} one @param {number} other */
const near = (one, other, tolerance = 1e-12) => assert.ok(Math.abs(one - other) <= tolerance, `${one} is not ${other}`);

test("a uniform bar, and a centre of mass given by a point", () => {
  const [crank, coupler] = open({}).masses();
  assert.deepEqual([crank.link, crank.mass, crank.given, crank.bar], ["crank", MASS, false, true]);
  near(crank.inertia, (MASS * 0.4 ** 2) / 12);
  near(crank.centre[0], 0.2);
  assert.deepEqual([coupler.mass, coupler.inertia], [0, 0]);
});

test("the centre of mass is put on its link, and moved there again", () => {
  const simulator = open({});
  const put = (along, across) => simulator.edit({ edit: "centre", link: "crank", on: [along, across] }, 0).document;
  const first = put(0.3, 0.05);
  assert.equal(first.points.length, 5);
  const { points, links, ...rest } = first;
  engine.set(initialState("linkage", { ...rest, points, links }, {}));
  const [crank] = engine.simulator.masses();
  near(crank.centre[0], 0.3);
  near(crank.centre[1], 0.05);
  assert.equal(crank.given, true);
  const again = engine.simulator.edit({ edit: "centre", link: "crank", on: [0.1, 0] }, 0).document;
  assert.equal(again.points.length, 5);
});

test("a uniform bar has its mass from section and density, whatever the unit", () => {
  for (const [unit, metres] of [["m", 1], ["mm", 1e-3]]) {
    const simulator = open({ unit });
    const { document } = simulator.edit({ edit: "uniform", link: "crank", section: 50, density: 7850 }, 0);
    near(document.links[0].mass_kg / (7850 * 50 * 0.4 * metres ** 3), 1);
  }
});

test("the balancing torque of a heavy crank, its greatest value, and the reactions of pairs without load", () => {
  const simulator = open({});
  for (const input of [0, 1, 2.5]) {
    const { drives: [drive], reactions } = simulator.forces(input);
    assert.deepEqual([drive.name, drive.kind], ["crank.torque", "torque"]);
    near(drive.value, MASS * G * 0.2 * Math.cos(input), 1e-11);
    const value = Object.fromEntries(reactions.map((one) => [one.pair, one]));
    near(value.C.value, 0, 1e-11);
    // The crank moves on a circle at 1 rad/s: the bearing carries the weight and pulls the centre inwards.
    const pull = -MASS * 0.2;
    near(value.A.x, pull * Math.cos(input), 1e-11);
    near(value.A.y, MASS * G + pull * Math.sin(input), 1e-11);
    assert.deepEqual([value.A.on, value.A.from], ["crank", "frame"]);
  }
  const { greatest: all, poses, locked } = simulator.greatestForces();
  assert.ok(poses >= 360 && locked === 0);
  const greatest = all.find(({ name }) => name === "crank.torque");
  near(Math.abs(greatest.value), MASS * G * 0.2, 1e-11);
  near(Math.sin(greatest.input), 0, 1e-12);
});

test("a document in millimetres gives newtons and newton metres", () => {
  const { drives: [drive], applied } = open({ unit: "mm" }, { omega: 0 }).forces(0);
  near(drive.value, MASS * G * 0.2e-3, 1e-12);
  near(applied.find(({ kind }) => kind === "weight").y, -MASS * G, 1e-11);
});

test("forces are plotted by the input in one panel, and as a hodograph", () => {
  const request = { width: 400, height: 300, palette: engine.roles.map(() => [0, 0, 0]) };
  open({}, { plot: "crank.torque" });
  const { panels } = engine.chart(new Context(), request);
  assert.deepEqual(panels.map(({ kind, order }) => [kind, order]), [["torque", 0]]);
  near(engine.simulator.plotted(1)[0], MASS * G * 0.2 * Math.cos(1), 1e-11);
  open({}, { plot: "A.reaction" });
  assert.deepEqual(engine.chart(new Context(), request).panels[0].series.map(({ name }) => name), ["A.reaction", "A.reaction_x", "A.reaction_y"]);
  open({}, { against: { x: "A.reaction_x", y: "A.reaction_y" } });
  const { against } = engine.chart(new Context(), request);
  assert.deepEqual([against.x.kind, against.y.kind], ["force", "force"]);
  near(engine.simulator.plotted(1)[1], MASS * G - MASS * 0.2 * Math.sin(1), 1e-11);
  const { problems } = attempt(() => open({}, { plot: "E.reaction" }));
  assert.deepEqual(problems, [{ code: "unknown_choice", field: "plot" }]);
});

test("the table of the motion has forces while they are shown", () => {
  const names = open({}, { forces: true }).sweep(4).columns.map(({ name }) => name);
  for (const name of ["A.reaction_N", "A.reaction_x_N", "crank.torque_N_m"]) assert.ok(names.includes(name), name);
  const { columns, rows } = engine.simulator.sweep(4);
  near(rows[0].values[columns.findIndex(({ name }) => name === "crank.torque_N_m")], MASS * G * 0.2, 1e-11);
  assert.ok(!open({}).sweep(4).columns.some(({ name }) => name.includes("reaction")));
});

test("arrows are drawn if they are wanted", () => {
  const plain = open({}).at(1).frame.length;
  assert.ok(open({}, { forces: true }).at(1).frame.length > plain);
});

test("what no body has and what acts on nothing is refused, and the mechanism stays", () => {
  const simulator = open({});
  const refusedBy = (more) => attempt(() => open(more)).problems.map(({ code, path, link }) => [code, path ?? link]);
  const links = (change) => ({ links: document().links.map((link, i) => (i === 0 ? { ...link, ...change } : link)) });
  assert.deepEqual(refusedBy(links({ mass_kg: -1 })), [["negative_mass", "crank"]]);
  assert.deepEqual(refusedBy(links({ mass_kg: 0, inertia: 1 })), [["impossible_inertia", "crank"]]);
  assert.deepEqual(refusedBy({ loads: [{ link: "handle", value: 1 }] }), [["force_on_no_link", "loads[0]"]]);
  assert.deepEqual(refusedBy({ loads: [{ link: "crank", value: 1 }, { link: "crank", point: "C", value: 1, direction_deg: 0 }] }), [["force_on_no_point", "loads[1]"]]);
  assert.deepEqual(refusedBy({ springs: [{ links: ["crank", "frame"], stiffness: -1 }] }), [["force_no_number", "springs[0]"]]);
  assert.deepEqual(refusedBy({ motor: { stall: 1 } }), [["unclear_force", "motor"]]);
  near(simulator.forces(0).drives[0].value, MASS * G * 0.2, 1e-11);
});
