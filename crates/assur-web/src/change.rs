//! Changes made by hand in the drawing, in the form that the page expects.

use assur::motion::Motion;
use serde::Serialize;
use wasm_bindgen::prelude::JsValue;

use crate::convert::to_js;

/// A change of the document, the input, both or neither. Whether the result is a mechanism is
/// checked when the state is set.
#[derive(Default, Serialize)]
pub(crate) struct Change {
    /// Changed fields of the document; undefined if there are none.
    #[serde(
        with = "serde_wasm_bindgen::preserve",
        skip_serializing_if = "JsValue::is_undefined"
    )]
    document: JsValue,
    /// New input: an angle in radians, or a displacement in the unit of the lengths.
    #[serde(skip_serializing_if = "Option::is_none")]
    input: Option<f64>,
    /// Motion of the changed document, if the change has made it.
    #[serde(skip)]
    motion: Option<Motion>,
}

impl Change {
    /// A change of the input.
    pub(crate) fn input(input: f64) -> Self {
        Self::default().and_input(Some(input))
    }

    /// A change of fields of the document.
    pub(crate) fn document(fields: &impl Serialize) -> Self {
        let document = to_js(fields);
        Self {
            document,
            ..Self::default()
        }
    }

    /// The same change, with a new input if one is given.
    pub(crate) fn and_input(self, input: Option<f64>) -> Self {
        Self { input, ..self }
    }

    /// The same change, with the motion of the changed document.
    pub(crate) fn and_motion(self, motion: Motion) -> Self {
        let motion = Some(motion);
        Self { motion, ..self }
    }

    /// The change for the page, and the motion for the state that will follow.
    pub(crate) fn into_parts(self) -> (JsValue, Option<Motion>) {
        (to_js(&self), self.motion)
    }
}
