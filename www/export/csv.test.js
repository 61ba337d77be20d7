import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test from "node:test";
import { idOf, partsOf } from "assur/core/quantity.js";
import { Words, unbroken } from "assur/core/words.js";
import { toCsv } from "assur/export/csv.js";
import { Coordinate } from "assur/state/coordinate.js";
import { withDocument, withExtras, withView } from "assur/state/state.js";
import { readCsv } from "assur/tests/csv.js";
import { newEngine, stateOf } from "assur/tests/engine.js";
import { tableOf, wordsOf } from "assur/tests/words.js";

const engine = newEngine();
const PLAIN = { comma: false, degrees: false, worded: false, dimensions: true };
const TURN = 2 * Math.PI;

/**
 * @param {import("assur/state/state.js").State} state
 * @param {object} [choices]
 */
function write(state, { steps = 360, lang = "en", words = wordsOf(lang), ...choices } = {}) {
  const { moves, cycle, input } = engine.set(state);
  return toCsv(engine.sweep(steps), new Coordinate(moves, cycle, input), { ...PLAIN, ...choices }, words.measured(engine.lengths));
}

const near = (found, expected, within, what) => assert.ok(Math.abs(found - expected) <= within * Math.max(1, Math.abs(expected)), `${what}: ${found} ${expected}`);

test("the table of the mixer has the golden numbers", async () => {
  const [head, ...lines] = readFileSync(new URL("../../tests/data/mixer.csv", import.meta.url), "utf8").trim().split(/\r?\n/);
  const names = head.split(",");
  const golden = lines.map((line) => Object.fromEntries(line.split(",").map((cell, i) => [names[i], Number(cell)])))
    .filter((row) => row.case === 1 && row.assembly === 1);
  assert.equal(golden.length, 72);
  const csv = await readCsv(write(stateOf(engine, "mixer-a")));
  assert.equal(csv.rows.length, 361);
  const within = [1e-12, 1e-11, 1e-10];
  for (const row of golden) {
    const at = row.phi1_deg;
    assert.equal(csv.value(at, "phi_deg"), at);
    assert.equal(csv.cell(at, "reason"), "");
    for (const [order, d] of ["", "d", "dd"].entries()) {
      for (const [link, phi] of [["coupler", "phi2"], ["rocker", "phi3"]]) {
        const [value, expected] = [csv.value(at, `${link}.${d}angle`), row[d + phi]];
        if (order === 0) near(Math.sin((value - expected) / 2), 0, within[0] / 2, `${link} at ${at}`);
        else near(value, expected, within[order], `${link}.${d}angle at ${at}`);
      }
      for (const point of [1, 2, 3]) {
        for (const axis of ["x", "y"]) near(csv.value(at, `C${point}.${d}${axis}`), row[`c${point}_${d}${axis}`], within[order], `C${point}.${d}${axis} at ${at}`);
      }
      if (order > 0) near(csv.value(at, `wheel5.${d}angle`), -2 * csv.value(at, `rocker.${d}angle`), 1e-14, "wheel 5");
    }
  }
  // The angle goes on to a full turn; the joints have the distances that the lengths give.
  near(csv.value(360, "crank.angle"), TURN, 1e-15, "a turn");
  assert.equal(csv.value(123, "crank.dangle"), 1);
  assert.equal(csv.value(123, "D.x"), 0.85);
  near(Math.hypot(csv.value(123, "B.x"), csv.value(123, "B.y")), 0.37, 1e-15, "the crank");
});

test("every number of every table is that of the engine at its input, to the last digit", async () => {
  for (const id of ["mixer-a", "jansen", "whitworth", "train-gears", "class4-dwell"]) {
    const state = stateOf(engine, id);
    const csv = await readCsv(write(state, { steps: 24 }));
    const table = engine.sweep(24);
    assert.equal(csv.rows.length, table.rows.length, id);
    for (const [i, { input, values, reason }] of table.rows.entries()) {
      assert.deepEqual(csv.rows[i].slice(1, -1), values.map((value) => (value === null ? "" : String(value))), `${id} ${i}`);
      assert.deepEqual([csv.rows[i][0], csv.rows[i].at(-1)], [String(input), reason?.code ?? ""]);
    }
    const { moves, cycle, input: number } = engine.set(state);
    const coordinate = new Coordinate(moves, cycle, number);
    const { readouts } = engine.at(coordinate.input(table.rows[5].input));
    for (const { quantity: name, order } of readouts.names.all) {
      if (order > 0 || !/\.(angle|x)$/.test(name) || !csv.has(name)) continue;
      const off = csv.value(5, name) - readouts.value(name);
      near(name.endsWith(".angle") ? Math.sin(off / 2) : off, 0, 1e-9, `${id} ${name}`);
    }
  }
});

