//! The one object the page talks to.

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

/// A document and all that is drawn of it. Inputs are radians, or of a driven slide in the
/// unit of the lengths. What fails throws an array of problems, `{code, …}`, and changes
/// nothing.
#[wasm_bindgen]
#[derive(Default)]
pub struct Simulator {
    document: Option<Box<dyn Capabilities>>,
    /// What its lengths are in, and whether it may say so itself.
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

    /// What lengths are in: `m`, `cm`, `mm`, `in`, or `none`, also before the first `set`.
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

    /// Everything at an input, from one pose: how many numbers each of four lists has, then
    /// the lists. They are: the frame, which is the bodies' poses `n, x, y, θ, …` with the
    /// display list of what changes its shape; where the handles of the summary are, x and
    /// y of each; the values of `readoutNames`; of each plotted quantity, in the order of
    /// the chart's series, the value and the first two derivatives, or abscissa and ordinate
    /// where one thing is plotted against another. Derivatives are those
    /// of the axes, by the input or by time; where they are unbounded the last two lists
    /// are empty, and `why` says it. What never moves has the frame and the handles alone;
    /// its input is by which share of its way it has fallen open, where it does.
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

    /// The last of the lists of `at` alone: for the cursor of the plots.
    ///
    /// # Errors
    /// Why there is no pose, or none of its derivatives.
    pub fn plotted(&self, input: f64) -> Result<Vec<f64>, JsValue> {
        self.moves()?.plotted_at(input).map_err(one)
    }

