//! Values of ours as JavaScript's.

use assur_file::Problem;
use serde::Serialize;
use wasm_bindgen::JsValue;

/// Any value of ours as a plain JavaScript object.
pub(crate) fn to_js(value: &impl Serialize) -> JsValue {
    let plain = serde_wasm_bindgen::Serializer::json_compatible();
    // Only maps with keys that are not text fail, and nothing here holds one.
    value.serialize(&plain).unwrap_or(JsValue::NULL)
}

/// Problems as what is thrown: an array of `{code, …}`.
pub(crate) fn thrown(problems: impl IntoIterator<Item = impl Into<Problem>>) -> JsValue {
    let problems: Vec<Problem> = problems.into_iter().map(Into::into).collect();
    to_js(&problems)
}
