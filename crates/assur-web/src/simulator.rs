//! The interface of the page to the engine.

mod refusal;

use assur::Point;
use assur_edit::Edit;
use assur_file::{LengthUnit, Problem};
use plotters::prelude::IntoDrawingArea;
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};
use web_sys::CanvasRenderingContext2d;

use crate::canvas::Canvas;
use crate::capabilities::{Capabilities, Edited, Moves, RelationHere, unknown};
use crate::chart::{ChartLayout, ChartRequest};
use crate::convert::{read, read_value, thrown, to_js};
use crate::kinds::{as_kind, draft, open};
use crate::moving::Moving;
use crate::table::SweepTable;
use refusal::place;
pub(crate) use refusal::{bad, one};

/// An open document with its drawing. Inputs are radians, or for a driven slide in the unit of the
/// lengths. A method that fails throws an array of problems, `{code, …}`, and changes nothing.
#[wasm_bindgen]
#[derive(Default)]
pub struct Simulator {
    document: Option<Box<dyn Capabilities>>,
    /// The unit of its lengths, and whether the document has a field for it.
    lengths: Option<(LengthUnit, bool)>,
}

#[wasm_bindgen]
impl Simulator {
    /// A simulator without a document: the first call is `set`.
    #[wasm_bindgen(constructor)]
    pub fn new() -> Self {
        Self::default()
    }

    /// Takes the page's state and returns the summary of its document.
    ///
    /// # Errors
    /// Every problem of the state; the document set before stays.
    pub fn set(&mut self, state: JsValue) -> Result<JsValue, JsValue> {
        let state = read(&state)?;
        let document = open(&state).map_err(thrown)?;
        let summary = document.summary();
        self.document = Some(document);
        self.lengths = Some((state.document.unit(), state.document.chooses_unit()));
        Ok(summary)
    }

    /// The unit of lengths: `m`, `cm`, `mm`, `in`, or `none`, also before the first `set`.
    pub fn lengths(&self) -> JsValue {
        let (unit, _) = self.lengths.unwrap_or((LengthUnit::None, false));
        to_js(&unit)
    }

    /// Whether a document of its kind may have a `unit`.
    #[wasm_bindgen(js_name = choosesLengths)]
    pub fn chooses_lengths(&self) -> bool {
        self.lengths.is_some_and(|(_, chooses)| chooses)
    }

    /// The names of the labels of the display lists, in order.
    ///
    /// # Errors
    /// Before the first `set`.
    #[wasm_bindgen(js_name = labelNames)]
    pub fn label_names(&self) -> Result<Vec<String>, JsValue> {
        Ok(self.document()?.rigid().names.to_vec())
    }