    /// The problems that a place of the motion has: why there is no pose, or none of its
    /// derivatives.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn why(&self, input: f64) -> Result<JsValue, JsValue> {
        let moves = self.document()?.moves();
        Ok(thrown(moves.and_then(|moves| moves.why(input))))
    }

    /// The names of the read-outs: the input, the transmission angles of the RRR dyads,
    /// then every quantity with its first (′) and second (″) derivative; none where nothing
    /// moves.
    ///
    /// # Errors
    /// Before the first `set`.
    #[wasm_bindgen(js_name = readoutNames)]
    pub fn readout_names(&self) -> Result<Vec<String>, JsValue> {
        let moves = self.document()?.moves();
        Ok(moves.map_or_else(Vec::new, |moves| moves.readout_names()))
    }

    /// What dragging a point, one of the handles, to a place changes with the input where
    /// it is: `{input}`, or `{document}` with the fields that become others. A traced point
    /// keeps to its link. Whether the fields make a mechanism is found out by `set`.
    ///
    /// # Errors
    /// An unknown point, a place that is not finite; no pose to drag in.
    pub fn drag(&self, point: &str, input: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.drag(point, input, place(x, y)?);
        Ok(change.map_err(one)?.into_js())
    }

    /// What pressing one of the handles without dragging it changes: `{document}` with the
    /// fields that become others.
    ///
    /// # Errors
    /// A handle of which nothing comes.
    pub fn press(&self, handle: &str) -> Result<JsValue, JsValue> {
        let change = self.edited()?.press(handle);
        Ok(change.map_err(one)?.into_js())
    }

    /// What is open, drawn at an input, after one edit (the type `Edit`): `{kind, document, point,
    /// link}` with what it has made. What moves then is a linkage, what does not a drawing.
    ///
    /// # Errors
    /// What cannot be drawn on; why it cannot be edited so.
    pub fn edit(&self, edit: JsValue, input: f64) -> Result<JsValue, JsValue> {
        let edit: Edit = read_value(&edit)?;
        draft::edit(self.document()?, &edit, input).map_err(thrown)
    }

    /// Links and points of what is open, drawn at an input, as a linkage of their own: to be
    /// put elsewhere by the edit `paste`.
    ///
    /// # Errors
    /// What cannot be drawn on.
    pub fn part(
        &self,
        points: Vec<String>,
        links: Vec<String>,
        input: f64,
    ) -> Result<JsValue, JsValue> {
        let part = draft::part(self.document()?, &points, &links, input).map_err(one)?;
        Ok(to_js(&part))
    }

    /// The link drawn nearest to a place at an input, `{link, off}` with its distance; `null`
    /// where there is none.
    ///
    /// # Errors
    /// A place that is not finite; before the first `set`.
    #[wasm_bindgen(js_name = linkAt)]
    pub fn link_at(&self, input: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let place = place(x, y)?;
        Ok(to_js(&self.document()?.link_at(input, place)))
    }

    /// What is open, at an input, as a document of another kind: `{kind, document}`.
    ///
    /// # Errors
    /// No document of that kind is made of it.
    #[wasm_bindgen(js_name = asKind)]
    pub fn as_kind(&self, kind: &str, input: f64) -> Result<JsValue, JsValue> {
        let document = as_kind(kind, self.linkage()?, input).map_err(one)?;
        Ok(to_js(&document))
    }

    /// What tracing the point at a place changes with the input where it is: `{document}`
    /// with one more traced point, on the link drawn nearest.
    ///
    /// # Errors
    /// Why there is no pose to put a point on; no link.
    pub fn trace(&self, input: f64, x: f64, y: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.trace(input, place(x, y)?);
        Ok(change.map_err(one)?.into_js())
    }

    /// What setting a dimension of the summary, by its field, to a value changes with the
    /// input where it is: `{document, input}`, the latter where it gave way. The assembly
    /// is kept by following it.
    ///
    /// # Errors
    /// Why it cannot be set, with the last value that works.
    #[wasm_bindgen(js_name = setDimension)]
    pub fn set_dimension(&self, field: &str, value: f64, input: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.set(field, value, input);
        Ok(change.map_err(thrown)?.into_js())
    }

    /// What driving another of the links that can be driven changes with the input where
    /// it is: `{document, input}`. It is driven from the pose at hand.
    ///
    /// # Errors
    /// Why it cannot be driven so.
    pub fn drive(&self, link: &str, input: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.drive(link, input);
        Ok(change.map_err(thrown)?.into_js())
    }

    /// All assemblies at an input: `{all: [{number, angle, bodies}], shown, complex, whole}`.
    ///
    /// # Errors
    /// What has none.
    pub fn assemblies(&self, input: f64) -> Result<JsValue, JsValue> {
        let here = self.edited()?.assemblies(input);
        Ok(to_js(&here.ok_or_else(|| one(unknown("assembly")))?))
    }

    /// What choosing an assembly, by its number at an input, changes: `{document}` with the
    /// fields that become others, or nothing.
    ///
    /// # Errors
    /// No such assembly.
    pub fn assemble(&self, number: usize, input: f64) -> Result<JsValue, JsValue> {
        let change = self.edited()?.assemble(number, input);
        Ok(change.map_err(thrown)?.into_js())
    }

    /// The input moved by `delta`, and −1 where it turned back at the end of its way, else
    /// 1.
    ///
    /// # Errors
    /// Before the first `set`; where nothing moves.
    pub fn advance(&self, input: f64, delta: f64) -> Result<Vec<f64>, JsValue> {
        let (input, sense) = self.moves()?.advance(input, delta);
        Ok(vec![input, sense])
    }

    /// Draws the plots with plotters on a canvas whose transform maps pixels of
    /// the reader to its backing store; `request` is `{width, height, palette, around}`.
    /// Returns where the page writes their text.
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

    /// The same with the curves of what another simulator shows, thin and dashed, in the same plots:
    /// of each quantity that both plot.
    ///
    /// # Errors
    /// As of `chart`; where nothing moves in the other one.
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

    /// The motion as a table `{dimensions, columns, rows: [{input, values, reason}], compared}`, with
    /// `steps` rows to a turn of the crank, and rows where it ends or turns back; `null` where
    /// there is no value, with the reason.
    ///
    /// # Errors
    /// Before the first `set`.
    pub fn sweep(&self, steps: u32) -> Result<JsValue, JsValue> {
        Ok(to_js(&self.moves()?.table(steps)))
    }

    /// The same with the table of another linkage at the same inputs as `compared`.
    ///
    /// # Errors
    /// Where one of them is no linkage that moves.
    #[wasm_bindgen(js_name = sweepCompared)]
    pub fn sweep_compared(&self, steps: u32, with: &Self) -> Result<JsValue, JsValue> {
        let table = SweepTable::beside(self.linkage()?, steps, with.linkage()?);
        Ok(to_js(&table))
    }

    /// Of every constraint equation of the summary at a crank angle its left side,
    /// its right side and their difference; with order 1 or 2 of its
    /// derivative by the crank angle.
    ///
    /// # Errors
    /// Why there are none: no pose, or derivatives unbounded.
    pub fn equations(&self, input: f64, order: usize) -> Result<Vec<f64>, JsValue> {
        self.linkage()?.equations(input, order).map_err(one)
    }

    /// The relations of the paper that the document comes from, in numbers at an input:
    /// `[{item, name, angle, count, value, printed}]`, in the order of the paper.
    ///
    /// # Errors
    /// Why there are none: no pose, or derivatives unbounded.
    pub fn relations(&self, input: f64) -> Result<JsValue, JsValue> {
        let relations = self.document()?.relations(input).map_err(one)?;
        let here: Vec<RelationHere> = relations.into_iter().map(Into::into).collect();
        Ok(to_js(&here))
    }

    /// What is drawn of curvature, in numbers: `{circles: [{point, radius, centre, reason}],
    /// inflection: {link, diameter, reason}}`, with a problem where there is no circle.
    ///
    /// # Errors
    /// Why there is none: no linkage, no pose, or derivatives unbounded.
    pub fn curvature(&self, input: f64) -> Result<JsValue, JsValue> {
        let here = self.linkage()?.curvature(input).map_err(one)?;
        Ok(to_js(&here))
    }

    /// The polygons of velocities and accelerations at an input, drawn as far as so many steps:
    /// `{steps, pictures}`.
    ///
    /// # Errors
    /// Why there are none: no pose, or derivatives unbounded.
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
