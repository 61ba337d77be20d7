// A document of elements that can be put together and read again: no styles, no layout.
import "assur/tests/window.js";

globalThis.Node = class Node extends EventTarget {};

globalThis.HTMLElement = class HTMLElement extends Node {
  children = [];
  attributes = {};
  dataset = {};
  hidden = false;

  constructor(tag = "") {
    super();
    this.tagName = tag.toUpperCase();
  }

  get textContent() {
    return this.children.map((child) => (typeof child === "string" ? child : child.textContent)).join("");
  }

  set textContent(text) {
    this.children = [text];
  }

  setAttribute(name, value) {
    this.attributes[name] = value;
  }

  getAttribute(name) {
    return this.attributes[name] ?? null;
  }

  append(...children) {
    this.children.push(...children);
  }

  replaceChildren(...children) {
    this.children = children;
  }

  /** What is put before others is noted. */
  before(...sections) {
    document.sections.push(...sections);
  }

  /** @returns {HTMLElement[]} what is in it, in the order of the document */
  get all() {
    return this.children.flatMap((child) => (typeof child === "string" ? [] : [child, ...child.all]));
  }
};

/** Those that are found by an id, made when they are first asked for. */
const found = new Map();

globalThis.document = Object.assign(new EventTarget(), {
  createElement: (tag) => new HTMLElement(tag),
  sections: [],
  getElementById: (id) => found.get(id) ?? found.set(id, new HTMLElement()).get(id),
});
