//! The interface of the page to the engine.

mod analysis;
mod force_plan;
mod forces;
mod refusal;
mod under_load;

use std::cell::{Cell, RefCell};

use assur::Point;
use assur::motion::Motion;
use assur_edit::Edit;
use assur_file::{LengthUnit, Problem, State};
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};
use web_sys::CanvasRenderingContext2d;

use crate::capabilities::{Capabilities, Edited, Moves, RelationHere, unknown};
use crate::change::Change;
use crate::chart;
use crate::convert::{read, read_tagged, thrown, to_js};
use crate::equations::EquationSummary;
use crate::kinds::{as_kind, draft, open_after};
use crate::moving::Moving;
use crate::profile::ProfileSummary;
use crate::summary::{OutputSummary, TransmissionSummary};
use crate::table::SweepTable;
use crate::under_load::UnderLoad;
use refusal::place;
pub(crate) use refusal::{bad, one};

/// An open document with its drawing. Inputs are in radians, for a driven slide in the unit of the lengths, for a gear
/// train in seconds. A method that fails throws an `Error` with `problems`, an array of `{code, …}`, and changes
/// nothing.
#[wasm_bindgen]
#[derive(Default)]
pub struct Simulator {
    document: Option<Box<dyn Capabilities>>,
    /// The unit of the document's lengths, and whether its kind of document has a field for the unit.
    lengths: Option<(LengthUnit, bool)>,
    /// The motion that the last change has made. If the next state has the changed document, this motion is used.
    made: Cell<Option<Motion>>,
    /// Symbol unit of linkages, in the unit of lengths; none for a hundredth of the drawing's size.
    symbol: Option<f64>,
    /// The motion under load that the page plays.
    run: RefCell<Option<UnderLoad>>,
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
    /// Every problem of the state; the previous document then stays open.
    #[wasm_bindgen(skip_typescript)]
    pub fn set(&mut self, state: JsValue) -> Result<JsValue, JsValue> {
        let mut state: State = read(&state)?;
        state.view.symbol = self.symbol;
        let document = open_after(self.made.take(), &state).map_err(thrown)?;
        let summary = document.summary();
        self.document = Some(document);
        self.lengths = Some((state.document.unit(), state.document.chooses_unit()));
        Ok(summary)
    }

    /// Sets the symbol unit of linkages and drafts from the next `set` on, in the unit of lengths. If the value is not
    /// positive, the unit is a hundredth of the drawing's size.
    #[wasm_bindgen(js_name = setSymbol)]
    pub fn set_symbol(&mut self, unit: f64) {
        self.symbol = Some(unit).filter(|unit| unit.is_finite() && *unit > 0.0);
    }

    /// The unit of lengths: `m`, `cm`, `mm`, `in` or `none`. Before the first `set` it is `none`.
    #[wasm_bindgen(unchecked_return_type = "LengthUnit")]
    pub fn lengths(&self) -> JsValue {
        let (unit, _) = self.lengths.unwrap_or((LengthUnit::None, false));
        to_js(&unit)
    }

    /// Whether documents of the open document's kind may have a field `unit`; false before the first `set`.
    #[wasm_bindgen(js_name = choosesLengths)]
    pub fn chooses_lengths(&self) -> bool {
        self.lengths.is_some_and(|(_, chooses)| chooses)
    }

    /// Names to which the labels of the display lists refer, in order.
    ///
    /// # Errors
    /// A call before the first `set`.
    #[wasm_bindgen(js_name = labelNames)]
    pub fn label_names(&self) -> Result<Vec<String>, JsValue> {
        Ok(self.document()?.rigid().names.to_vec())
    }

    /// The display list of all shapes that move rigidly with a body, grouped by body.
    ///
    /// # Errors
    /// A call before the first `set`.
    pub fn scene(&self) -> Result<Vec<f32>, JsValue> {
        Ok(self.document()?.rigid().list.to_vec())
    }

    /// The mechanism at an input, computed from one pose: animation frame, handles, read-outs and plotted values.
    /// Derivatives are with respect to the variable of the axes: input or time. If they are unbounded, read-outs and
    /// plotted values are empty, and `why` gives the reason. They are also empty while a run of several freedoms is at the
    /// input: then the pose is that of the run. A document that never moves has only frame and handles;
    /// its input is the fraction by which the last cut of a scheme is open.
    ///
    /// # Errors
    /// The reason why there is no pose.
    #[wasm_bindgen(unchecked_return_type = "Here")]
    pub fn at(&self, input: f64) -> Result<JsValue, JsValue> {
        let document = self.document()?;
        if let Some(here) = self.of_run(|run, shown| run.here(shown, input)).flatten() {
            return Ok(to_js(&here));
        }
        Ok(to_js(&match document.moves() {
            Some(moves) => moves.at(input).map_err(one)?,
            None => document.still(input),
        }))
    }

