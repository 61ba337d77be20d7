// The catalogue of mechanisms, and its entry for a state.
import { attempt } from "assur/core/problem.js";
import { contains } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/state.js").Frozen<import("assur/types/file.js").Preset>} Preset
 */

export class Catalogue {
  #all;
  /** @type {readonly Preset[] | null} */
  #presets = null;

  /**
   * @param {readonly Preset[]} mixers the mixers, which come first; they are in the first part of the engine
   * @param {() => readonly Preset[]} all gives all presets; it needs the second part
   */
  constructor(mixers, all) {
    this.mixers = mixers;
    this.#all = all;
  }

  get presets() {
    return (this.#presets ??= this.#all());
  }

  /**
   * @param {string} id
   * @returns {Preset | undefined} the preset with this name
   */
  preset(id) {
    return this.presets.find((preset) => preset.id === id);
  }

  /**
   * @param {Pick<State, "kind" | "document">} state
   * @returns {Preset | undefined} preset that `origin` names; without this field, the preset with the same dimensions. If the second
   * part of the engine has not loaded, only mixers are found
   */
  presetOf({ kind, document }) {
    const presets = () => attempt(() => this.presets).value ?? [];
    if ("origin" in document) return presets().find(({ id }) => id === document.origin);
    const isOf = (/** @type {Preset} */ preset) => {
      const { tracers, ...dimensions } = /** @type {{ tracers?: unknown }} */ (preset.document);
      return preset.kind === kind && contains(document, dimensions);
    };
    return this.mixers.find(isOf) ?? presets().find(isOf);
  }

  /**
   * @param {Pick<State, "kind" | "document" | "lesson">} state
   * @returns {string} name of the state's files, without extension: the title of a lecturer's lesson, or else the name of
   * the preset (`jansen`), the title of the document, or the name of its kind (`linkage`)
   */
  fileName({ kind, document, lesson }) {
    const title = "title" in document ? document.title : "";
    return named(lesson?.title) || this.presetOf({ kind, document })?.id || named(title) || kind;
  }
}

/** Greatest length of a title in the name of a file, in characters. */
const MAX_NAME = 60;

/**
 * @param {string | null} [title]
 * @returns {string} its letters and digits, with hyphens between the words
 */
function named(title) {
  return (title ?? "").normalize("NFC").match(/[\p{L}\p{M}\p{N}]+/gu)?.join("-").slice(0, MAX_NAME) ?? "";
}
