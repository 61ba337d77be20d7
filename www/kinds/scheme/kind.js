// Views for a scheme of links and pairs.
import { StatusLine } from "assur/controls/status.js";
import { Description } from "assur/kinds/scheme/description.js";
import { FormulasView } from "assur/kinds/scheme/formulas.js";
import { GeometryView } from "assur/kinds/scheme/geometry.js";
import { LookView } from "assur/kinds/scheme/look.js";
import { MethodView } from "assur/kinds/scheme/method.js";
import { Opening } from "assur/kinds/scheme/opening.js";
import { PairsView } from "assur/kinds/scheme/pairs.js";
import { PracticeView } from "assur/kinds/scheme/practice.js";
import { ENTRIES } from "assur/kinds/scheme/status.js";
import "assur/kinds/scheme/style.js";

/** Words that only this kind has. */
export const words = "kinds/scheme/later.*";

/** @type {import("assur/app/views.js").Make} */
export const views = (page) => [
  new Opening(page), new MethodView(page), new FormulasView(), new GeometryView(page), new PairsView(page), new LookView(page), new PracticeView(page),
  new StatusLine("scheme", ENTRIES, page), new Description(),
];