    /// The plotted values of `at` alone, for the cursor of the plots.
    ///
    /// # Errors
    /// The reason why there is no pose, or why derivatives are unbounded.
    pub fn plotted(&self, input: f64) -> Result<Vec<f64>, JsValue> {
        self.moves()?.plotted_at(input).map_err(one)
    }

    /// The problems at an input: the reason why there is no pose, or why derivatives are unbounded. Otherwise empty.
    ///
    /// # Errors
    /// A call before the first `set`.
    #[wasm_bindgen(unchecked_return_type = "Problem[]")]
    pub fn why(&self, input: f64) -> Result<JsValue, JsValue> {
        let moves = self.document()?.moves();
        let moves =
            moves.filter(|_| self.of_run(|run, shown| run.is_shown(shown, input)) != Some(true));
        let problem = moves.and_then(|moves| moves.why(input));
        Ok(to_js(&Vec::from_iter(problem)))
    }

    /// The read-outs of `at`: the input, the transmission and pressure angles of dyads, then every quantity with its
    /// first and second derivative, then torques and energies of a gear train under load. Empty if the document does not
    /// move.
    ///
    /// # Errors
    /// A call before the first `set`.
    #[wasm_bindgen(unchecked_return_type = "ReadoutId[]")]
    pub fn readouts(&self) -> Result<JsValue, JsValue> {
        let moves = self.document()?.moves();
        Ok(to_js(
            &moves.map_or_else(Vec::new, |moves| moves.readouts()),
        ))
    }

    /// The change after a handle is dragged to a place at an input: `{input}`, or `{document}` with the changed fields.
    /// A traced point stays on its link. `set` checks whether the changed document is a mechanism.
    ///
    /// # Errors
    /// An unknown handle; a place that is not finite; no pose at this input.
    #[wasm_bindgen(unchecked_return_type = "Changed")]
    pub fn drag(&self, point: &str, input: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.drag(point, input, place(x, y)?);
        Ok(self.after(change.map_err(one)?))
    }

    /// The change after a handle is pressed without a drag: `{document}` with the changed fields.
    ///
    /// # Errors
    /// A handle without an action.
    #[wasm_bindgen(unchecked_return_type = "Changed")]
    pub fn press(&self, handle: &str) -> Result<JsValue, JsValue> {
        let change = self.edited()?.press(handle);
        Ok(self.after(change.map_err(one)?))
    }

    /// Applies an `Edit` to the open document in its pose at an input: `{kind, document, point, link, held}`, with the
    /// point and the link added last. The result is a linkage if it moves, otherwise a drawing.
    ///
    /// # Errors
    /// A document that cannot be edited as a drawing; the reason why the edit is impossible.
    #[wasm_bindgen(unchecked_return_type = "DocumentOf<\"draft\" | \"linkage\"> & Drawn")]
    pub fn edit(
        &self,
        #[wasm_bindgen(unchecked_param_type = "Edit")] edit: JsValue,
        input: f64,
    ) -> Result<JsValue, JsValue> {
        let edit: Edit = read_tagged(&edit, "edit")?;
        draft::edit(self.document()?, &edit, input).map_err(thrown)
    }

    /// Copies links and points of the open document, in its pose at an input, to a linkage for the edit `paste`.
    ///
    /// # Errors
    /// A document that cannot be edited as a drawing.
    #[wasm_bindgen(unchecked_return_type = "LinkageDocument")]
    pub fn part(
        &self,
        points: Vec<String>,
        links: Vec<String>,
        input: f64,
    ) -> Result<JsValue, JsValue> {
        let part = draft::part(self.document()?, &points, &links, input).map_err(one)?;
        Ok(to_js(&part))
    }

    /// The link drawn nearest to a place at an input: `{link, off, wheel}`, with its distance `off`
    /// and the wheel at the place. `null` if there is no link.
    ///
    /// # Errors
    /// A place that is not finite; a call before the first `set`.
    #[wasm_bindgen(js_name = linkAt, unchecked_return_type = "LinkHere | null")]
    pub fn link_at(&self, input: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let place = place(x, y)?;
        Ok(to_js(&self.document()?.link_at(input, place)))
    }

    /// Converts the open document, in its pose at an input, to a document of another kind: `{kind, document}`.
    ///
    /// # Errors
    /// A kind that cannot be made from this document.
    #[wasm_bindgen(js_name = asKind, skip_typescript)]
    pub fn as_kind(&self, kind: &str, input: f64) -> Result<JsValue, JsValue> {
        let document = as_kind(kind, self.linkage()?, input).map_err(one)?;
        Ok(to_js(&document))
    }

    /// The change that traces the point of a link at a place, in the pose at an input: `{document}` with one more
    /// traced point, on the link drawn nearest.
    ///
    /// # Errors
    /// The reason why there is no pose; no link to trace.
    #[wasm_bindgen(unchecked_return_type = "Traced")]
    pub fn trace(&self, input: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.trace(input, place(x, y)?);
        Ok(self.after(change.map_err(one)?))
    }

