// Tests of the search for a dwell, with its worker.
import "assur/tests/document.js";
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import test, { afterEach } from "node:test";
import { DesignView } from "assur/kinds/linkage/design.js";
import { WASM } from "assur/tests/engine.js";
import { Page } from "assur/tests/page.js";
import { withoutStack } from "assur/tests/stack.js";
import { Worker, endWorkers, fetchFile } from "assur/tests/worker.js";

/** Time limit for the answers of a worker, in milliseconds. */
const PATIENCE = Object.freeze({ timeout: 20_000 });

globalThis.Worker = Worker;
globalThis.fetch = fetchFile;
afterEach(endWorkers);

/** The search on a page. `press` presses one of its buttons; `until` waits for a text in its message. */
function begin({ signal }) {
  const page = new Page("class4-dwell");
  const view = new DesignView(page);
  view.render(page.now());
  const find = (id) => view.element.querySelector(`#${id}`);
  const press = (id) => find(id).dispatchEvent(new Event("click"));
  const until = async (holds) => {
    while (!signal.aborted && !holds(find("design-progress").textContent)) await new Promise((done) => setTimeout(done, 5));
  };
  return { page, find, press, until };
}

test("lengths may change of links with two points only", PATIENCE, (t) => {
  const { page, find } = begin(t);
  const { links } = page.store.get().document;
  for (const [index, { name, points }] of links.entries()) assert.equal(find(`design-move-${index}`) !== null, points.length === 2, name);
});

test("a search whose stack overflows says that it broke, ten in a row, and the next one searches", PATIENCE, async (t) => {
  const { page, find, press, until } = begin(t);
  const broken = new WebAssembly.Module(withoutStack(readFileSync(WASM)));
  const { postMessage } = Worker.prototype;
  const small = t.mock.method(Worker.prototype, "postMessage", function (data) {
    postMessage.call(this, { ...data, ...(data.wasm && { wasm: broken }) });
  });
  const broke = page.words.text("problem.part_broke");
  for (let times = 0; times < 10; times++) {
    press("design-start");
    assert.equal(find("design-progress").textContent, page.words.text("design.coming"));
    await until((said) => said === broke);
    assert.deepEqual([Worker.running.size, find("design-start").hidden, find("design-stop").hidden], [0, false, true]);
  }
  small.mock.restore();
  const [before] = page.words.text("design.progress").split("{");
  press("design-start");
  await until((said) => said.startsWith(before));
  press("design-stop");
  assert.ok(find("design-progress").textContent.includes(page.words.text("design.stopped")));
});
