// The catalogue of mechanisms, and its entry for a state.
import { contains } from "assur/state/state.js";

/**
 * @typedef {import("assur/state/state.js").State} State
 * @typedef {import("assur/state/state.js").Frozen<import("assur/types/file.js").Preset>} Preset
 */

export class Catalogue {
  /** @param {readonly Preset[]} presets */
  constructor(presets) {
    this.presets = presets;
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
   * @returns {Preset | undefined} preset that `origin` names; without this field, the preset with the same dimensions
   */
  presetOf({ kind, document }) {
    if ("origin" in document) return this.preset(document.origin ?? "");
    return this.presets.find((preset) => {
      const { tracers, ...dimensions } = /** @type {{ tracers?: unknown }} */ (preset.document);
      return preset.kind === kind && contains(document, dimensions);
    });
  }

  /**
   * @param {State} state
   * @returns {string} name of the state's files: that of its preset (`jansen`), or else that of its kind (`linkage`)
   */
  fileName(state) {
    return this.presetOf(state)?.id ?? state.kind;
  }
}