    /// The change after a dimension, identified by its field, is set to a value at an input: `{document, input}`, with
    /// `input` only if it had to change. The motion is followed, so the assembly stays the same.
    ///
    /// # Errors
    /// The reason why the value cannot be set, with the last possible value.
    #[wasm_bindgen(js_name = setDimension, unchecked_return_type = "Changed")]
    pub fn set_dimension(&self, field: &str, value: f64, input: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.set(field, value, input);
        Ok(self.after(change.map_err(thrown)?))
    }

    /// The change after another of the possible drivers is chosen, in the pose at an input: `{document, input}`.
    ///
    /// # Errors
    /// The reason why the link cannot be driven.
    #[wasm_bindgen(unchecked_return_type = "Changed")]
    pub fn drive(&self, link: &str, input: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.drive(link, input);
        Ok(self.after(change.map_err(thrown)?))
    }

    /// All assemblies at an input: `{all: [{number, angle, bodies}], shown, complex, whole}`.
    ///
    /// # Errors
    /// A document without assemblies.
    #[wasm_bindgen(unchecked_return_type = "AssembliesHere")]
    pub fn assemblies(&self, input: f64) -> Result<JsValue, JsValue> {
        let here = self.edited()?.assemblies(input);
        Ok(to_js(&here.ok_or_else(|| one(unknown("assembly")))?))
    }

    /// The change after an assembly is chosen by its number at an input: `{document}` with the changed fields, or `{}`.
    ///
    /// # Errors
    /// No such assembly.
    #[wasm_bindgen(unchecked_return_type = "Changed")]
    pub fn assemble(&self, number: usize, input: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.assemble(number, input);
        Ok(self.after(change.map_err(thrown)?))
    }

    /// The input after a step `delta`, and a factor: −1 after an odd number of reversals at the ends of its range,
    /// otherwise 1.
    ///
    /// # Errors
    /// A call before the first `set`; a document that does not move.
    pub fn advance(&self, input: f64, delta: f64) -> Result<Vec<f64>, JsValue> {
        let (input, sense) = self.moves()?.advance(input, delta);
        Ok(vec![input, sense])
    }

    /// Draws the plots on a canvas whose transform maps CSS pixels to its backing store. `request` is a `ChartRequest`
    /// with at least `{width, height, palette}`. Returns the layout of the plots' text.
    ///
    /// # Errors
    /// A malformed request; a call before the first `set`; a document that does not move.
    #[wasm_bindgen(unchecked_return_type = "ChartLayout")]
    pub fn chart(
        &self,
        context: &CanvasRenderingContext2d,
        #[wasm_bindgen(unchecked_param_type = "ChartRequest")] request: JsValue,
    ) -> Result<JsValue, JsValue> {
        chart::draw(self.moves()?, None, context, &request).map_err(one)
    }

    /// Draws the plots and, thin and dashed, another simulator's curves of the quantities that both plot.
    ///
    /// # Errors
    /// Those of `chart`; the other simulator's document does not move.
    #[wasm_bindgen(js_name = chartCompared, unchecked_return_type = "ChartLayout")]
    pub fn chart_compared(
        &self,
        context: &CanvasRenderingContext2d,
        #[wasm_bindgen(unchecked_param_type = "ChartRequest")] request: JsValue,
        with: &Self,
    ) -> Result<JsValue, JsValue> {
        chart::draw(self.moves()?, Some(with.moves()?), context, &request).map_err(one)
    }

    /// The motion as a table `{dimensions, columns, rows: [{input, values, reason}], compared}`. There are `steps` rows
    /// per turn of a crank, or `steps` steps over the range of any other input, and further rows where the motion turns
    /// back. A missing value is `null`; the row then has the reason.
    ///
    /// # Errors
    /// A call before the first `set`; a document that does not move.
    #[wasm_bindgen(unchecked_return_type = "SweepTable")]
    pub fn sweep(&self, steps: u32) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.moves()?.table(steps)))
    }

    /// The table of `sweep`, in which `compared` is the table of another linkage at the same inputs.
    ///
    /// # Errors
    /// Either document is not a moving linkage.
    #[wasm_bindgen(js_name = sweepCompared, unchecked_return_type = "SweepTable")]
    pub fn sweep_compared(&self, steps: u32, with: &Self) -> Result<JsValue, JsValue> {
        let table = SweepTable::beside(self.linkage()?, steps, with.linkage()?);
        Ok(to_js(&table))
    }
}

impl Simulator {
    /// What the run says of the linkage shown; None without a run or a linkage.
    fn of_run<T>(&self, asked: impl FnOnce(&mut UnderLoad, &Moving) -> T) -> Option<T> {
        let shown = self.document.as_deref()?.linkage()?;
        let mut run = self.run.borrow_mut();
        Some(asked(run.as_mut()?, shown))
    }

    /// Returns a change for the page, and keeps its motion, if it has one, until the next `set`.
    fn after(&self, change: Change) -> JsValue {
        let (change, motion) = change.into_parts();
        self.made.set(motion);
        change
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
