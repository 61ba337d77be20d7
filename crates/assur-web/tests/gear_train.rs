//! A differential driven as a function of time, through the interface in a real browser: summary, poses, plots and
//! load.

mod load;

use assur_web::{Simulator, catalogue, role_names};
use js_sys::JSON;
use serde_json::{Value, json};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::{console_log, wasm_bindgen_test};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use crate::{at, place, problems, readouts};

fn value(value: &JsValue) -> Value {
    let text: String = JSON::stringify(value).unwrap().into();
    serde_json::from_str(&text).unwrap()
}

fn js(value: &Value) -> JsValue {
    JSON::parse(&value.to_string()).unwrap()
}

fn state(document: &Value, plot: &str) -> JsValue {
    let view = json!({"phi_deg": 0, "playing": false, "direction": 1, "speed": 1, "traces": true, "lang": "en", "plot": plot});
    js(&json!({"format": 2, "kind": "gear-train", "document": document, "view": view}))
}

fn known(name: &str) -> Value {
    let all = value(&catalogue().unwrap());
    let mut all = all.as_array().unwrap().iter();
    let found = all.find(|preset| preset["id"] == name).unwrap();
    assert_eq!(found["kind"], "gear-train");
    found["document"].clone()
}

/// Opens a train of the catalogue with changed fields; returns the simulator and the summary.
fn opened(name: &str, plot: &str, changes: &Value) -> (Simulator, Value) {
    let mut document = known(name);
    for (key, other) in changes.as_object().unwrap() {
        document[key] = other.clone();
    }
    let mut simulator = Simulator::new();
    let summary = value(&simulator.set(state(&document, plot)).unwrap());
    (simulator, summary)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value}"))
}

fn near(found: &Value, expected: f64) {
    let off = number(found) - expected;
    assert!(
        off.abs() < 1e-9 * (1.0 + expected.abs()),
        "{found} {expected}"
    );
}

/// Returns the lists of `at`, all of whose numbers must be finite.
fn lists(simulator: &Simulator, time: f64) -> [Vec<f64>; 4] {
    let lists = at(simulator, time).unwrap();
    let mut numbers = lists.iter().flatten();
    assert!(numbers.all(|number| number.is_finite()), "{time}");
    lists
}

fn readout(simulator: &Simulator, time: f64, quantity: &str, order: usize) -> f64 {
    lists(simulator, time)[2][place(simulator, quantity, order)]
}

#[wasm_bindgen_test]
fn speeds_ratios_conditions_and_limits() {
    let (_, summary) = opened("train-magnets", "angles", &json!({}));
    let speeds = &summary["speeds"];
    // Willis's equation: the carrier turns at (20·60 + 43·12)/63 min⁻¹, and the satellites at n₃ − 2(60 − n₃).
    let carrier = 1716.0 / 63.0;
    for (name, speed) in [
        ("sun", 60.0),
        ("ring", 12.0),
        ("carrier", carrier),
        ("satellite", 3.0 * carrier - 120.0),
    ] {
        near(&speeds[name], speed);
    }
    assert_eq!(
        (&summary["free"], &summary["weights"]),
        (&json!("carrier"), &json!([20, 43]))
    );
    let ratios = summary["ratios"].as_array().unwrap();
    assert_eq!(ratios.len(), 6);
    let first = &ratios[0];
    assert_eq!(
        (&first["name"], &first["largest"]),
        (&json!("1/3(4)"), &json!(true))
    );
    near(&first["value"], 63.0 / 20.0);
    for identity in summary["identities"].as_array().unwrap() {
        near(&identity["sum"], 1.0);
    }
    let conditions = summary["conditions"].as_array().unwrap();
    let kinds: Vec<&str> = conditions
        .iter()
        .filter_map(|one| one["kind"].as_str())
        .collect();
    assert_eq!(
        kinds,
        ["room", "sun_gap", "ring_gap", "assembly", "neighbours"]
    );
    assert!(conditions.iter().all(|one| one["met"] == true));
    assert_eq!(
        (&summary["builds"], &summary["suggestions"]),
        (&json!(true), &json!([]))
    );
    assert_eq!(summary["gaps"], json!([3, 3]));
    let mobility = &summary["mobility"];
    assert_eq!(
        (&mobility["mobility"], &mobility["passive"]),
        (&json!(0), &json!(2))
    );
    // Torque per plate, kT/z: 3·2/20 at the sun, 3·5/43 at the ring. The weaker mesh limits all torques.
    for (name, limit) in [
        ("sun", 6.0),
        ("ring", 12.9),
        ("carrier", 18.9),
        ("satellite", 10.0 * (0.3 + 15.0 / 43.0)),
    ] {
        near(&summary["limits"][name], limit);
    }
    near(&summary["load"]["value"], 8.0);
    near(&summary["load"]["max"], 1.5 * 18.9);
    assert_eq!(
        (&summary["slips"], &summary["halt"]),
        (&Value::Null, &Value::Null)
    );
    let powers = &summary["powers"];
    let sum: f64 = ["sun", "carrier", "ring"]
        .map(|name| number(&powers[name]))
        .iter()
        .sum();
    assert!(sum.abs() < 1e-9, "{powers}");
    // Trains with gears, and trains that are not planar, have no motion under load.
    for name in ["train-gears", "train-stepped", "train-bevel"] {
        let (_, summary) = opened(name, "angles", &json!({}));
        assert_eq!(
            (&summary["builds"], &summary["limits"]),
            (&json!(true), &Value::Null),
            "{name}"
        );
    }
    let (_, summary) = opened("train-magnets", "angles", &json!({"satellites": 4}));
    assert_eq!(summary["builds"], false);
    assert_eq!(summary["suggestions"].as_array().unwrap().len(), 5);
}