test("the table of an oscillating motion goes from one dead point to the other, where it has positions only", async () => {
  const state = withDocument(stateOf(engine, "mixer-a"), { l1: 3, l2: 2, l3: 3, l4: 4 });
  const csv = await readCsv(write(state, { steps: 72 }));
  assert.equal(csv.rows.length, 37);
  for (let row = 0; row < 37; row++) {
    near(csv.value(row, "phi_deg"), 5 * row - 90, 1e-12, "the input");
    const turnsBack = row === 0 || row === 36;
    assert.equal(csv.cell(row, "reason"), turnsBack ? "dead_point" : "", `row ${row}`);
    for (const [column, given] of [["C.x", true], ["coupler.angle", true], ["C2.dy", !turnsBack], ["wheel5.ddangle", !turnsBack]]) {
      assert.equal(csv.cell(row, column) !== "", given, `${column} in row ${row}`);
    }
  }
  const fine = await readCsv(write(state, { steps: 3600 }));
  assert.equal(fine.rows.length, 1801);
  assert.equal(fine.cell(903, "phi_deg"), "0.3");
});

test("columns have their units for programs", async () => {
  const { text, comments, header } = await readCsv(write(stateOf(engine, "mixer-a"), { steps: 4 }));
  assert.ok(text.startsWith("# length of A-B = 0.37 m\n"), text.slice(0, 200));
  assert.ok(comments.length >= 4);
  assert.deepEqual(header.slice(0, 4), ["phi_deg", "crank.angle_rad", "crank.dangle_rad_per_rad", "crank.ddangle_rad_per_rad2"]);
  for (const name of ["C1.x_m", "C1.dx_m_per_rad", "C1.ddy_m_per_rad2"]) assert.ok(header.includes(name), name);
  assert.equal(header.at(-1), "reason");
  const bare = await readCsv(write(stateOf(engine, "jansen"), { steps: 4, dimensions: false }));
  assert.ok(bare.comments.length === 0 && bare.header.includes("F.dx_length_per_rad"), String(bare.header));
  const train = await readCsv(write(stateOf(engine, "train-gears"), { steps: 4 }));
  assert.equal(train.header[0], "t_s");
});

test("degrees, commas and words are as the reader chooses", async () => {
  const state = stateOf(engine, "mixer-a");
  const radians = await readCsv(write(state, { steps: 360 }));
  const degrees = await readCsv(write(state, { steps: 360, comma: true, degrees: true, dimensions: false }));
  assert.deepEqual(degrees.header.slice(0, 4), ["phi_deg", "crank.angle_deg", "crank.dangle_rad_per_rad", "crank.ddangle_rad_per_rad2"]);
  // Derivatives are as on the page: with respect to radians of the crank, whatever the unit of angles.
  for (const column of ["rocker.dangle", "rocker.ddangle", "C2.y", "C2.dy", "C2.ddy"]) {
    for (const row of [0, 75, 300]) assert.equal(degrees.cell(row, column), radians.cell(row, column), column);
  }
  for (const row of [0, 75, 300]) near(degrees.value(row, "rocker.angle") * TURN / 360, radians.value(row, "rocker.angle"), 1e-14, "rocker.angle");
  const worded = (await write(state, { steps: 2, comma: true, degrees: true, worded: true, dimensions: false }).text()).replace("\ufeff", "").split("\n")[0].split(";");
  for (const name of ["angle of rocker, deg", "angular acceleration analogue of rocker, rad/rad²", "velocity analogue of C2 along x, m/rad"]) assert.ok(worded.includes(name), `${name} in ${worded}`);
});

test("every column has a name in every language, and no two the same", async () => {
  for (const lang of ["en", "ru", "uk", "kk"]) {
    for (const id of ["mixer-a", "jansen", "whitworth"]) {
      const state = withView(stateOf(engine, id), { curvature: true });
      const text = await write(state, { steps: 2, worded: true, comma: true, dimensions: false, lang }).text();
      const header = text.replace("\ufeff", "").split("\n")[0].split(";");
      assert.equal(new Set(header).size, header.length, `${lang} ${id}: ${header.filter((name, i) => header.indexOf(name) !== i)}`);
      for (const name of header) assert.ok(!/export\.|unit\.|[{}]/.test(name), name);
    }
  }
});

