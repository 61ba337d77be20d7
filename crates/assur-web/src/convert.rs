//! Values of ours as JavaScript's.

use assur_file::{Problem, State};
use js_sys::{Array, Object};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use wasm_bindgen::{JsCast, JsValue};

/// Any value of ours as a plain JavaScript object.
pub(crate) fn to_js(value: &impl Serialize) -> JsValue {
    let plain = serde_wasm_bindgen::Serializer::json_compatible();
    // Only maps with keys that are not text fail, and nothing here holds one.
    value.serialize(&plain).unwrap_or(JsValue::NULL)
}

/// A state of the page. All that is read goes by way of JSON's values, so that what reads it
/// is there once; they have no place for NaN and infinities, which would be taken for nothing.
///
/// # Errors
/// The fields of numbers that are none; the part that has not the form.
pub(crate) fn read(state: &JsValue) -> Result<State, JsValue> {
    let value: Result<Value, _> = serde_wasm_bindgen::from_value(state.clone());
    let value = value.map_err(|error| Problem::BadState {
        path: ".".to_owned(),
        detail: error.to_string(),
    });
    if value.as_ref().is_ok_and(holds_nothing) {
        let mut problems = Vec::new();
        for (_, part) in entries(state) {
            name_not_numbers(&part, "", &mut problems);
        }
        if !problems.is_empty() {
            return Err(thrown(problems));
        }
    }
    let state = value.and_then(|value| State::read(&value));
    state.map_err(|problem| thrown([problem]))
}

/// A value of ours of what the page gives, by way of JSON's values as well.
///
/// # Errors
/// What has not the form.
pub(crate) fn read_value<T: DeserializeOwned>(given: &JsValue) -> Result<T, JsValue> {
    let bad = |detail: String| {
        let path = ".".to_owned();
        thrown([Problem::BadState { path, detail }])
    };
    let value: Result<Value, _> = serde_wasm_bindgen::from_value(given.clone());
    let value = value.map_err(|error| bad(error.to_string()))?;
    serde_json::from_value(value).map_err(|error| bad(error.to_string()))
}

/// Whether a value has a `null` anywhere: NaN and infinities have become that.
fn holds_nothing(value: &Value) -> bool {
    match value {
        Value::Null => true,
        Value::Array(values) => values.iter().any(holds_nothing),
        Value::Object(fields) => fields.values().any(holds_nothing),
        Value::Bool(_) | Value::Number(_) | Value::String(_) => false,
    }
}

/// Names the fields that hold NaN or an infinity.
fn name_not_numbers(value: &JsValue, field: &str, problems: &mut Vec<Problem>) {
    if value.as_f64().is_some_and(|number| !number.is_finite()) {
        problems.push(Problem::NotANumber {
            field: field.to_owned().into(),
        });
    }
    let listed = Array::is_array(value);
    for (name, inner) in entries(value) {
        let field = match (listed, field) {
            (true, _) => format!("{field}[{name}]"),
            (false, "") => name,
            (false, _) => format!("{field}.{name}"),
        };
        name_not_numbers(&inner, &field, problems);
    }
}

/// What an object or a list holds, by names or numbers; nothing in other values.
fn entries(value: &JsValue) -> Vec<(String, JsValue)> {
    let Some(object) = value.dyn_ref::<Object>() else {
        return Vec::new();
    };
    let entries = Object::entries(object);
    let named = entries.iter().map(|entry| Array::from(&entry));
    named
        .filter_map(|entry| Some((entry.get(0).as_string()?, entry.get(1))))
        .collect()
}

/// Problems as what is thrown: an array of `{code, …}`.
pub(crate) fn thrown(problems: impl IntoIterator<Item = impl Into<Problem>>) -> JsValue {
    let problems: Vec<Problem> = problems.into_iter().map(Into::into).collect();
    to_js(&problems)
}
