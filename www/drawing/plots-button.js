// The button that brings the plots back beside the drawing. The stage has one size with them and one without, whether
// the drawing moves or not.
import { byId, make, makeSvg, setData } from "assur/core/dom.js";

/** @param {import("assur/core/words.js").Words} words */
export function addPlotsButton(words) {
  const svg = makeSvg("svg", { viewBox: "0 0 24 24", "aria-hidden": "true" }, [makeSvg("path", { d: "M4 4v16h16M7 15c3-9 5-9 7-4s4 3 6-3" })]);
  const button = make("button", {
    id: "draw-plots", class: "control", type: "button", "aria-pressed": "false", "data-t-label": "draw.plots", "data-t-title": "draw.plots",
    onclick: () => {
      const shown = button.getAttribute("aria-pressed") !== "true";
      button.setAttribute("aria-pressed", String(shown));
      setData(document.documentElement, "plots", String(shown));
    },
  }, [svg]);
  const draw = byId("draw", HTMLButtonElement);
  draw.before(button);
  words.fill(draw.parentElement ?? document);
  return button;
}