    /// The display list of everything rigid, grouped by body.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn scene(&self) -> Result<Vec<f32>, JsValue> {
        Ok(self.document()?.rigid().list.to_vec())
    }

    /// The frame, handles, read-outs and plotted values at an input, from one pose: the lengths of
    /// these four lists, then the lists. The frame has the bodies' poses `n, x, y, θ, …` and the
    /// display list of everything that changes its shape; the handles of the summary have x and y
    /// each; the read-outs are those of `readoutNames`; each plotted quantity, in the order of the
    /// chart's series, has its value and first two derivatives, or, in a plot of one quantity
    /// against another, abscissa and ordinate. Derivatives are those of the axes, with respect to
    /// the input or to time; where they are unbounded the last two lists are empty, and `why` gives
    /// the reason. A document that never moves has only frame and handles; its input is the share
    /// by which an open chain has fallen open.
    ///
    /// # Errors
    /// Why there is no pose.
    pub fn at(&self, input: f64) -> Result<Vec<f64>, JsValue> {
        let document = self.document()?;
        let Some(moves) = document.moves() else {
            return Ok(document.still(input).flat());
        };
        Ok(moves.at(input).map_err(one)?.flat())
    }

    /// The last of the lists of `at` alone, for the cursor of the plots.
    ///
    /// # Errors
    /// The reason why there is no pose, or why derivatives are unbounded.
    pub fn plotted(&self, input: f64) -> Result<Vec<f64>, JsValue> {
        self.moves()?.plotted_at(input).map_err(one)
    }

    /// The problems at an input: the reason why there is no pose, or why derivatives are unbounded.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn why(&self, input: f64) -> Result<JsValue, JsValue> {
        let moves = self.document()?.moves();
        Ok(thrown(moves.and_then(|moves| moves.why(input))))
    }

    /// The names of the read-outs: the input, the transmission angles of the RRR dyads, then every
    /// quantity with its first (′) and second (″) derivative; none if nothing moves.
    ///
    /// # Errors
    /// Before the first `set`.
    #[wasm_bindgen(js_name = readoutNames)]
    pub fn readout_names(&self) -> Result<Vec<String>, JsValue> {
        let moves = self.document()?.moves();
        Ok(moves.map_or_else(Vec::new, |moves| moves.readout_names()))
    }

    /// The change when a handle is dragged to a place at an input: `{input}`, or `{document}` with
    /// the changed fields. A traced point keeps to its link. Whether the fields make a mechanism is
    /// checked by `set`.
    ///
    /// # Errors
    /// An unknown point, a place that is not finite; no pose to drag in.
    pub fn drag(&self, point: &str, input: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.drag(point, input, place(x, y)?);
        Ok(change.map_err(one)?.into_js())
    }

    /// The change when a handle is pressed without a drag: `{document}` with the changed fields.
    ///
    /// # Errors
    /// A handle without an action.
    pub fn press(&self, handle: &str) -> Result<JsValue, JsValue> {
        let change = self.edited()?.press(handle);
        Ok(change.map_err(one)?.into_js())
    }

    /// The open document, drawn at an input, after one edit (the type `Edit`): `{kind, document,
    /// point, link}` with the added parts. It is a linkage if it moves, otherwise a drawing.
    ///
    /// # Errors
    /// A document that cannot be drawn on; the reason why the edit is impossible.
    pub fn edit(&self, edit: JsValue, input: f64) -> Result<JsValue, JsValue> {
        let edit: Edit = read_value(&edit)?;
        draft::edit(self.document()?, &edit, input).map_err(thrown)
    }

    /// Links and points of the open document, drawn at an input, as a linkage of their own, for the
    /// edit `paste`.
    ///
    /// # Errors
    /// A document that cannot be drawn on.
    pub fn part(
        &self,
        points: Vec<String>,
        links: Vec<String>,
        input: f64,
    ) -> Result<JsValue, JsValue> {
        let part = draft::part(self.document()?, &points, &links, input).map_err(one)?;
        Ok(to_js(&part))
    }

    /// The link drawn nearest to a place at an input, `{link, off}` with its distance; `null` if
    /// there is none.
    ///
    /// # Errors
    /// A place that is not finite; before the first `set`.
    #[wasm_bindgen(js_name = linkAt)]
    pub fn link_at(&self, input: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let place = place(x, y)?;
        Ok(to_js(&self.document()?.link_at(input, place)))
    }

    /// The open document, at an input, as a document of another kind: `{kind, document}`.
    ///
    /// # Errors
    /// A kind that cannot be made from it.
    #[wasm_bindgen(js_name = asKind)]
    pub fn as_kind(&self, kind: &str, input: f64) -> Result<JsValue, JsValue> {
        let document = as_kind(kind, self.linkage()?, input).map_err(one)?;
        Ok(to_js(&document))
    }

    /// The change when the point at a place is traced at an input: `{document}` with one more
    /// traced point, on the link drawn nearest.
    ///
    /// # Errors
    /// The reason why there is no pose; no link.
    pub fn trace(&self, input: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.trace(input, place(x, y)?);
        Ok(change.map_err(one)?.into_js())
    }

    /// The change when a dimension of the summary, by its field, is set to a value at an input:
    /// `{document, input}`, the latter if it had to change. The assembly is kept by following it.
    ///
    /// # Errors
    /// The reason why it cannot be set, with the last possible value.
    #[wasm_bindgen(js_name = setDimension)]
    pub fn set_dimension(&self, field: &str, value: f64, input: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.set(field, value, input);
        Ok(change.map_err(thrown)?.into_js())
    }

    /// The change when another of the possible drivers is chosen, in the pose at an input:
    /// `{document, input}`.
    ///
    /// # Errors
    /// The reason why it cannot be driven.
    pub fn drive(&self, link: &str, input: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.drive(link, input);
        Ok(change.map_err(thrown)?.into_js())
    }

    /// All assemblies at an input: `{all: [{number, angle, bodies}], shown, complex, whole}`.
    ///
    /// # Errors
    /// A document without assemblies.
    pub fn assemblies(&self, input: f64) -> Result<JsValue, JsValue> {
        let here = self.edited()?.assemblies(input);
        Ok(to_js(&here.ok_or_else(|| one(unknown("assembly")))?))
    }

    /// The change when an assembly is chosen by its number at an input: `{document}` with the
    /// changed fields, or nothing.
    ///
    /// # Errors
    /// No such assembly.
    pub fn assemble(&self, number: usize, input: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.assemble(number, input);
        Ok(change.map_err(thrown)?.into_js())
    }

    /// The input after a step `delta`, and −1 if it turned back at the end of its range, otherwise
    /// 1.
    ///
    /// # Errors
    /// Before the first `set`; a document that does not move.
    pub fn advance(&self, input: f64, delta: f64) -> Result<Vec<f64>, JsValue> {
        let (input, sense) = self.moves()?.advance(input, delta);
        Ok(vec![input, sense])
    }

    /// Draws the plots by plotters on a canvas whose transform maps pixels of the reader to its
    /// backing store; `request` is `{width, height, palette, around}`. Returns the layout of their
    /// text.
    ///
    /// # Errors
    /// A request of the wrong form; before the first `set`.
    pub fn chart(
        &self,
        context: &CanvasRenderingContext2d,
        request: JsValue,
    ) -> Result<JsValue, JsValue> {
        self.charted(context, request, None)
    }

    /// Draws the plots with the curves of another simulator, thin and dashed, for each quantity
    /// that both plot.
    ///
    /// # Errors
    /// Those of `chart`; another document that does not move.
    #[wasm_bindgen(js_name = chartCompared)]
    pub fn chart_compared(
        &self,
        context: &CanvasRenderingContext2d,
        request: JsValue,
        with: &Self,
    ) -> Result<JsValue, JsValue> {
        self.charted(context, request, Some(with.moves()?))
    }

    fn charted(
        &self,
        context: &CanvasRenderingContext2d,
        request: JsValue,
        with: Option<&dyn Moves>,
    ) -> Result<JsValue, JsValue> {
        let moves = self.moves()?;
        let request = ChartRequest::read(request).map_err(|problem| thrown([problem]))?;
        let size = (request.width, request.height);
        let canvas = Canvas::new(context, size, request.ratio, request.whole);
        let (area, palette) = (canvas.into_drawing_area(), request.palette());
        if let Some(mut plot) = moves.against(request.around) {
            if let Some(other) = with.and_then(|with| with.against(request.around)) {
                plot.to_mut().compare(&other);
            }
            let field = plot.draw(&area, &palette, request.scale);
            let field = field.map_err(|error| one(bad("chart", &error.to_string())))?;
            let layout = ChartLayout::of_one(&plot, field, moves.numbers());
            return Ok(to_js(&layout));
        }
        let mut chart = moves.chart(request.around);
        if let Some(with) = with {
            chart.to_mut().compare(&with.chart(request.around));
        }
        let panels = chart.draw(&area, &palette, request.scale, request.only.order());
        let panels = panels.map_err(|error| one(bad("chart", &error.to_string())))?;
        Ok(to_js(&ChartLayout::new(&chart, panels, moves.numbers())))
    }

    /// The motion as a table `{dimensions, columns, rows: [{input, values, reason}], compared}`,
    /// with `steps` rows per turn of the crank, and rows where it ends or turns back; a missing
    /// value is `null`, with the reason.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn sweep(&self, steps: u32) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.moves()?.table(steps)))
    }

    /// The same table, with that of another linkage at the same inputs as `compared`.
    ///
    /// # Errors
    /// One of them is not a moving linkage.
    #[wasm_bindgen(js_name = sweepCompared)]
    pub fn sweep_compared(&self, steps: u32, with: &Self) -> Result<JsValue, JsValue> {
        let table = SweepTable::beside(self.linkage()?, steps, with.linkage()?);
        Ok(to_js(&table))
    }

    /// Left side, right side and residual of every constraint equation of the summary at a crank
    /// angle; with order 1 or 2 their derivatives with respect to the crank angle.
    ///
    /// # Errors
    /// The reason why there are none: no pose, or derivatives unbounded.
    pub fn equations(&self, input: f64, order: usize) -> Result<Vec<f64>, JsValue> {
        self.linkage()?.equations(input, order).map_err(one)
    }

    /// The relations of the paper that the document comes from, in numbers at an input:
    /// `[{item, name, angle, count, value, printed}]`, in the order of the paper.
    ///
    /// # Errors
    /// The reason why there are none: no pose, or derivatives unbounded.
    pub fn relations(&self, input: f64) -> Result<JsValue, JsValue> {
        let relations = self.document()?.relations(input).map_err(one)?;
        let here: Vec<RelationHere> = relations.into_iter().map(Into::into).collect();
        Ok(to_js(&here))
    }

    /// Values of the drawn circles of curvature: `{circles: [{point, radius, centre, reason}],
    /// inflection: {link, diameter, reason}}`, with a problem where there is no circle.
    ///
    /// # Errors
    /// The reason why there is none: no linkage, no pose, or derivatives unbounded.
    pub fn curvature(&self, input: f64) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.curvature(input).map_err(one)?;
        Ok(to_js(&here))
    }

    /// The polygons of velocities and accelerations at an input, after `shown` steps of their
    /// construction: `{steps, pictures}`.
    ///
    /// # Errors
    /// The reason why there are none: no pose, or derivatives unbounded.
    pub fn polygons(&self, input: f64, shown: usize) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.polygons(input, shown);
        Ok(to_js(&here.map_err(one)?))
    }

    fn document(&self) -> Result<&dyn Capabilities, JsValue> {
        let document = self.document.as_deref();
        document.ok_or_else(|| one(bad("", "no state has been set")))
    }

    fn moves(&self) -> Result<&dyn Moves, JsValue> {
        let moves = self.document()?.moves();
        moves.ok_or_else(|| one(bad("", "nothing moves")))
    }

    fn linkage(&self) -> Result<&Moving, JsValue> {
        let linkage = self.document()?.linkage();
        linkage.ok_or_else(|| one(bad("", "no linkage moves")))
    }

    fn edited(&self) -> Result<&dyn Edited, JsValue> {
        let edited = self.document()?.edited();
        edited.ok_or_else(|| one(bad("", "nothing can be dragged")))
    }
}