#[wasm_bindgen_test]
fn a_place_has_all_that_is_named() {
    for (name, plot, loaded) in [
        ("train-magnets", "angles", false),
        ("train-magnets", "angles", true),
        ("train-magnets", "load", true),
        ("train-magnets", "sun.angle", true),
        ("train-magnets", "ring.load_angle", true),
        ("train-gears", "satellite.angle", false),
        ("train-stepped", "angles", false),
        ("train-bevel", "angles", false),
    ] {
        let (simulator, summary) = opened(name, plot, &json!({"loaded": loaded, "span_s": 1}));
        let ids = readouts(&simulator);
        let quantities = if loaded { 6 } else { 4 };
        let rest = if loaded { 11 } else { 0 };
        assert_eq!(ids.len(), 1 + 3 * quantities + rest);
        let plotted = summary["plotted"].as_array().unwrap();
        let expected = match plot {
            "angles" => 4,
            "load" => 2,
            _ => 1,
        };
        assert_eq!(plotted.len(), expected);
        assert_eq!(summary["listed"].as_array().unwrap().len(), quantities);
        for listed in summary["listed"].as_array().unwrap() {
            assert!(
                ids.iter().any(|(quantity, _)| listed["name"] == *quantity),
                "{listed}"
            );
        }
        for time in [0.0, 0.3, 1.0] {
            let [now, handles, readouts, values] = lists(&simulator, time);
            assert!(!now.is_empty());
            assert_eq!(
                (handles.len(), readouts.len(), values.len()),
                (0, ids.len(), 3 * expected)
            );
            assert_eq!(readouts[0], time);
            assert_eq!(simulator.plotted(time).unwrap(), values);
            for (at, one) in plotted.iter().enumerate() {
                let place = place(&simulator, one.as_str().unwrap(), 0);
                assert_eq!(values[3 * at..3 * at + 3], readouts[place..place + 3]);
            }
        }
        for wrong in [f64::NAN, -1.0, f64::INFINITY, 1e300] {
            lists(&simulator, wrong);
        }
        // The wheels of a bevel train are redrawn in every frame, so none are in the list of rigid shapes.
        let empty = simulator.scene().unwrap().is_empty();
        assert_eq!(empty, name == "train-bevel");
    }
}

#[wasm_bindgen_test]
fn unknown_plots_are_refused_and_the_last_state_is_kept() {
    let (mut simulator, _) = opened("train-magnets", "angles", &json!({}));
    let before = lists(&simulator, 2.0);
    let document = known("train-magnets");
    for plot in ["load", "sun.load_angle", "planet.angle", "carrier"] {
        let thrown = value(&problems(
            &simulator.set(state(&document, plot)).unwrap_err(),
        ));
        assert_eq!(
            thrown,
            json!([{"code": "unknown_choice", "field": "plot"}]),
            "{plot}"
        );
    }
    for (field, wrong, code) in [
        ("z4", json!(20), "ring_not_larger"),
        ("z4", json!(38), "contact"),
        ("drives", json!([]), "drive_count"),
        ("span_s", json!(1e9), "out_of_range"),
        ("z1", json!("many"), "bad_state"),
    ] {
        let mut damaged = document.clone();
        damaged[field] = wrong;
        let thrown = value(&problems(
            &simulator.set(state(&damaged, "angles")).unwrap_err(),
        ));
        assert_eq!(thrown[0]["code"], code, "{thrown}");
    }
    assert_eq!(lists(&simulator, 2.0), before);
    assert_eq!(value(&simulator.why(1.0).unwrap()), json!([]));
}

