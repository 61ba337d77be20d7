//! A scheme through the interface in a real browser: its summary, pairs that are cut, the chain that opens.

use assur_web::{Simulator, catalogue, task};
use js_sys::JSON;
use serde_json::{Value, json};
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::at;

fn value(value: &JsValue) -> Value {
    let text: String = JSON::stringify(value).unwrap().into();
    serde_json::from_str(&text).unwrap()
}

fn js(value: &Value) -> JsValue {
    JSON::parse(&value.to_string()).unwrap()
}

/// Returns the state of a document of any kind.
fn state(kind: &str, document: &Value) -> JsValue {
    let view = json!({"phi_deg": 45, "playing": false, "direction": 1, "speed": 1, "traces": true, "lang": "en"});
    js(&json!({"format": 2, "kind": kind, "document": document, "view": view}))
}

/// Returns a document of the catalogue.
fn known(name: &str) -> Value {
    let all = value(&catalogue().unwrap());
    let mut all = all.as_array().unwrap().iter();
    let found = all.find(|preset| preset["id"] == name).unwrap();
    found["document"].clone()
}

/// Opens a scheme of the catalogue with other cuts; returns the simulator and the summary.
fn opened(name: &str, cut: &Value) -> (Simulator, Value) {
    let mut simulator = Simulator::new();
    let mut document = known(name);
    document["cut"] = cut.clone();
    let summary = value(&simulator.set(state("scheme", &document)).unwrap());
    (simulator, summary)
}

#[wasm_bindgen_test]
fn the_table_of_the_paper() {
    let expected = [
        ("mobility-1a", 7, 0, json!([7, 0]), 7),
        ("mobility-1b", 7, 0, json!([7, 0]), 7),
        ("mobility-2a", 1, 3, json!([3, 2]), 1),
        ("mobility-2c", 1, 6, json!([5, 4]), 1),
        ("mobility-3", 2, 0, json!([10, 8]), 2),
        ("mobility-4", 1, 6, json!([5, 4]), 1),
    ];
    for (name, w, q, counted, rank) in expected {
        let cut = known(name)["cut"].clone();
        let (_, summary) = opened(name, &cut);
        assert_eq!(
            (&summary["mobility"], &summary["redundant"]),
            (&json!(w), &json!(q)),
            "{name}"
        );
        let sections = &summary["sections"];
        assert_eq!(
            json!([sections["open"], sections["removed"]]),
            counted,
            "{name}"
        );
        let own = if summary["planar"] == true {
            "plane"
        } else {
            "space"
        };
        assert_eq!(summary[own]["mobility"], rank, "{name}");
        assert_eq!(summary["moves"], Value::Null);
    }
}

#[wasm_bindgen_test]
fn a_pressed_pair_is_cut_and_joined_again() {
    let (simulator, summary) = opened("mobility-4", &json!(["Q"]));
    // The contour of the moving links is still closed.
    let mut closed: Vec<&str> = summary["closed"]
        .as_array()
        .unwrap()
        .iter()
        .filter_map(Value::as_str)
        .collect();
    closed.sort_unstable();
    assert_eq!(closed, ["C", "D", "E", "F"]);
    assert_eq!(summary["sections"], Value::Null);
    let pressed = |name: &str| value(&simulator.press(name).unwrap())["document"].clone();
    assert_eq!(pressed("F"), json!({"cut": ["Q", "F"]}));
    assert_eq!(pressed("Q"), json!({"cut": []}));
    assert!(simulator.press("X").is_err());

    let (_, summary) = opened("mobility-4", &json!(["Q", "F", "E"]));
    assert_eq!(summary["apart"], json!(["5"]));
}

