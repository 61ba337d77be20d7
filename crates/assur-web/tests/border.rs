//! The interface to JavaScript in a real browser, and the engine against its golden tables there: everything that
//! wasm-pack runs.
#![cfg(target_family = "wasm")]
#![allow(
    clippy::unwrap_used,
    clippy::panic,
    reason = "that is how a test fails"
)]

// `tests/native.rs` runs the same sources natively.
#[path = "../../../tests/class4.rs"]
mod class4;
mod gear_train;
#[path = "../../../tests/golden.rs"]
mod golden;
mod linkage;
mod scheme;
mod simulator;
mod synthesis;

use assur_web::Simulator;
use js_sys::{Array, Error, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test_configure;

wasm_bindgen_test_configure!(run_in_browser);

/// Returns frame, handles, read-outs and plotted values at an input.
fn at(simulator: &Simulator, input: f64) -> Result<[Vec<f64>; 4], JsValue> {
    let here = simulator.at(input)?;
    Ok(["frame", "handles", "readouts", "plotted"].map(|name| {
        let list = Array::from(&Reflect::get(&here, &name.into()).unwrap());
        list.iter().map(|one| one.as_f64().unwrap()).collect()
    }))
}

/// Returns quantity and order of each read-out.
fn readouts(simulator: &Simulator) -> Vec<(String, usize)> {
    let all = Array::from(&simulator.readouts().unwrap());
    let part = |id: &JsValue, key: &str| Reflect::get(id, &key.into()).unwrap();
    all.iter()
        .map(|id| {
            let order = part(&id, "order").as_f64().unwrap();
            (part(&id, "quantity").as_string().unwrap(), order as usize)
        })
        .collect()
}

/// Returns the index of a read-out.
fn place(simulator: &Simulator, quantity: &str, order: usize) -> usize {
    let all = readouts(simulator);
    let found = all
        .iter()
        .position(|id| *id == (quantity.to_owned(), order));
    found.unwrap()
}

/// Returns the problems of an error.
fn problems(error: &JsValue) -> JsValue {
    assert!(error.has_type::<Error>());
    Reflect::get(error, &"problems".into()).unwrap()
}
