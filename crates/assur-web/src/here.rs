//! Values that the page shows at an input.

use assur::Point;
use js_sys::{Float32Array, Float64Array};
use serde::{Serialize, Serializer};
use serde_wasm_bindgen::preserve;

/// The mechanism at an input.
#[derive(Default, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct Here {
    /// Number of bodies; x, y and angle of each; then a display list of all shapes that are not rigid.
    #[serde(serialize_with = "single_precision")]
    #[cfg_attr(test, ts(type = "Float32Array"))]
    pub(crate) frame: Vec<f32>,
    /// x and y of each handle of the summary.
    #[serde(serialize_with = "double_precision")]
    #[cfg_attr(test, ts(type = "Float64Array"))]
    pub(crate) handles: Vec<f64>,
    /// Values of the read-outs that `readouts` names, in its order; empty if derivatives are unbounded.
    #[serde(serialize_with = "double_precision")]
    #[cfg_attr(test, ts(type = "Float64Array"))]
    pub(crate) readouts: Vec<f64>,
    /// For each series of the plots, its value and first two derivatives, or abscissa and ordinate if one quantity is
    /// plotted against another; empty if derivatives are unbounded.
    #[serde(serialize_with = "double_precision")]
    #[cfg_attr(test, ts(type = "Float64Array"))]
    pub(crate) plotted: Vec<f64>,
}

/// Subject of a read-out in [`Here`]: a quantity, such as `rocker.angle`, or one of its derivatives.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct ReadoutId {
    pub(crate) quantity: String,
    /// Order of the derivative: 0, 1 or 2.
    pub(crate) order: u8,
}

impl ReadoutId {
    pub(crate) const fn value(quantity: String) -> Self {
        Self { quantity, order: 0 }
    }

    /// A quantity with its first and second derivative.
    pub(crate) fn rates(quantity: &str) -> [Self; 3] {
        [0, 1, 2].map(|order| Self {
            quantity: quantity.to_owned(),
            order,
        })
    }
}

impl Here {
    /// Makes the values for a document that never moves: an animation frame and the positions of the handles.
    pub(crate) fn still(frame: Vec<f32>, handles: impl Iterator<Item = Point>) -> Self {
        Self {
            frame,
            handles: handles.flat_map(|at| [at.x, at.y]).collect(),
            ..Self::default()
        }
    }
}

fn single_precision<S: Serializer>(numbers: &[f32], to: S) -> Result<S::Ok, S::Error> {
    preserve::serialize(&Float32Array::from(numbers), to)
}

fn double_precision<S: Serializer>(numbers: &[f64], to: S) -> Result<S::Ok, S::Error> {
    preserve::serialize(&Float64Array::from(numbers), to)
}
