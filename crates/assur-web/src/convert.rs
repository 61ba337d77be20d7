//! Values of ours as JavaScript's.

use assur_file::{Problem, State};
use serde::Serialize;
use serde_json::Value;
use wasm_bindgen::JsValue;

/// Any value of ours as a plain JavaScript object.
pub(crate) fn to_js(value: &impl Serialize) -> JsValue {
    let plain = serde_wasm_bindgen::Serializer::json_compatible();
    // Only maps with keys that are not text fail, and nothing here holds one.
    value.serialize(&plain).unwrap_or(JsValue::NULL)
}

/// A state of the page. All that is read goes by way of JSON's values, so that what reads it
/// is there once.
///
/// # Errors
/// The part that has not the form.
pub(crate) fn read(state: JsValue) -> Result<State, JsValue> {
    let value: Result<Value, _> = serde_wasm_bindgen::from_value(state);
    let value = value.map_err(|error| Problem::BadState {
        path: ".".to_owned(),
        detail: error.to_string(),
    });
    let state = value.and_then(|value| State::read(&value));
    state.map_err(|problem| thrown([problem]))
}

/// Problems as what is thrown: an array of `{code, …}`.
pub(crate) fn thrown(problems: impl IntoIterator<Item = impl Into<Problem>>) -> JsValue {
    let problems: Vec<Problem> = problems.into_iter().map(Into::into).collect();
    to_js(&problems)
}