test("spaces of a table are plain, whatever the page has", async () => {
  const words = new Words("ru", new Map([...tableOf("ru")].map(([key, text]) => [key, unbroken(text)])));
  assert.ok(words.text("export.dimension.length").includes("\u00a0"));
  const text = await write(stateOf(engine, "mixer-a"), { steps: 2, worded: true, words }).text();
  assert.ok(!text.includes("\u00a0") && text.includes(" = 0.37 м\n"), text.slice(0, 200));
});

test("a byte order mark stands before letters beyond ASCII, and only there", async () => {
  const marked = async (choices) => new Uint8Array(await write(stateOf(engine, "mixer-a"), { steps: 2, ...choices }).arrayBuffer())[0] === 0xef;
  assert.deepEqual([await marked({}), await marked({ worded: true, lang: "ru" })], [false, true]);
});

test("what is measured and what is plotted of a joint is in the table", async () => {
  const measures = ["B-D.distance", "B-C-D.corner", "coupler-rocker.between"];
  const state = withView(stateOf(engine, "mixer-a"), { measures, plot: "C.transmission" });
  const csv = await readCsv(write(state));
  assert.equal((await readCsv(write(stateOf(engine, "mixer-a"), { steps: 2 }))).has("C.transmission"), false);
  engine.set(state);
  const { readouts } = engine.at((62 * TURN) / 360);
  for (const name of [...measures, "C.transmission"]) {
    for (const order of [0, 1, 2]) {
      const { of, what } = partsOf(name);
      const expected = readouts.value(name, order);
      if (expected !== undefined) near(csv.value(62, `${of}.${"d".repeat(order)}${what}`), expected, 1e-12, idOf(name, order));
    }
  }
  // The expected distance is computed from the coordinates.
  const at = (point) => ["x", "y"].map((axis) => csv.value(62, `${point}.${axis}`));
  const [b, d] = [at("B"), at("D")];
  near(csv.value(62, "B-D.distance"), Math.hypot(b[0] - d[0], b[1] - d[1]), 1e-12, "distance");
});

test("what is compared with it has columns and comments of its own, at the same inputs", async () => {
  const state = stateOf(engine, "mixer-a");
  const compared = { kind: state.kind, document: { ...state.document, l2: 0.9 } };
  const csv = await readCsv(write(withExtras(state, { compared }), { steps: 12 }));
  assert.ok(csv.comments.includes("# Ⓐ: length of B-C = 0.9 m"), String(csv.comments));
  const alone = await readCsv(write({ ...state, document: compared.document }, { steps: 12 }));
  for (let row = 0; row < 12; row++) assert.equal(csv.cell(row, "Ⓐ: rocker.angle"), alone.cell(row, "rocker.angle"));
  assert.ok(csv.header.includes("Ⓐ: reason"));
});

test("a name with a separator, quotes or a new line stays one cell", async () => {
  const words = wordsOf("en");
  const coordinate = new Coordinate("angle", { start: 0, end: TURN, full: true, arcs: [] });
  for (const [name, cell] of [["a,b", "\"a,b\""], ["say \"a\"", "\"say \"\"a\"\"\""], ["two\nlines", "\"two\nlines\""], ["plain", "plain"], ["a;b", "a;b"]]) {
    const table = { dimensions: [], columns: [{ name, quantity: null }], rows: [{ input: 0, values: [1], reason: null }], compared: null };
    const text = await toCsv(table, coordinate, PLAIN, words).text();
    assert.equal(text, `phi_deg,${cell},reason\n0,1,\n`);
  }
});

test("a name that a spreadsheet would take for a formula is left a text", async () => {
  const state = stateOf(engine, "crank-rocker");
  const { document } = state;
  const named = withDocument(state, { ...document, plots: [], links: document.links.map((link) => (link.name === "rocker" ? { ...link, name: "=1+1" } : link)) });
  const [head] = (await write(named, { dimensions: false }).text()).replace("\ufeff", "").split("\n");
  assert.ok(head.split(",").includes("'=1+1.angle_rad"), head);
  assert.ok(head.split(",").every((cell) => !cell.startsWith("=")), head);
});
