// Tests of linkages with redundant constraints, such as a four-bar with a doubled link: two links on the same two points are one body.
import assert from "node:assert/strict";
import test from "node:test";
import { initialState } from "assur/state/state.js";
import { newEngine } from "assur/tests/engine.js";

const PLACES = Object.freeze({
  "crank-rocker": { A: [0, 0], B: [0.5, 0.8], C: [3, 2], D: [3, 0] },
  parallelogram: { A: [0, 0], B: [0.6, 0.8], C: [2.6, 0.8], D: [2, 0] },
});
const LINKS = Object.freeze({ crank: "AB", coupler: "BC", rocker: "DC" });

/**
 * @param {Record<string, number[]>} places
 * @param {Record<string, string>} links points of each link, with names of one letter
 */
function four({ ...places }, links) {
  const points = Object.entries(places).map(([name, at]) => ({ name, at }));
  const all = Object.entries(links).map(([name, ends]) => ({ name, points: [...ends] }));
  return { points, frame: ["A", "D"], links: all, drivers: [{ crank: "crank" }] };
}

for (const [type, places] of Object.entries(PLACES)) {
  for (const ends of ["AB", "BC", "DC", "AD"]) {
    test(`a ${type} whose link ${ends} is doubled`, () => {
      const engine = newEngine();
      const plain = engine.set(initialState("linkage", four(places, LINKS), {}));
      const alone = { ...plain, assembled: plain.assembled, transmissions: plain.transmissions };
      const doubled = engine.set(initialState("linkage", four(places, { ...LINKS, double: ends }), {}));
      const { counts: { by_count: count, mobility }, redundant, formula, groups } = doubled;
      assert.equal(groups.map(({ term }) => term).join(" → "), formula);
      assert.deepEqual([count, mobility, redundant.length], [0, 1, 1]);
      assert.ok(ends.includes(redundant[0]), redundant[0]);
      assert.deepEqual(doubled.assembled, alone.assembled);
      assert.equal(engine.trapped, false);
      for (const key of ["change_points", "dead_points", "cycle", "four_bars", "transmissions"]) assert.deepEqual(doubled[key], alone[key], key);
    });
  }
}

test("without its passive links a linkage moves, in whatever order its links are given", () => {
  const engine = newEngine();
  // The rocker of a four-bar turns two cranks that are parallel to it.
  const places = { ...PLACES["crank-rocker"], E: [5, 0], F: [5, 2], G: [7, 0], H: [7, 2] };
  const { links, frame, ...rest } = four(places, { ...LINKS, middle: "EF", last: "GH" });
  const all = [...links, { name: "rod", points: ["C", "F", "H"] }];
  for (let turn = 0; turn < all.length; turn++) {
    const order = [...all.slice(turn), ...all.slice(0, turn)];
    const document = { ...rest, frame: [...frame, "E", "G"], links: order };
    const { formula, cycle } = engine.set(initialState("linkage", document, {}));
    const passive = [...formula.matchAll(/q₁\((.*?)\)/g)].map(([, link]) => link);
    assert.equal(passive.length, 1, formula);
    const without = engine.set(initialState("linkage", { ...document, links: order.filter(({ name }) => !passive.includes(name)) }, {}));
    assert.deepEqual(without.cycle, cycle, formula);
  }
});

/** A four-bar whose coupler, a plate, is doubled by a second plate. */
function plates(shape) {
  const { links, ...rest } = four({ A: [0, 0], B: [0, 0.5], C: [1, 0.6], D: [1.2, 0], E: [-0.1, 1.5] }, { ...LINKS, coupler: "BCE", double: "BCE" });
  const shapes = { coupler: [[0, 0], [1, 0], [0, 1]], double: shape };
  return { ...rest, links: links.map((link) => (link.name in shapes ? { ...link, shape: shapes[link.name] } : link)) };
}

test("links that share three points are one body where these are in the same places on both", () => {
  const engine = newEngine();
  const { formula } = engine.set(initialState("linkage", plates([[2, 1], [2, 2], [1, 1]]), {}));
  assert.match(formula, /q₃\(double\)$/);
  // The third point of the second plate, turned or mirrored: at the same distance from the first point, but elsewhere.
  for (const third of [[0.6, 0.8], [0, -1]]) {
    assert.throws(() => engine.set(initialState("linkage", plates([[0, 0], [1, 0], third]), {})), ({ problems: [{ code }] }) => code === "locked", String(third));
  }
});

test("a length of a doubled link is set on both links", () => {
  const engine = newEngine();
  for (const field of ["links[1].length", "links[3].length"]) {
    for (const ends of ["BC", "CB"]) {
      const { home } = engine.set(initialState("linkage", four(PLACES["crank-rocker"], { ...LINKS, double: ends }), {}));
      const { document } = engine.simulator.setDimension(field, 3, home);
      for (const link of [1, 3]) assert.ok(Math.abs(document.links[link].length - 3) < 1e-12, `${field} ${ends}: ${document.links[link].length}`);
    }
  }
});

test("W of a locked drawing counts doubled links", () => {
  const { links, ...rest } = four(PLACES["crank-rocker"], { ...LINKS, double: "BC", other: "CD" });
  const document = { ...rest, links: links.map((link) => (link.name === "other" ? { ...link, length: 2.1 } : link)) };
  assert.throws(() => newEngine().set(initialState("linkage", document, {})), ({ problems: [{ mobility }] }) => mobility === -1);
});

test("a link between points of one body that a weld has made is one with it where it fits, and locked where it does not", () => {
  const engine = newEngine();
  for (const [base, from, at] of [["frame", "A", [2, 3]], ["crank", "A", [0.3, 1.7]], ["crank", "A", [0.1234, 1.777]], ["coupler", "B", [2, 3]]]) {
    const to = { frame: "D", crank: "B", coupler: "C" }[base];
    const { points, links, ...rest } = four(PLACES["crank-rocker"], { ...LINKS, welded: `${from}E`, strut: `E${to}` });
    const document = (length) => ({
      ...rest,
      points: [...points, { name: "E", at }],
      links: links.map((link) => ({ ...link, ...(link.name === "welded" && { fixed_to: base }), ...(link.name === "strut" && length) })),
    });
    const { formula } = engine.set(initialState("linkage", document({}), {}));
    assert.match(formula, /q₁\(strut\)$/, base);
    assert.throws(() => engine.set(initialState("linkage", document({ length: 9 }), {})), ({ problems: [{ code }] }) => code === "locked", base);
  }
  for (const length of [2.9, 3.1, 9]) {
    const { links, ...rest } = four(PLACES["crank-rocker"], { ...LINKS, strut: "AD" });
    const long = links.map((link) => (link.name === "strut" ? { ...link, length } : link));
    assert.throws(() => engine.set(initialState("linkage", { ...rest, links: long }, {})), ({ problems: [{ code }] }) => code === "locked", String(length));
  }
});
