// Tests of the field for a number: typed text that is not a number, and the text that the field writes.
import assert from "node:assert/strict";
import test from "node:test";
import { NumberBox } from "assur/controls/number-box.js";
import { Numbers } from "assur/core/numbers.js";
import { Drafts } from "assur/state/drafts.js";
import { LANGUAGES } from "assur/tests/words.js";

/** Stand-in for a text field. */
class Field extends EventTarget {
  value = "";
  attributes = {};
  select() {}
  getAttribute(name) { return this.attributes[name] ?? null; }
  setAttribute(name, value) { this.attributes[name] = value; }
  removeAttribute(name) { delete this.attributes[name]; }
}
globalThis.document = { activeElement: null };

/** Field for a number of a state. The state limits the number to 9. */
function begin(lang = "en", value = 0.370001234) {
  const [field, drafts, numbers] = [new Field(), new Drafts(() => {}), new Numbers(lang)];
  let state = value;
  const box = new NumberBox(field, "l1", drafts, (next) => (state = Math.min(next, 9)));
  const show = (invalid = false) => box.show(state, { brief: numbers.brief(state), full: numbers.exact(state) }, invalid);
  const happen = (type, more = {}) => {
    field.dispatchEvent(Object.assign(new Event(type), more));
    show();
  };
  const type = (text) => {
    field.value = text;
    happen("input");
  };
  const enter = () => {
    document.activeElement = field;
    happen("focus");
  };
  const leave = () => {
    document.activeElement = null;
    happen("blur");
  };
  document.activeElement = null;
  show();
  return { field, drafts, box, show, happen, type, enter, leave, state: () => state };
}

test("a number is brief at a glance and whole for who is about to change it", () => {
  const { field, enter, leave } = begin();
  assert.equal(field.value, "0.370001");
  enter();
  assert.equal(field.value, "0.370001234");
  leave();
  assert.equal(field.value, "0.370001");
});

for (const lang of LANGUAGES) {
  test(`focus and a digit more change nothing but the digit (${lang})`, () => {
    for (const value of [0.37, 36, 1234567.5, 1e-5, -40.25]) {
      const { field, enter, type, state } = begin(lang, value);
      enter();
      const whole = field.value;
      type(whole);
      assert.equal(state(), Math.min(value, 9));
      type(whole.replace(/\d$/, "$&"));
      assert.equal(field.value, whole);
    }
  });
}

test("while it is typed a text stays as it is, though the state follows", () => {
  const { field, enter, type, leave, state } = begin();
  enter();
  for (const [text, value] of [["0", 0], ["0,", 0], ["0,9", 0.9], ["0,90", 0.9]]) {
    type(text);
    assert.deepEqual([field.value, state()], [text, value]);
  }
  leave();
  assert.equal(field.value, "0.9");
});

test("what is no number stays, is marked and told, and leaves the state", () => {
  const { field, drafts, enter, type, leave, state } = begin();
  enter();
  for (const text of ["", "abc", "--1", "0,0,", "NaN", "1e999"]) {
    type(text);
    assert.deepEqual([field.value, drafts.has("l1"), state()], [text, true, 0.370001234]);
    assert.deepEqual([field.attributes["aria-invalid"], field.attributes["aria-describedby"]], ["true", "problem"]);
  }
  leave();
  assert.equal(field.value, "1e999");
  type("0.5");
  assert.deepEqual([drafts.has("l1"), field.attributes["aria-invalid"], "aria-describedby" in field.attributes], [false, "false", false]);
});

test("Escape brings back the number that is", () => {
  const { field, drafts, enter, type, happen } = begin();
  enter();
  type("abc");
  happen("keydown", { key: "a" });
  assert.equal(field.value, "abc");
  happen("keydown", { key: "Escape" });
  assert.deepEqual([field.value, drafts.has("l1")], ["0.370001234", false]);
});

test("what a number becomes is written out when the field is left", () => {
  const { field, enter, type, leave } = begin();
  enter();
  type("12");
  assert.equal(field.value, "12");
  leave();
  assert.equal(field.value, "9");
});

test("what is refused is marked and stays", () => {
  const { field, show } = begin();
  show(true);
  assert.equal(field.attributes["aria-invalid"], "true");
  show(false);
  assert.equal(field.attributes["aria-invalid"], "false");
});
