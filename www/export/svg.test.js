// Tests of pictures as SVG, and of the moments of a motion.
import assert from "node:assert/strict";
import test from "node:test";
import { Context, themeOf } from "assur/tests/canvas.js";
import { Transform } from "assur/canvas/transform.js";
import { inputs, moments, others, targetOn } from "assur/export/moments.js";
import { Figure } from "assur/stage/figure.js";
import { withDocument, withView } from "assur/state/state.js";
import { Page } from "assur/tests/page.js";

/** Stand-in for the canvas that measures texts and converts colours, which are given as #rrggbb or rgba(). */
globalThis.OffscreenCanvas = class OffscreenCanvas {
  getContext() {
    return Object.assign(new Context(), {
      getImageData() {
        const [, red, green, blue, alpha = "1"] = /^rgba?\((\d+), (\d+), (\d+)(?:, ([\d.]+))?\)$/.exec(this.fillStyle) ?? [];
        const hex = /^#(..)(..)(..)$/.exec(this.fillStyle)?.slice(1).map((part) => Number.parseInt(part, 16));
        return { data: hex ? [...hex, 255] : [red, green, blue, alpha * 255].map(Number) };
      },
    });
  }
};
const { Svg, SvgPath } = await import("assur/export/svg.js");

/** Elements of a picture with their content. Reads only the parts of XML that the pictures use. */
function elementsOf(text) {
  const found = [];
  const open = [];
  const plain = (part) => part.replace(/&(amp|lt|gt|quot);/g, (_, name) => ({ amp: "&", lt: "<", gt: ">", quot: "\"" })[name]);
  let at = 0;
  for (const match of text.matchAll(/<(\/?)([\w:]+)((?: [\w:-]+="[^"<]*")*)(\/?)>/g)) {
    const between = text.slice(at, match.index);
    assert.doesNotMatch(between, /[<>]|&(?!(amp|lt|gt|quot);)/);
    if (open.length > 0) open.at(-1).text += plain(between);
    at = match.index + match[0].length;
    const [, closing, name, attributes, empty] = match;
    if (closing) {
      assert.equal(open.pop().name, name);
      continue;
    }
    const element = { name, text: "", attributes: Object.fromEntries([...attributes.matchAll(/ ([\w:-]+)="([^"]*)"/g)].map(([, key, value]) => [key, plain(value)])) };
    found.push(element);
    if (!empty) open.push(element);
  }
  assert.deepEqual([open, text.slice(at).trim()], [[], ""]);
  return found;
}

test("words stay words, whatever is in them", () => {
  const words = "</title><script>alert(1)</script>&amp; \" ' ]]>";
  const svg = new Svg({ width: 10, height: 10 }, `${words}\u0001\ufffe`);
  svg.fillText(words, 1, 2);
  const [root, title, text] = elementsOf(svg.toString());
  assert.deepEqual([root.name, title.text, text.text], ["svg", words, words]);
});

test("a picture has its size, and is shown as large as it is asked for", () => {
  const [{ attributes }] = elementsOf(new Svg({ width: 300, height: 200 }, "t", 2).toString());
  assert.deepEqual([attributes.width, attributes.height, attributes.viewBox], ["600", "400", "0 0 300 200"]);
});

test("shapes have their colours, opacities, lines and places", () => {
  const svg = new Svg({ width: 10, height: 10 }, "t");
  const path = new SvgPath();
  path.moveTo(1, 2);
  path.lineTo(3, 4.123456789);
  path.closePath();
  Object.assign(svg, { fillStyle: "#ff8000", globalAlpha: 0.5 });
  svg.fill(path, "evenodd");
  Object.assign(svg, { strokeStyle: "rgba(0, 0, 255, 0.5)", globalAlpha: 1, lineWidth: 2, lineJoin: "round", lineCap: "round" });
  svg.setLineDash([6, 5]);
  svg.setTransform(1, 0, 0, -1, 5, 6);
  svg.stroke(path);
  svg.setTransform(1, 0, 0, 1, 0, 0);
  svg.fillRect(1, 2, 3, 4);
  const [, , filled, stroked, rect] = elementsOf(svg.toString()).map(({ attributes }) => attributes);
  assert.deepEqual(filled, { d: "M1 2L3 4.123457Z", "fill-rule": "evenodd", fill: "#ff8000", "fill-opacity": "0.5" });
  assert.deepEqual(stroked, {
    d: "M1 2L3 4.123457Z", fill: "none", stroke: "#0000ff", "stroke-width": "2", "stroke-opacity": "0.5", "stroke-linejoin": "round", "stroke-linecap": "round", "stroke-dasharray": "6 5",
    transform: "matrix(1 0 0 -1 5 6)",
  });
  assert.deepEqual(rect, { x: "1", y: "2", width: "3", height: "4", fill: "#ff8000" });
});

test("a circle is two halves, an arc goes where it ends", () => {
  const path = new SvgPath();
  path.arc(0, 0, 2, 0, 2 * Math.PI);
  const [start, ...halves] = path.data.split(/(?=[MLA])/);
  assert.equal(start, "M2 0");
  assert.equal(halves.length, 2);
  for (const [i, half] of halves.entries()) {
    const [x, y] = half.split(" ").slice(-2).map(Number);
    assert.ok(Math.hypot(x - (i === 0 ? -2 : 2), y) < 1e-9, half);
  }
});

test("text has its font and anchor, is squeezed into its width, and its halo is not read", () => {
  const svg = new Svg({ width: 10, height: 10 }, "t");
  Object.assign(svg, { font: "600 15px Fira Sans, sans-serif", textAlign: "center" });
  svg.strokeText("A", 1, 2);
  svg.fillText("A  b", 1, 2, 5);
  svg.fillText("", 1, 2);
  const texts = elementsOf(svg.toString()).filter(({ name }) => name === "text").map(({ attributes }) => attributes);
  assert.equal(texts.length, 2);
  assert.equal(texts[0]["aria-hidden"], "true");
  const { "font-family": family, "font-size": size, "font-weight": weight, "text-anchor": anchor, textLength, "xml:space": space } = texts[1];
  assert.deepEqual([family, size, weight, anchor, textLength, space], ["Fira Sans, sans-serif", "15", "600", "middle", "5", "preserve"]);
});

test("of the moments of an animation one is seen at any time, each in its turn", () => {
  const count = 12;
  const svg = new Svg({ width: 10, height: 10 }, "t");
  for (let number = 0; number < count; number++) {
    svg.moment(number, count, 2);
    svg.end();
  }
  const animations = elementsOf(svg.toString()).filter(({ name }) => name === "animate").map(({ attributes }) => attributes);
  assert.equal(animations.length, count);
  for (let k = 0; k < count; k++) {
    const seen = animations.filter(({ values, keyTimes, dur, repeatCount, calcMode }) => {
      assert.deepEqual([dur, repeatCount, calcMode], ["2s", "indefinite", "discrete"]);
      const at = keyTimes.split(";").map(Number).findLastIndex((time) => time <= (k + 0.5) / count);
      return values.split(";")[at] === "inline";
    });
    assert.deepEqual(seen, [animations[k]]);
  }
});

test("the drawing as SVG has the roles' colours, the labels, and nothing that runs or loads", () => {
  const page = new Page("mixer-a", { phi_deg: 75 });
  const theme = themeOf(page.engine.roles);
  const figure = new Figure(page.engine, theme, () => new SvgPath());
  figure.take(page.now());
  const size = { width: 600, height: 400 };
  const svg = new Svg(size, "Mixer");
  const target = { context: svg, ratio: 1 };
  const view = Transform.fit(page.now().summary.bounds, 600, 400, 20);
  figure.paintGround(target, size, view);
  figure.paintMoving(target, view);
  figure.paintLabels(target, view, size, false);
  const elements = elementsOf(svg.toString());
  for (const { name, attributes } of elements) {
    assert.ok(["svg", "title", "rect", "path", "text"].includes(name), name);
    for (const key of Object.keys(attributes)) assert.ok(!/^on|href|style/.test(key), key);
    assert.ok(!/NaN|undefined/.test(JSON.stringify(attributes)), JSON.stringify(attributes));
  }
  const labels = elements.filter(({ name, attributes }) => name === "text" && !attributes["aria-hidden"]).map(({ text }) => text);
  for (const label of ["A", "B", "C", "D", "4", "5", "φ₁ = 75.0°"]) assert.equal(labels.filter((text) => text === label).length, 1, `${label} in ${labels}`);
  const painted = (attribute, role) => elements.filter(({ name, attributes }) => name === "path" && attributes[attribute] === theme.colours[role]).length;
  // Coupler: one filled bar. Crank: a filled bar, and the arc of φ₁ with a filled head; the path of B has the colour of the crank, too.
  assert.deepEqual([painted("fill", "coupler"), painted("stroke", "coupler"), painted("fill", "crank"), painted("stroke", "crank")], [1, 0, 2, 2]);
});

/** Differences of consecutive numbers. */
const steps = (list) => list.slice(1).map((value, i) => value - list[i]);

test("the moments of a turn are equal steps from where it is, so that it goes on without a jump", () => {
  const page = new Page("jansen", { phi_deg: 30 });
  const all = inputs(page, 24);
  assert.equal(all.length, 24);
  assert.ok(Math.abs(all[0] - Math.PI / 6) < 1e-12);
  const turn = 2 * Math.PI;
  for (const step of steps([...all, all[0]])) assert.ok(Math.abs((((step % turn) + turn) % turn) - turn / 24) < 1e-9, String(step));
  assert.deepEqual(others(page, 24), all.slice(1));
});

test("what cannot turn goes there and back, and poses are not shown twice", () => {
  const page = new Page("chebyshev", { phi_deg: 90 });
  const { arcs: [[from, to]] } = page.now().summary.cycle;
  const all = inputs(page, 12);
  assert.deepEqual([all[0], all[6]], [from, to]);
  for (let k = 1; k < 6; k++) assert.ok(Math.abs(all[k] - all[12 - k]) < 1e-12);
  const poses = others(page, 8);
  assert.equal(new Set(poses.map((one) => one.toFixed(9))).size, poses.length);
});

test("time goes on, and what does not move has no moments", () => {
  const train = new Page("train-gears");
  assert.ok(steps(inputs(train, 10)).every((step) => step > 0));
  const scheme = new Page("mobility-1a");
  assert.deepEqual([inputs(scheme, 10), others(scheme, 10)], [[], []]);
});

const work = (more = {}) => ({ signal: new AbortController().signal, tell: () => {}, ...more });

test("every moment has its frame and its numbers, and progress is reported", async () => {
  const page = new Page("jansen");
  const told = [];
  const all = [];
  for await (const here of moments(page, inputs(page, 6), work({ tell: (share) => told.push(share) }))) all.push(here);
  assert.equal(all.length, 6);
  for (const { frame, frameInput, readouts } of all) assert.deepEqual([[...frame], readouts], [[...page.engine.at(frameInput).frame], page.engine.at(frameInput).readouts]);
  assert.deepEqual(told.map((share) => Math.round(share * 6)), [1, 2, 3, 4, 5, 6]);
});

test("moments are given up where they are not wanted any more, and where the mechanism becomes another", async () => {
  const page = new Page("jansen");
  const controller = new AbortController();
  const run = async (after, signal = new AbortController().signal) => {
    for await (const here of moments(page, inputs(page, 6), work({ signal }))) after(here);
  };
  await assert.rejects(run(() => controller.abort(), controller.signal), { name: "AbortError" });
  await assert.rejects(run(() => {
    page.store.update((state) => withDocument(state, { title: "other" }));
    page.now();
  }), { name: "AbortError" });
});

test("moments are of the mechanism that they were asked for, whatever there is once the first is taken", async () => {
  const page = new Page("peaucellier");
  const asked = moments(page, inputs(page, 6), work());
  page.store.update((state) => withDocument(state, { title: "other" }));
  page.now();
  await assert.rejects(asked.next(), { name: "AbortError" });
});

test("where no moment has a pose it is said why", async () => {
  const page = new Page("mixer-a", { phi_deg: 10 });
  for (const lengths of [{ l1: 0.8 }, { l2: 0.4 }]) {
    page.store.update((state) => withDocument(state, lengths));
    page.now();
  }
  page.store.update((state) => withView(state, { phi_deg: 10 }));
  await assert.rejects(async () => {
    for await (const _ of moments(page, [Math.PI], work())) assert.fail("a pose");
  }, ({ problems }) => problems.length > 0);
});

test("a film has pictures of even sides, and never more than its sheet", () => {
  for (const [width, sheet] of [[321, { width: 700, height: 333 }], [640, { width: 640, height: 481 }], [320, { width: 999, height: 500 }]]) {
    const canvas = { getContext: () => new Context() };
    const { ratio } = targetOn(canvas, sheet, width);
    assert.ok(canvas.width % 2 === 0 && canvas.height % 2 === 0, `${canvas.width} ${canvas.height}`);
    assert.ok(canvas.width <= width && canvas.height <= sheet.height * ratio + 1e-9);
    assert.equal(ratio, width / sheet.width);
  }
});
