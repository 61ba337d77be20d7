//! Values that the page shows at an input.

use assur::Point;
use js_sys::{Float32Array, Float64Array};
use serde::Serialize;
use wasm_bindgen::JsValue;

use crate::convert::to_js;

/// All values at an input, as [`crate::Simulator::at`] returns them.
#[derive(Default)]
pub(crate) struct Here {
    pub(crate) frame: Vec<f32>,
    pub(crate) handles: Vec<f64>,
    pub(crate) readouts: Vec<f64>,
    pub(crate) plotted: Vec<f64>,
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

    /// The same values as typed arrays.
    pub(crate) fn into_js(self) -> JsValue {
        to_js(&HereArrays {
            frame: self.frame[..].into(),
            handles: self.handles[..].into(),
            readouts: self.readouts[..].into(),
            plotted: self.plotted[..].into(),
        })
    }
}

/// The mechanism at an input.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS), ts(rename = "Here"))]
pub(crate) struct HereArrays {
    /// Number of bodies; x, y and angle of each; then a display list of all shapes that are not rigid.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[cfg_attr(test, ts(type = "Float32Array"))]
    frame: Float32Array,
    /// x and y of each handle of the summary.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[cfg_attr(test, ts(type = "Float64Array"))]
    handles: Float64Array,
    /// Values of `readoutNames`; empty if derivatives are unbounded.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[cfg_attr(test, ts(type = "Float64Array"))]
    readouts: Float64Array,
    /// For each series of the plots, its value and first two derivatives, or abscissa and ordinate if one quantity is
    /// plotted against another; empty if derivatives are unbounded.
    #[serde(with = "serde_wasm_bindgen::preserve")]
    #[cfg_attr(test, ts(type = "Float64Array"))]
    plotted: Float64Array,
}