#[wasm_bindgen_test]
fn the_chain_falls_open_by_and_by() {
    let (simulator, summary) = opened("mobility-2a", &json!(["D"]));
    assert_eq!(summary["handles"][3]["pressed"], true);
    let handle = |opened: f64| {
        let [_, handles, ..] = at(&simulator, opened).unwrap();
        (handles[6], handles[7])
    };
    let way = |opened: f64| {
        let ((x, y), (from_x, from_y)) = (handle(opened), handle(0.0));
        (x - from_x).hypot(y - from_y)
    };
    let ways = [0.0, 0.3, 0.6, 1.0].map(way);
    assert!(
        ways[0] == 0.0 && ways.windows(2).all(|two| two[0] < two[1]),
        "{ways:?}"
    );
    for wrong in [f64::NAN, -1.0, 2.0, f64::INFINITY] {
        assert!(
            at(&simulator, wrong)
                .unwrap()
                .iter()
                .flatten()
                .all(|number| number.is_finite())
        );
    }
}

#[wasm_bindgen_test]
fn a_pair_is_dragged_where_nothing_is_cut() {
    let (simulator, _) = opened("mobility-2a", &json!([]));
    let change = value(&simulator.drag("C", 0.0, 4.5, 5.5).unwrap());
    assert_eq!(change["document"]["pairs"][2]["at"], json!([4.5, 5.5]));
    assert!(simulator.drag("C", 0.0, f64::NAN, 5.0).is_err());
    let (simulator, _) = opened("mobility-2a", &json!(["D"]));
    assert_eq!(
        value(&simulator.drag("C", 0.0, 4.5, 5.5).unwrap()),
        json!({})
    );
}

#[wasm_bindgen_test]
fn what_moves_becomes_a_scheme() {
    let mut simulator = Simulator::new();
    for (kind, name, w) in [
        ("linkage", "jansen", 1),
        ("mixer", "mixer-a", 1),
        ("linkage", "geared-five-bar", 1),
    ] {
        let summary = value(&simulator.set(state(kind, &known(name))).unwrap());
        let becomes = summary["becomes"].as_array().unwrap();
        assert!(becomes.contains(&json!("scheme")), "{becomes:?}");
        let home = summary["home"].as_f64().unwrap();
        let made = value(&simulator.as_kind("scheme", home).unwrap());
        assert_eq!(made["kind"], "scheme");
        let mut other = Simulator::new();
        let scheme = value(&other.set(state("scheme", &made["document"])).unwrap());
        assert_eq!(
            (&scheme["mobility"], &scheme["plane"]["mobility"]),
            (&json!(w), &json!(w)),
            "{name}"
        );
        assert!(other.as_kind("scheme", home).is_err());
    }
    assert!(simulator.as_kind("synthesis", 0.0).is_err());
}

#[wasm_bindgen_test]
fn a_four_bar_is_mended() {
    let (simulator, summary) = opened("mobility-2a", &json!([]));
    let list = summary["mended"]["list"].as_array().unwrap();
    assert_eq!(list[0].as_array().unwrap().len(), 1);
    for number in 1..=list.len() {
        let change = value(
            &simulator
                .set_dimension("mended", number as f64, 0.0)
                .unwrap(),
        );
        let mut document = known("mobility-2a");
        document["pairs"] = change["document"]["pairs"].clone();
        let mut other = Simulator::new();
        let mended = value(&other.set(state("scheme", &document)).unwrap());
        assert_eq!(
            (&mended["mobility"], &mended["redundant"]),
            (&json!(1), &json!(0))
        );
        assert_eq!(
            (&mended["space"]["mobility"], &mended["space"]["redundant"]),
            (&json!(1), &json!(0))
        );
    }
    for wrong in [0.0, 0.5, -1.0, 1e9, f64::NAN] {
        assert!(simulator.set_dimension("mended", wrong, 0.0).is_err());
    }
}

#[wasm_bindgen_test]
fn tasks_are_sound() {
    let mut simulator = Simulator::new();
    for number in 0..40 {
        let made = value(&task(number));
        assert_eq!(made["document"]["task"], number);
        let summary = value(&simulator.set(state("scheme", &made["document"])).unwrap());
        assert!(summary["mobility"].as_i64().unwrap() >= 1, "{number}");
    }
}
