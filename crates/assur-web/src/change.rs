//! What a hand on the drawing changes, under the names of the page.

use serde::Serialize;
use wasm_bindgen::prelude::JsValue;

use crate::convert::to_js;

/// What becomes other: the document, the input, both or nothing. Whether that makes a
/// mechanism is found out when the state is set.
#[derive(Default, Serialize)]
pub(crate) struct Change {
    /// The fields of the document that become others; undefined where none do.
    #[serde(
        with = "serde_wasm_bindgen::preserve",
        skip_serializing_if = "JsValue::is_undefined"
    )]
    document: JsValue,
    /// Where the input goes, radians or in the unit of the lengths.
    #[serde(skip_serializing_if = "Option::is_none")]
    input: Option<f64>,
}

impl Change {
    /// The input moves.
    pub(crate) fn input(input: f64) -> Self {
        Self::default().and_input(Some(input))
    }

    /// Fields of the document become others.
    pub(crate) fn document(fields: &impl Serialize) -> Self {
        let document = to_js(fields);
        Self {
            document,
            input: None,
        }
    }

    /// The same change, and the input goes elsewhere where one is given.
    pub(crate) fn and_input(self, input: Option<f64>) -> Self {
        Self { input, ..self }
    }

    pub(crate) fn into_js(self) -> JsValue {
        to_js(&self)
    }
}
