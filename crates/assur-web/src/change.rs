//! What a hand on the drawing changes, under the names of the page.

use serde::Serialize;
use wasm_bindgen::prelude::JsValue;

use crate::convert::to_js;

/// Where the input goes, `{input}`, or which fields of the document become others,
/// `{document}`, or both. Whether those make a mechanism is found out when the state is set.
pub(crate) struct Change(JsValue);

impl Change {
    /// The input moves, radians or in the unit of the lengths.
    pub(crate) fn input(input: f64) -> Self {
        #[derive(Serialize)]
        struct Input {
            input: f64,
        }
        Self(to_js(&Input { input }))
    }

    /// Fields of the document become others.
    pub(crate) fn document(document: &impl Serialize) -> Self {
        Self::of(document, None)
    }

    /// Fields of the document become others, and the input goes elsewhere where one is
    /// given.
    pub(crate) fn of(document: &impl Serialize, input: Option<f64>) -> Self {
        #[derive(Serialize)]
        struct Both<'a, D> {
            document: &'a D,
            #[serde(skip_serializing_if = "Option::is_none")]
            input: Option<f64>,
        }
        Self(to_js(&Both { document, input }))
    }

    pub(crate) fn into_js(self) -> JsValue {
        self.0
    }
}
