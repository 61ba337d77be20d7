// A document of elements that can be put together and read again: no styles, no layout.
import "assur/tests/window.js";

globalThis.Node = class Node extends EventTarget {};

globalThis.HTMLElement = class HTMLElement extends Node {
  children = [];
  attributes = {};
  dataset = {};
  style = { setProperty() {} };
  classList = new Set();
  hidden = false;
  title = "";

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

  removeAttribute(name) {
    delete this.attributes[name];
  }

  append(...children) {
    this.children.push(...children);
  }

  prepend(...children) {
    this.children.unshift(...children);
  }

  replaceChildren(...children) {
    this.children = children;
  }

  /** What is put before others is noted. */
  before(...sections) {
    document.sections.push(...sections);
  }

  remove() {}

  /** @param {string} tag */
  querySelector(tag) {
    return this.all.find(({ tagName }) => tagName === tag.toUpperCase()) ?? null;
  }

  get ownerDocument() {
    return document;
  }

  contains(element) {
    return element === this || this.all.includes(element);
  }

  /** @param {string} selector of an attribute: `[data-t]` */
  querySelectorAll(selector) {
    return this.all.filter(({ attributes }) => selector.slice(1, -1) in attributes);
  }

  /** @returns {HTMLElement[]} what is in it, in the order of the document */
  get all() {
    return this.children.flatMap((child) => (typeof child === "string" ? [] : [child, ...child.all]));
  }
};

/** Those that are found by an id, made when they are first asked for; those that are no plain ones are put there. */
export const found = new Map();

/** A style sheet is there as soon as it is asked for. */
class Head extends HTMLElement {
  append(sheet) {
    sheet.onload?.();
  }
}

/** A parsed picture is an element that holds its text. */
globalThis.DOMParser = class DOMParser {
  parseFromString(text) {
    const documentElement = new HTMLElement("svg");
    documentElement.textContent = text;
    return { documentElement };
  }
};
globalThis.HTMLTableElement = class HTMLTableElement extends HTMLElement {
  tHead = new HTMLElement("thead");
  tBodies = [new HTMLElement("tbody")];
  children = [this.tHead, ...this.tBodies];
};
globalThis.HTMLCanvasElement = class HTMLCanvasElement extends HTMLElement {};
globalThis.getComputedStyle = () => ({ getPropertyValue: () => "", fontFamily: "sans-serif", fontSize: "14px" });
globalThis.matchMedia = () => new EventTarget();

globalThis.document = Object.assign(new EventTarget(), {
  createElement: (tag) => new HTMLElement(tag),
  sections: [],
  body: new HTMLElement("body"),
  head: new Head("head"),
  createElementNS: (_, tag) => new HTMLElement(tag),
  querySelectorAll: () => [],
  getElementById: (id) => found.get(id) ?? found.set(id, new HTMLElement()).get(id),
});
