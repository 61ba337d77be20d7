//! What the page asks of a document that is open, whichever kind it is of: capabilities, of
//! which a kind has those that it has.

use assur::Point;
use assur_draw::Figure;
use assur_file::Problem;
use wasm_bindgen::prelude::JsValue;

use crate::change::Change;
use crate::moving::Moving;

/// A document with all that is drawn of it.
pub(crate) trait Capabilities {
    /// What is said of it as a whole; it says by `moves` whether anything does.
    fn summary(&self) -> JsValue;

    /// Its drawing.
    fn figure(&self) -> &Figure;

    /// The frame of what never moves, as of [`crate::Simulator::at`]; of what moves none.
    fn still(&self) -> Vec<f32> {
        Vec::new()
    }

    /// What moves, is read, listed and plotted, where anything is.
    fn moving(&self) -> Option<&Moving> {
        None
    }

    /// What can be changed by hand, where anything can.
    fn edited(&self) -> Option<&dyn Edited> {
        None
    }
}

/// What changes when a hand is laid on the drawing; problems are those that
/// [`crate::Simulator`] throws.
pub(crate) trait Edited {
    /// A point dragged to a place, with the input where it is.
    fn drag(&self, point: &str, input: f64, to: Point) -> Result<Change, Problem>;

    /// The point at a place traced, with the input where it is.
    fn trace(&self, input: f64, at: Point) -> Result<Change, Problem>;

    /// A dimension, by its field, set to a value from the pose at an input.
    fn set(&self, field: &str, _value: f64, _input: f64) -> Result<Change, Vec<Problem>> {
        Err(vec![unknown(field)])
    }

    /// Another link driven, from the pose at an input.
    fn drive(&self, link: &str, _input: f64) -> Result<Change, Vec<Problem>> {
        Err(vec![unknown(link)])
    }

    /// An assembly chosen, by its number from 1; nothing becomes other where it is the drawn one.
    fn assemble(&self, number: usize) -> Result<Change, Vec<Problem>>;
}

/// What is none of the points that can be dragged.
pub(crate) fn unknown(point: &str) -> Problem {
    Problem::BadState {
        path: "point".to_owned(),
        detail: point.to_owned(),
    }
}
