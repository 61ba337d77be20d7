//! The numbers of a document that a lesson may vary.

use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::convert::{read, thrown, to_js};

/// Lists the numbers in the document of a state that a lesson may vary: `{field, value, whole, followed}` for each.
///
/// # Errors
/// A malformed state; every problem that prevents the list.
#[wasm_bindgen(js_name = numbersOf, unchecked_return_type = "NumberField[]")]
pub fn numbers_of(
    #[wasm_bindgen(unchecked_param_type = "State")] state: JsValue,
) -> Result<JsValue, JsValue> {
    let numbers = read(&state)?.document.numbers();
    Ok(to_js(&numbers.map_err(thrown)?))
}
