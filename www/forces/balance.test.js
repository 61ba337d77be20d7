// Tests of counterweights, shaking force, friction circles and self-locking at the interface to the engine.
import assert from "node:assert/strict";
import test from "node:test";
import { attempt } from "assur/core/problem.js";
import { initialState } from "assur/state/state.js";
import { newEngine } from "assur/tests/engine.js";

const engine = newEngine();

/**
 * A crank-rocker, in metres, with masses.
 * @param {object} [more] fields of the document
 */
function document(more = {}) {
  const at = { A: [0, 0], B: [0.4, 0], C: [1, 0.8], D: [1.2, 0] };
  return {
    unit: "m",
    points: Object.entries(at).map(([name, at]) => ({ name, at })),
    frame: ["A", "D"],
    links: [{ name: "crank", points: ["A", "B"], mass_kg: 1 }, { name: "coupler", points: ["B", "C"], mass_kg: 3 }, { name: "rocker", points: ["D", "C"], mass_kg: 2 }],
    drivers: [{ crank: "crank" }],
    ...more,
  };
}

/** @param {object} given @param {object} [view] */
function open(given, view = {}) {
  engine.set(initialState("linkage", given, { omega: 5, epsilon: 0, ...view }));
  return engine.simulator;
}

test("counterweights are links with masses, and the shaking force is then zero", () => {
  const simulator = open(document());
  const before = simulator.greatestForces().greatest.find(({ name }) => name === "frame.shaking").value;
  assert.ok(before > 10);
  const { kind, document: balanced } = simulator.edit({ edit: "balance" }, 0.7);
  assert.equal(kind, "linkage");
  const [first, second] = balanced.links.slice(3);
  assert.deepEqual([first.name, first.fixed_to, second.name, second.fixed_to], ["counterweight", "crank", "counterweight 2", "rocker"]);
  assert.ok([first, second].every(({ mass_kg: mass, inertia }) => mass > 0 && inertia === 0));
  const now = open(balanced);
  const { greatest } = now.greatestForces();
  assert.ok(greatest.find(({ name }) => name === "frame.shaking").value < 1e-12 * before);
  // A balanced four-bar gets no further counterweights. Other linkages cannot be balanced in this way.
  assert.deepEqual(attempt(() => now.edit({ edit: "balance" }, 0.7)).problems, [{ code: "already_balanced" }]);
  const { points, frame, links } = document();
  const slider = document({
    points: [...points.slice(0, 3), { name: "E", at: [2, 0.8] }, { name: "F", at: [0, 0.8] }], frame: [frame[0], "E", "F"],
    links: [...links.slice(0, 2), { name: "slider", points: ["C"], mass_kg: 1 }], slides: [{ link: "slider", point: "C", on: "frame", line: ["F", "E"] }],
  });
  assert.deepEqual(attempt(() => open(slider).edit({ edit: "balance" }, 0)).problems, [{ code: "not_four_bar" }]);
});

test("the shaking force has size and direction, and is plotted", () => {
  const simulator = open(document(), { plot: "frame.shaking" });
  assert.equal(simulator.plotsForces(), true);
  const { shaking, applied } = simulator.forces(0.5);
  const sum = (axis) => applied.filter(({ kind }) => kind === "inertia").reduce((all, one) => all + one[axis], 0);
  const [value, , , x, , , y] = simulator.plotted(0.5);
  for (const [one, other] of [[shaking.value, Math.hypot(sum("x"), sum("y"))], [shaking.direction, Math.atan2(sum("y"), sum("x"))], [value, shaking.value], [x, sum("x")], [y, sum("y")]]) {
    assert.ok(Math.abs(one - other) < 1e-9, `${one}, ${other}`);
  }
  assert.equal(open(document()).plotsForces(), false);
});

/** Pairs of look and radius of the circles in a display list. */
function circles(list, start) {
  const found = [];
  for (let at = start; at < list.length;) {
    const kind = list[at];
    if (kind === 0) at += 2;
    else if (kind === 1) {
      let end = at + 4;
      for (let loop = 0; loop < list[at + 3]; loop++) end += 1 + 2 * list[end];
      at = end;
    } else if (kind === 2) at += 4 + 2 * list[at + 3];
    else if (kind === 3) {
      found.push([list[at + 2], list[at + 5]]);
      at += 6;
    } else at += 7;
  }
  return found;
}

test("a hinge with friction has its circle to scale, or a larger dashed one, and the reactions have names", () => {
  const drawn = (radius) => {
    const friction = [{ hinge: "B", coefficient: 0.2, radius }];
    const { frame } = open(document({ friction }), { forces: true }).at(1);
    return circles(frame, 1 + 3 * frame[0]);
  };
  const [line, dashed] = [2, 3];
  assert.ok(drawn(0.25).some(([look, radius]) => look === line && Math.abs(radius - 0.05) < 1e-7));
  assert.ok(drawn(0.001).some(([look, radius]) => look === dashed && radius > 0.01));
  const names = engine.simulator.labelNames();
  for (const name of ["R₁₂", "T₁"]) assert.ok(names.some((one) => one === name || one === "R₂₁"), `${name}: ${names}`);
});

test("poses that friction locks are counted, and a plot has a gap there", () => {
  // Crank 1, rod 1.2: at 90° the rod pushes the slider within the friction angle (tests/friction.rs).
  const at = { A: [0, 0], B: [0, 1], C: [Math.sqrt(1.2 ** 2 - 1), 0], E: [9, 0] };
  const given = {
    unit: "m",
    points: Object.entries(at).map(([name, at]) => ({ name, at })),
    frame: ["A", "E"],
    links: [{ name: "crank", points: ["A", "B"] }, { name: "rod", points: ["B", "C"] }, { name: "slider", points: ["C"] }],
    slides: [{ link: "slider", point: "C", on: "frame", line: ["A", "E"] }],
    drivers: [{ crank: "crank" }],
    loads: [{ link: "slider", point: "C", value: 100, direction_deg: 0 }],
    friction: [{ slide: "slider", coefficient: 0.7 }],
  };
  const simulator = open(given, { against: { x: "input", y: "crank.torque" }, omega: 1 });
  const { poses, locked } = simulator.greatestForces();
  assert.ok(locked > 0 && locked < poses, `${locked} of ${poses}`);
  assert.deepEqual(attempt(() => simulator.forces(Math.PI / 2)).problems.map(({ code }) => code), ["self_locking"]);
  assert.deepEqual([...simulator.plotted(Math.PI / 2)], []);
  assert.equal(simulator.plotted(0.3).length, 2);
});
