// Tests of the table of keys: the command of each key, the elements that use a key themselves, and the entries in the help.
import assert from "node:assert/strict";
import test from "node:test";
import { happen } from "assur/tests/window.js";
import { wordsOf, LANGUAGES } from "assur/tests/words.js";

// Stand-ins for the elements that the key handler uses.
globalThis.Element = class Element {
  attributes = {};
  append() {}
  setAttribute(name, value) { this.attributes[name] = value; }
  closest(selector) { return selector.split(", ").includes(this.tag) ? this : null; }
};
globalThis.HTMLElement = class HTMLElement extends Element {
  constructor(tag = "div", more = {}) { super(); Object.assign(this, { tag, isContentEditable: false }, more); }
};
globalThis.HTMLInputElement = class HTMLInputElement extends HTMLElement {
  constructor(type, more = {}) { super("input", { type, ...more }); }
};
for (const name of ["HTMLSelectElement", "HTMLTextAreaElement"]) globalThis[name] = class extends HTMLElement {};
const controls = new Map();
let dialog = null;
globalThis.document = {
  body: new HTMLElement("body"),
  getElementById: (id) => controls.get(id) ?? (controls.set(id, new HTMLElement("button")), controls.get(id)),
  querySelector: () => dialog,
  createElement: () => new HTMLElement("kbd"),
};

const { KEYS, combinations, listen } = await import("assur/app/keys.js");
const done = [];
listen(Object.fromEntries(KEYS.map(({ command }) => [command, () => done.push(command)])));

/**
 * @param {string} key
 * @param {object} [more] of the event
 * @returns {string} the commands that the key ran
 */
function press(key, more = {}) {
  done.length = 0;
  const { target = document.body, ...rest } = more;
  const code = rest.code ?? (/^[a-z]$/i.test(key) ? `Key${key.toUpperCase()}` : "");
  const event = happen("keydown", { target, key, shiftKey: false, ctrlKey: false, metaKey: false, altKey: false, isComposing: false, repeat: false, ...rest, code });
  assert.equal(event.defaultPrevented, done.some((command) => command !== "close") || (rest.repeat === true && event.defaultPrevented));
  return done.join();
}

const control = { ctrlKey: true };
const shift = { shiftKey: true };

test("every key does what it says", () => {
  const table = [
    [" ", {}, "play"], ["ArrowLeft", {}, "back"], ["ArrowRight", {}, "forward"], ["ArrowLeft", shift, "back10"], ["ArrowRight", shift, "forward10"], ["Home", {}, "start"], ["End", {}, "end"],
    ["+", shift, "faster"], ["=", {}, "faster"], ["-", {}, "slower"], ["r", {}, "reverse"], ["1", {}, "assembly1"], ["2", {}, "assembly2"], ["t", {}, "trace"], ["f", {}, "all"], ["n", {}, "new-drawing"],
    ["d", {}, "draw"], ["z", control, "undo"], ["z", { ...control, ...shift }, "redo"], ["y", control, "redo"], ["e", {}, "export"], ["g", {}, "gallery"], ["l", {}, "lesson"], ["p", {}, "projector"],
    ["s", {}, "settings"], ["?", shift, "help"], ["Escape", {}, "close"],
  ];
  for (const [key, more, command] of table) assert.equal(press(key, more), command, key);
  assert.deepEqual(new Set(table.map(([, , command]) => command)), new Set(KEYS.map(({ command }) => command)));
  assert.equal(press("z", { metaKey: true }), "undo");
});

test("a letter is that of its place where the layout has none of the Latin alphabet", () => {
  for (const [key, code, command] of [["к", "KeyR", "reverse"], ["я", "KeyZ", ""], ["Л", "KeyL", "lesson"], ["ү", "KeyG", "gallery"]]) assert.equal(press(key, { code }), command, key);
  assert.equal(press("я", { code: "KeyZ", ...control }), "undo");
  // On a layout with Latin letters, the letter counts, not its position.
  assert.equal(press("z", { code: "KeyY" }), "");
});

test("keys that are nobody's, or another's, are left alone", () => {
  for (const [key, more] of [["q", {}], ["r", control], ["r", shift], ["r", { altKey: true }], ["r", { isComposing: true }], ["ArrowUp", {}], ["F5", {}]]) assert.equal(press(key, more), "", key);
  dialog = {};
  assert.equal(press("r"), "");
  dialog = null;
});

test("a key held down does again only what may be done again and again", () => {
  for (const { command, combos: [combo], again } of KEYS.filter(({ combos: [one] }) => /^(Arrow\w+|[A-Z])$/.test(one))) {
    assert.equal(press(combo.length === 1 ? combo.toLowerCase() : combo, { repeat: true }), again ? command : "", command);
  }
});

test("an element that uses keys itself has them", () => {
  const input = (type, more) => new HTMLInputElement(type, more);
  const own = [
    [input("text"), ["r", "ArrowLeft", " ", "Home", "1"], []],
    [input("number"), ["1", "-"], []],
    [input("range"), ["ArrowLeft", "Home", "End"], [[" ", {}, "play"], ["z", control, "undo"], ["r", {}, "reverse"]]],
    [input("radio"), ["ArrowRight", " "], [["Home", {}, "start"], ["r", {}, "reverse"]]],
    [input("checkbox"), [" "], [["r", {}, "reverse"], ["ArrowLeft", {}, "back"]]],
    [new HTMLElement("button"), [" "], [["r", {}, "reverse"]]],
    [new HTMLSelectElement("select"), ["r", "2", " ", "ArrowLeft"], [["z", control, "undo"]]],
    [new HTMLTextAreaElement("textarea"), ["r", "?"], []],
    [new HTMLElement("div", { isContentEditable: true }), ["r"], []],
  ];
  for (const [target, left, ours] of own) {
    for (const key of left) assert.equal(press(key, { target }), "", `${target.tag} ${target.type} ${key}`);
    for (const [key, more, command] of ours) assert.equal(press(key, { ...more, target }), command, `${target.tag} ${target.type} ${key}`);
  }
});

test("on the scrubber up and down are forward and back", () => {
  const target = new HTMLInputElement("range", { id: "scrubber" });
  for (const [key, more, command] of [["ArrowUp", {}, "forward"], ["ArrowDown", {}, "back"], ["ArrowUp", shift, "forward10"], ["ArrowLeft", {}, "back"], ["Home", {}, "start"]]) assert.equal(press(key, { ...more, target }), command);
});

test("no combination occurs twice, and each control names its own to screen readers", () => {
  const combos = KEYS.flatMap((key) => key.combos);
  assert.equal(new Set(combos).size, combos.length);
  for (const key of KEYS.filter((one) => one.control)) assert.equal(controls.get(key.control).attributes["aria-keyshortcuts"], key.combos.join(" "));
});

test("the help names every key in every language", () => {
  for (const lang of LANGUAGES) {
    const rows = combinations(wordsOf(lang));
    assert.equal(rows.length, KEYS.length);
    for (const [i, { name, keys }] of rows.entries()) {
      assert.ok(name.length > 1 && name !== KEYS[i].name, `${lang} ${name}`);
      assert.ok(keys.length > 0);
    }
  }
});
