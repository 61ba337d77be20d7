//! What the page asks of a mechanism, whichever lesson it is of.

use assur::motion::Input;
use assur::{Cycle, Jet, Point};
use assur_draw::List;
use assur_draw::chart::{Chart, Settings};
use assur_file::{Axes, Problem, View};
use wasm_bindgen::prelude::JsValue;

use crate::convert::Change;
use crate::table::SweepTable;

/// A mechanism with all that is drawn of it. [`crate::Simulator`] says what each
/// of these is; problems are those it throws.
pub(crate) trait Shown {
    fn summary(&self) -> JsValue;
    fn labels(&self) -> Vec<String>;
    fn scene(&self) -> &List;
    fn frame(&self, phi: f64) -> Result<Vec<f32>, Problem>;
    fn readout_names(&self) -> Vec<String>;
    fn readouts(&self, phi: f64) -> Result<Vec<f64>, Problem>;
    fn plotted(&self, phi: f64) -> Result<Vec<f64>, Problem>;
    fn joints(&self, phi: f64) -> Result<Vec<f64>, Problem>;
    fn drag(&self, joint: &str, phi: f64, place: Point) -> Result<Change, Problem>;
    fn trace(&self, phi: f64, place: Point) -> Result<Change, Problem>;
    fn cycle(&self) -> &Cycle;
    fn chart(&self) -> &Chart;
    fn table(&self, steps: u32) -> SweepTable;
    /// A mixer has none: closed forms place it.
    fn equations(&self, _phi: f64, _order: usize) -> Result<Vec<f64>, Problem> {
        Ok(Vec::new())
    }
}

/// How a chart is drawn by a view.
pub(crate) fn settings(view: &View) -> Settings {
    Settings {
        input: view.input(),
        physical: view.axes == Axes::Physical,
        differenced: view.differenced,
    }
}

/// Of each jet the value and two derivatives, with the input going so.
pub(crate) fn rates(jets: &[Jet<3>], input: Input) -> Vec<f64> {
    let rates = |jet: &Jet<3>| [0, 1, 2].map(|order| input.rate(jet, order));
    jets.iter().flat_map(rates).collect()
}

/// The names of a quantity and of its derivatives.
pub(crate) fn strokes(name: &str) -> [String; 3] {
    ["", "′", "″"].map(|stroke| [name, stroke].concat())
}

/// What is none of the joints.
pub(crate) fn unknown(joint: &str) -> Problem {
    Problem::BadState {
        path: "joint".to_owned(),
        detail: joint.to_owned(),
    }
}
