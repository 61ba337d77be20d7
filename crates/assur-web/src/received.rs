//! Input from outside (a URL, a file, browser storage), read and checked.

use assur_file::{LessonDocument, Problem, State, View, in_step};
use wasm_bindgen::prelude::{JsValue, wasm_bindgen};

use crate::convert::{read, read_value, thrown, to_js};
use crate::kinds::open;

/// Reads and checks a state, its compared document and everything that its lesson shows. Returns
/// the same state, with known keys only.
///
/// # Errors
/// Every problem of the state; if it has none, of the compared document; then of the first faulty step of the lesson.
#[wasm_bindgen(js_name = readState, unchecked_return_type = "State & { view: View }")]
pub fn read_state(
    #[wasm_bindgen(unchecked_param_type = "unknown")] state: JsValue,
) -> Result<JsValue, JsValue> {
    let state = read(&state)?;
    open(&state).map_err(thrown)?;
    if let Some(document) = &state.compared {
        let alone = State {
            document: document.clone(),
            view: View::default(),
            lesson: None,
            compared: None,
            picture: None,
            ..state
        };
        let in_it = |problems| thrown([vec![Problem::InCompared], problems].concat());
        open(&alone).map_err(in_it)?;
    }
    for (step, shown) in state.lesson.iter().flat_map(LessonDocument::shown) {
        open(&shown).map_err(|problems| thrown(in_step(step, problems)))?;
    }
    Ok(to_js(&state))
}

/// Reads and checks a lesson, except for the documents that it shows. Returns the same lesson, with known keys only.
///
/// # Errors
/// Every problem of the lesson.
#[wasm_bindgen(js_name = readLesson, unchecked_return_type = "LessonDocument")]
pub fn read_lesson(
    #[wasm_bindgen(unchecked_param_type = "unknown")] lesson: JsValue,
) -> Result<JsValue, JsValue> {
    let lesson: LessonDocument = read_value(&lesson)?;
    lesson.check().map_err(thrown)?;
    Ok(to_js(&lesson))
}

/// Checks that the JSON of a file has no duplicate keys. The browser's own parser keeps the last one.
///
/// # Errors
/// The path of the duplicate key.
#[wasm_bindgen(js_name = checkKeys)]
pub fn check_keys(text: &str) -> Result<(), JsValue> {
    assur_file::keys_once(text).map_err(|problem| thrown([problem]))
}
