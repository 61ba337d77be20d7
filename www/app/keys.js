// The table of keyboard shortcuts, used by the key handler, the help and screen readers alike.
import { byId, make } from "assur/core/dom.js";

/**
 * @typedef {import("assur/core/words.js").Words} Words
 * @typedef {Readonly<{ command: string, name: string, combos: readonly string[], control?: string, again?: boolean }>} Key
 * `name`: key of the text that describes the command. `combos`: key combinations, written as in aria-keyshortcuts.
 * `control`: id of the element with the same effect. `again`: holding the key down repeats the command.
 */

/** @type {readonly Key[]} */
export const KEYS = Object.freeze([
  { command: "play", name: "key.play", combos: ["Space"], control: "play" },
  { command: "back", name: "key.back", combos: ["ArrowLeft"], control: "step-back", again: true },
  { command: "forward", name: "key.forward", combos: ["ArrowRight"], control: "step-forward", again: true },
  { command: "back10", name: "key.back10", combos: ["Shift+ArrowLeft"], again: true },
  { command: "forward10", name: "key.forward10", combos: ["Shift+ArrowRight"], again: true },
  { command: "start", name: "key.start", combos: ["Home"] },
  { command: "end", name: "key.end", combos: ["End"] },
  { command: "faster", name: "key.faster", combos: ["Plus", "="], control: "speed" },
  { command: "slower", name: "key.slower", combos: ["-"] },
  { command: "reverse", name: "transport.reverse", combos: ["R"], control: "reverse" },
  { command: "assembly1", name: "key.assembly1", combos: ["1"] },
  { command: "assembly2", name: "key.assembly2", combos: ["2"] },
  { command: "trace", name: "tracers.trace", combos: ["T"], control: "trace" },
  { command: "all", name: "zoom.all", combos: ["F"], control: "zoom-all" },
  { command: "new-drawing", name: "draw.new", combos: ["N"], control: "new-drawing" },
  { command: "draw", name: "draw.open", combos: ["D"], control: "draw" },
  { command: "undo", name: "edit.undo", combos: ["Control+Z"], control: "undo", again: true },
  { command: "redo", name: "edit.redo", combos: ["Control+Shift+Z", "Control+Y"], control: "redo", again: true },
  { command: "export", name: "menu.export", combos: ["E"], control: "export" },
  { command: "gallery", name: "gallery.open", combos: ["G"], control: "gallery" },
  { command: "lesson", name: "key.lesson", combos: ["L"], control: "tab-lesson" },
  { command: "projector", name: "view.projector", combos: ["P"], control: "projector" },
  { command: "settings", name: "view.settings", combos: ["S"], control: "settings" },
  { command: "help", name: "help.label", combos: ["?"], control: "help-open" },
  { command: "close", name: "key.close", combos: ["Escape"] },
]);

/** Signs shown for some keys in place of their names. */
const SIGNS = Object.freeze({ ArrowLeft: "←", ArrowRight: "→", Plus: "+", "-": "−", Control: "Ctrl", Escape: "Esc" });

/** Arrow keys of the focused scrubber, each with the arrow key of the table that has the same effect. */
const SCRUBBER = Object.freeze({ ArrowUp: "ArrowRight", ArrowDown: "ArrowLeft" });

/** Combinations to which an element with the focus responds itself, by the kind of element. */
const OWN = Object.freeze({
  range: /Arrow|Home|End/,
  radio: /Arrow|^Space$/,
  press: /^Space$/,
  select: /^[^+]+$|^Shift\+/,
});

/**
 * Runs each command of the table when one of its keys is pressed, and gives the keys to the elements with the same effect, for screen readers.
 * @param {import("assur/app/commands.js").Commands} commands
 */
export function listen(commands) {
  addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.isComposing || event.altKey) return;
    const target = event.target instanceof Element ? event.target : document.body;
    const combo = combination(event, target.id === "scrubber");
    const key = KEYS.find(({ combos }) => combos.includes(combo));
    if (!key || document.querySelector("dialog[open]") || own(target, combo)) return;
    // Escape keeps its usual action in the browser; for the other keys the command replaces that action.
    if (key.command !== "close") event.preventDefault();
    if (!event.repeat || key.again) commands[key.command]();
  });
  for (const { control, combos } of KEYS) {
    if (control) byId(control, HTMLElement).setAttribute("aria-keyshortcuts", combos.join(" "));
  }
}

/**
 * @param {Words} words
 * @returns {{ name: string, keys: (Node | string)[] }[]} rows of the table of keys in the help
 */
export function combinations(words) {
  return KEYS.map(({ name, combos }) => {
    const keys = combos.flatMap((combo, i) => [
      ...(i > 0 ? [" "] : []),
      ...combo.split("+").flatMap((part, j) => [...(j > 0 ? ["+"] : []), make("kbd", {}, [sign(part, words)])]),
    ]);
    return { name: words.text(name), keys };
  });
}

/**
 * @param {string} part
 * @param {Words} words
 */
function sign(part, words) {
  if (part === "Space") return words.text("key.space");
  return Object.entries(SIGNS).find(([name]) => name === part)?.[1] ?? part;
}

/**
 * @param {KeyboardEvent} event
 * @param {boolean} scrubber
 * @returns {string} combination, written as in the table
 */
function combination(event, scrubber) {
  const shift = event.shiftKey ? "Shift+" : "";
  const control = event.ctrlKey || event.metaKey ? "Control+" : "";
  const { key, code } = event;
  // On a layout without Latin letters, the position of the key determines the letter.
  if (/^[a-z]$/i.test(key)) return control + shift + key.toUpperCase();
  if (/^Key[A-Z]$/.test(code) && !/^[ -~]$/.test(key)) return control + shift + code.slice(3);
  if (key === " ") return `${control}${shift}Space`;
  if (key === "+") return `${control}Plus`;
  // For any other character, Shift is ignored: on some keyboard layouts the character is typed with Shift.
  if (key.length === 1) return control + key;
  const arrow = scrubber ? Object.entries(SCRUBBER).find(([name]) => name === key)?.[1] : undefined;
  return control + shift + (arrow ?? key);
}

/**
 * Whether the element with the focus uses a combination itself.
 * @param {Element} target
 * @param {string} combo
 */
function own(target, combo) {
  if (target instanceof HTMLSelectElement) return OWN.select.test(combo);
  if (target.closest("button, summary, a")) return OWN.press.test(combo);
  if (target instanceof HTMLTextAreaElement) return true;
  if (!(target instanceof HTMLInputElement)) return target instanceof HTMLElement && target.isContentEditable;
  if (target.id === "scrubber") return false;
  if (target.type === "range") return OWN.range.test(combo);
  if (target.type === "radio") return OWN.radio.test(combo);
  return target.type === "checkbox" ? OWN.press.test(combo) : true;
}
