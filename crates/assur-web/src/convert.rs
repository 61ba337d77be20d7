//! Conversion between Rust and JavaScript values.

use assur_file::{Problem, State, from_json};
use js_sys::{Error, JSON, Reflect};
use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;
use wasm_bindgen::JsValue;

/// Converts a Rust value to a plain JavaScript object.
pub(crate) fn to_js(value: &impl Serialize) -> JsValue {
    let plain = serde_wasm_bindgen::Serializer::json_compatible();
    // Serialisation fails only for maps whose keys are not text; there are none here.
    value.serialize(&plain).unwrap_or(JsValue::NULL)
}

/// Reads a state of the page by way of a JSON value, so that the conversion to Rust types is compiled for JSON only.
/// JSON has no NaN or infinity; fields with such numbers are reported here.
///
/// # Errors
/// The fields whose numbers are not finite; otherwise the malformed part.
pub(crate) fn read(state: &JsValue) -> Result<State, JsValue> {
    let value = json(state);
    if let Ok(Value::Object(parts)) = &value {
        let mut problems = Vec::new();
        for (name, part) in parts {
            not_numbers(part, &|| member(state, name), "", &mut problems);
        }
        if !problems.is_empty() {
            return Err(thrown(problems));
        }
    }
    let state = value.and_then(|value| State::read(&value));
    state.map_err(|problem| thrown([problem]))
}

/// Reads a value given by the page by way of a JSON value, as [`read`] does.
///
/// # Errors
/// The malformed part.
pub(crate) fn read_value<T: DeserializeOwned>(given: &JsValue) -> Result<T, JsValue> {
    let value = json(given).and_then(|value| from_json(&value));
    value.map_err(|problem| thrown([problem]))
}

/// Reads a variant of an enum: an object with the name of the variant in the field `tag`.
///
/// # Errors
/// The malformed part; `tag` if it is missing or names no variant.
pub(crate) fn read_tagged<T: DeserializeOwned>(given: &JsValue, tag: &str) -> Result<T, JsValue> {
    let variant = json(given).and_then(|mut value| {
        let name = value.as_object_mut().and_then(|fields| fields.remove(tag));
        let name = name.as_ref().and_then(Value::as_str);
        let name = name.ok_or_else(|| Problem::BadState {
            path: tag.to_owned(),
            detail: format!("missing field `{tag}`"),
        })?;
        let read = from_json(&Value::from_iter([(name, value)]));
        read.map_err(|problem| outside_variant(problem, name, tag))
    });
    variant.map_err(|problem| thrown([problem]))
}

/// Removes the name of a variant from the start of a problem's path, since the page's object has no such level. If the
/// path does not start with the name, the variant is unknown, and `tag` becomes the path.
fn outside_variant(problem: Problem, name: &str, tag: &str) -> Problem {
    let Problem::BadState { path, detail } = problem else {
        return problem;
    };
    let path = match path.strip_prefix(name) {
        Some("") => ".",
        Some(inside) => inside.trim_start_matches('.'),
        None => tag,
    };
    Problem::BadState {
        path: path.to_owned(),
        detail,
    }
}

fn json(given: &JsValue) -> Result<Value, Problem> {
    read_directly(given, ".")
}

/// Reads a value without JSON, which has no infinity.
///
/// # Errors
/// The malformed value, named by `path`.
pub(crate) fn read_directly<T: DeserializeOwned>(
    given: &JsValue,
    path: &str,
) -> Result<T, Problem> {
    serde_wasm_bindgen::from_value(given.clone()).map_err(|error| Problem::BadState {
        path: path.to_owned(),
        detail: error.to_string(),
    })
}

/// Adds a problem for each field that holds NaN or an infinity. JSON has `null` there, so only nulls are compared with
/// the original value, `given`.
fn not_numbers(
    read: &Value,
    given: &dyn Fn() -> JsValue,
    field: &str,
    problems: &mut Vec<Problem>,
) {
    match read {
        Value::Null if given().as_f64().is_some() => problems.push(Problem::NotANumber {
            field: field.to_owned().into(),
        }),
        Value::Array(items) => {
            for (index, item) in items.iter().enumerate().filter(|(_, item)| has_null(item)) {
                let of = || member(&given(), index as u32);
                not_numbers(item, &of, &format!("{field}[{index}]"), problems);
            }
        }
        Value::Object(fields) => {
            for (name, value) in fields.iter().filter(|(_, value)| has_null(value)) {
                let dot = if field.is_empty() { "" } else { "." };
                let of = || member(&given(), name);
                not_numbers(value, &of, &format!("{field}{dot}{name}"), problems);
            }
        }
        _ => {}
    }
}

fn has_null(value: &Value) -> bool {
    match value {
        Value::Null => true,
        Value::Array(items) => items.iter().any(has_null),
        Value::Object(fields) => fields.values().any(has_null),
        Value::Bool(_) | Value::Number(_) | Value::String(_) => false,
    }
}

/// Member of an object by name, or of a list by index; undefined if there is none.
fn member(of: &JsValue, name: impl Into<JsValue>) -> JsValue {
    Reflect::get(of, &name.into()).unwrap_or_default()
}

/// Converts problems to an error of JavaScript: see [`refused`].
pub(crate) fn thrown(problems: impl IntoIterator<Item = impl Into<Problem>>) -> JsValue {
    let problems: Vec<Problem> = problems.into_iter().map(Into::into).collect();
    refused(&problems)
}

/// Makes an error of JavaScript from problems: `problems` is an array of `{code, …}`, and `message` is the same as JSON.
pub(crate) fn refused<T: Serialize>(problems: &[T]) -> JsValue {
    let problems = to_js(&problems);
    let message = JSON::stringify(&problems).unwrap_or_default();
    let error = Error::new(&String::from(message));
    // A property can always be set on a new object.
    let _ = Reflect::set(&error, &"problems".into(), &problems);
    error.into()
}