#[wasm_bindgen_test]
fn time_goes_on_and_a_run_begins_again() {
    let (simulator, summary) = opened("train-magnets", "angles", &json!({}));
    assert_eq!(summary["cycle"]["end"], 6);
    let advance =
        |simulator: &Simulator, input: f64, by: f64| simulator.advance(input, by).unwrap();
    assert_eq!(advance(&simulator, 1e5, 7.0), [1e5 + 7.0, 1.0]);
    assert_eq!(advance(&simulator, 1.0, -3.0), [2.0, -1.0]);
    assert_eq!(advance(&simulator, 1e6, 7.0), [1e6, 1.0]);
    assert_eq!(advance(&simulator, 1.0, f64::NAN)[0], 0.0);
    let (simulator, summary) = opened(
        "train-magnets",
        "load",
        &json!({"loaded": true, "span_s": 2}),
    );
    assert_eq!(
        (&summary["cycle"]["end"], &summary["cycle"]["full"]),
        (&json!(2), &json!(false))
    );
    assert_eq!(advance(&simulator, 1.5, 1.0), [0.5, 1.0]);
    assert_eq!(advance(&simulator, 0.5, -1.0), [1.5, 1.0]);
}

/// With the sun at 60 min⁻¹ and the ring at 12, 10,000 turns of the sun take 10,000 s.
#[wasm_bindgen_test]
fn angles_are_told_after_ten_thousand_turns() {
    let (simulator, _) = opened("train-magnets", "angles", &json!({}));
    let turn = std::f64::consts::TAU;
    assert_eq!(
        readout(&simulator, 10_000.0, "sun.angle", 0),
        10_000.0 * turn
    );
    assert_eq!(
        readout(&simulator, 10_000.0, "ring.angle", 0),
        2_000.0 * turn
    );
    let carrier = readout(&simulator, 10_000.0, "carrier.angle", 0);
    assert!(
        (carrier - 286_000.0 / 63.0 * turn).abs() < 1e-11,
        "{carrier}"
    );
}

#[wasm_bindgen_test]
fn observers_see_their_shaft_at_rest() {
    for (name, loaded) in [
        ("train-magnets", false),
        ("train-magnets", true),
        ("train-bevel", false),
    ] {
        let ground = json!({"loaded": loaded, "span_s": 1});
        let (ground, _) = opened(name, "angles", &ground);
        for observer in ["sun", "carrier", "ring"] {
            let (seen, _) = opened(
                name,
                "angles",
                &json!({"loaded": loaded, "span_s": 1, "observer": observer}),
            );
            for time in [0.25, 0.75] {
                for order in 0..3 {
                    let of = |simulator: &Simulator, body: &str| {
                        readout(simulator, time, &format!("{body}.angle"), order)
                    };
                    assert_eq!(of(&seen, observer), 0.0, "{observer} {order}");
                    for body in ["sun", "carrier", "ring"] {
                        let relative = of(&ground, body) - of(&ground, observer);
                        assert!(
                            (of(&seen, body) - relative).abs() < 1e-9 * (1.0 + relative.abs()),
                            "{body} {observer} {order}"
                        );
                    }
                }
            }
        }
    }
}

/// Relative to their axes, bevel satellites rotate equally for an observer on the carrier and for one on the ground.
#[wasm_bindgen_test]
fn bevel_satellites_turn_about_their_own_axes_for_everybody() {
    let (ground, _) = opened("train-bevel", "angles", &json!({}));
    let (carrier, _) = opened("train-bevel", "angles", &json!({"observer": "carrier"}));
    let [one, other] = [&ground, &carrier].map(|from| readout(from, 1.0, "satellite.angle", 1));
    // The speed is (30 − 36)·24/16 min⁻¹.
    let expected = -9.0 * std::f64::consts::TAU / 60.0;
    assert!(
        (one - expected).abs() < 1e-12 && (other - expected).abs() < 1e-12,
        "{one} {other}"
    );
}
