//! Starting documents, names of roles, and positions of a synthesis.

use assur_draw::ROLES;
use assur_file::{Document, DraftDocument, Preset, Shelf, View};
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::capabilities::unknown;
use crate::convert::{read, thrown, to_js};
use crate::kinds::scheme_task;

/// The practice task with this number: `{kind, document}`.
#[wasm_bindgen(unchecked_return_type = "DocumentOf<\"scheme\">")]
pub fn task(number: u32) -> JsValue {
    to_js(&Document::Scheme(scheme_task(number)))
}

/// An empty sheet to draw on: `{kind, document}`.
#[wasm_bindgen(unchecked_return_type = "DocumentOf<\"draft\">")]
pub fn blank() -> JsValue {
    to_js(&Document::Draft(DraftDocument::default()))
}

/// The default view, for a state without a view.
#[wasm_bindgen(js_name = defaultView, unchecked_return_type = "View")]
pub fn default_view() -> JsValue {
    to_js(&View::default())
}

/// The mixers of the catalogue, which come first in it: `{id, kind, document}` for each. A first view needs no others.
#[wasm_bindgen(unchecked_return_type = "Preset[]")]
pub fn mixers() -> JsValue {
    to_js(&assur_file::mixers())
}

/// The catalogue: `{id, kind, document}` for each mechanism.
///
/// # Errors
/// The problems of a mechanism; a test ensures that there are none.
#[wasm_bindgen(unchecked_return_type = "Preset[]")]
pub fn catalogue() -> Result<JsValue, JsValue> {
    let all: Result<Vec<Preset>, _> = assur_file::presets().collect();
    Ok(to_js(&all.map_err(thrown)?))
}

/// Places of the mechanisms in the gallery: `{id, group, class}` for each.
///
/// # Errors
/// The problems of a mechanism; a test ensures that there are none.
#[wasm_bindgen(unchecked_return_type = "Shelf[]")]
pub fn shelves() -> Result<JsValue, JsValue> {
    let all: Result<Vec<Shelf>, _> = assur_file::shelves().collect();
    Ok(to_js(&all.map_err(thrown)?))
}

/// Names of the colour roles in display lists and palettes, in order.
#[wasm_bindgen(js_name = roleNames)]
pub fn role_names() -> Vec<String> {
    ROLES.map(str::to_owned).to_vec()
}

/// Positions on the wanted function of a state's synthesis: with Chebyshev spacing or, if `even`, at equal steps.
///
/// # Errors
/// The problems of the function, or a state without one.
#[wasm_bindgen(js_name = functionPositions, unchecked_return_type = "PositionDocument[]")]
pub fn function_positions(
    #[wasm_bindgen(unchecked_param_type = "State")] state: &JsValue,
    count: usize,
    even: bool,
) -> Result<JsValue, JsValue> {
    let function = match read(state)?.document {
        Document::Synthesis(document) => document.function,
        _ => None,
    };
    let function = function.ok_or_else(|| thrown([unknown("function")]))?;
    let positions = function.positions(count, even).map_err(thrown)?;
    Ok(to_js(&positions))
}
