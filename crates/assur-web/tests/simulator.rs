//! The simulator through its interface in a real browser: parameters and results are JavaScript values.

mod charts;

use assur_web::{Simulator, catalogue, check_keys};
use js_sys::{Array, JSON, Object, Reflect};
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_test::wasm_bindgen_test;
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement};

use crate::{at, place, problems, readouts};

const STATE: &str = r#"{"format":1,"lesson":"mixer",
    "document":{"l1":0.37,"l2":0.85,"l3":0.55,"l4":0.85,"z4":36,"z5":18,
        "mesh":"external","module":0.0165,"centre_line_deg":-40,"assembly":1},
    "view":{"phi_deg":62,"playing":true,"direction":1,"speed":1,"traces":true,"lang":"en"}}"#;

fn state() -> JsValue {
    JSON::parse(STATE).unwrap()
}

fn get(object: &JsValue, path: &str) -> JsValue {
    path.split('.').fold(object.clone(), |object, key| {
        Reflect::get(&object, &key.into()).unwrap()
    })
}

fn number(object: &JsValue, path: &str) -> f64 {
    get(object, path).as_f64().unwrap()
}

fn put(object: &JsValue, path: &str, key: &str, value: JsValue) {
    Reflect::set(&get(object, path), &key.into(), &value).unwrap();
}

/// Returns codes and fields of an error's problems.
fn thrown(error: JsValue) -> Vec<(String, String)> {
    listed(problems(&error))
}

/// Returns codes and fields of problems.
fn listed(problems: JsValue) -> Vec<(String, String)> {
    let text = |problem: &JsValue, key: &str| get(problem, key).as_string().unwrap_or_default();
    let problems: Array = problems.unchecked_into();
    problems
        .iter()
        .map(|p| (text(&p, "code"), text(&p, "field")))
        .collect()
}

fn frame(simulator: &Simulator, input: f64) -> Vec<f64> {
    at(simulator, input).unwrap()[0].clone()
}

fn simulator() -> Simulator {
    let mut simulator = Simulator::new();
    simulator.set(state()).unwrap();
    simulator
}

#[wasm_bindgen_test]
fn a_table_has_the_golden_numbers_and_reasons() {
    let simulator = simulator();
    let table = simulator.sweep(360).unwrap();
    let columns: Array = get(&table, "columns").unchecked_into();
    let named = |name: &str| columns.iter().position(|one| get(&one, "name") == name);
    let column = |name: &str| named(name).unwrap();
    let value = |table: &JsValue, row: u32, name: &str| {
        get(table, &format!("rows.{row}.values.{}", column(name)))
    };
    assert_eq!(number(&table, "rows.length"), 361.0);
    assert_eq!(number(&table, "rows.5.input"), 5.0);
    // The row at 5° of tests/data/mixer.csv.
    for (name, expected, tolerance) in [
        ("coupler.angle", 0.583_469_077_417_292_1, 1e-12),
        ("rocker.dangle", -0.602_993_892_844_061_5, 1e-11),
        ("rocker.ddangle", 2.014_553_281_859_781_6, 1e-10),
        ("C2.x", 0.723_278_543_597_030_3, 1e-12),
        ("C3.ddy", 0.138_626_804_903_905_4, 1e-10),
    ] {
        let found = value(&table, 5, name).as_f64().unwrap();
        assert!((found - expected).abs() <= tolerance, "{name}: {found}");
    }
    assert!(get(&table, "rows.5.reason").is_null());

    // With these lengths the dead points are at crank angles of ±90°, and the motion goes from one to the other.
    let mut simulator = simulator;
    let state = state();
    for (key, length) in [("l1", 3.0), ("l2", 2.0), ("l3", 3.0), ("l4", 4.0)] {
        put(&state, "document", key, length.into());
    }
    simulator.set(state).unwrap();
    // A table has at least one step.
    let table = simulator.sweep(0).unwrap();
    assert_eq!(number(&table, "rows.length"), 3.0);
    let table = simulator.sweep(8).unwrap();
    assert_eq!(number(&table, "rows.length"), 5.0);
    for row in 0..5 {
        let input = number(&table, &format!("rows.{row}.input"));
        let expected = 45.0 * (f64::from(row) - 2.0);
        assert!((input - expected).abs() < 1e-12, "{row}: {input}");
        let turns_back = [0, 4].contains(&row);
        let reason = get(&table, &format!("rows.{row}.reason"));
        let code = (!reason.is_null()).then(|| get(&reason, "code").as_string().unwrap());
        assert_eq!(code.as_deref(), turns_back.then_some("dead_point"), "{row}");
        assert!(!value(&table, row, "C.x").is_null(), "{row}");
        assert_eq!(value(&table, row, "C.dx").is_null(), turns_back, "{row}");
    }
}

#[wasm_bindgen_test]
fn summary_reads_as_the_papers_conclusions() {
    let mut simulator = Simulator::new();
    for (preset, rocker, wheel5) in [
        (0, 87.904_535_205_78, 175.809_070_41),
        (1, 53.451_734_436_43, 106.903_468_87),
        (2, 87.904_535_205_78, 43.952_267_60),
    ] {
        let state = state();
        let document = get(&catalogue().unwrap(), &format!("{preset}.document"));
        Reflect::set(&state, &"document".into(), &document).unwrap();
        let summary = simulator.set(state).unwrap();
        let outputs = simulator.outputs().unwrap();
        for (output, expected, within) in [(0, rocker, 1e-9), (1, wheel5, 1e-7)] {
            let stroke = number(&outputs, &format!("{output}.swing.0.stroke"));
            let off = stroke.to_degrees() - expected;
            assert!(off.abs() < within, "{output}: {off}");
        }
        assert_eq!(
            get(&summary, "four_bars.0.grashof").as_string().unwrap(),
            "crank_rocker"
        );
    }
}

#[wasm_bindgen_test]
fn readouts_say_what_they_are_of() {
    let simulator = simulator();
    let [_, _, values, _] = at(&simulator, 0.0).unwrap();
    assert_eq!(readouts(&simulator).len(), values.len());
    let value = |quantity: &str, order| values[place(&simulator, quantity, order)];
    // The values are those of the first row of the golden table, with ratio −u for external mesh.
    assert!((value("rocker.angle", 0) - 1.203_502_674_167_423_5).abs() < 1e-12);
    assert!((value("rocker.angle", 1) + 0.770_833_333_333_333_3).abs() < 1e-12);
    assert!((value("coupler.angle", 2) - 0.525_194_435_249_167_6).abs() < 1e-12);
    assert!((value("wheel5.angle", 1) - 2.0 * 0.770_833_333_333_333_3).abs() < 1e-12);
}

#[wasm_bindgen_test]
fn bad_input_names_the_field_and_changes_nothing() {
    let mut simulator = simulator();
    let before = frame(&simulator, 1.0);
    let number = JsValue::from_f64;
    for (field, value, code) in [
        ("l1", number(f64::NAN), "not_a_number"),
        ("l2", number(f64::INFINITY), "not_a_number"),
        ("l3", number(0.0), "not_positive"),
        ("l4", number(-0.85), "not_positive"),
        ("l4", number(1e300), "out_of_range"),
        ("l4", number(5.0), "too_long"),
        ("z4", number(0.0), "not_positive"),
        ("mesh", "worm".into(), "unknown_choice"),
        ("assembly", number(3.0), "unknown_choice"),
        ("module", number(0.0), "not_positive"),
    ] {
        let state = state();
        put(&state, "document", field, value);
        let problems = thrown(simulator.set(state).unwrap_err());
        assert_eq!(problems, [(code.to_owned(), field.to_owned())]);
        assert_eq!(frame(&simulator, 1.0), before);
    }
    for (place, field, value, code) in [
        ("wheels.1", "z", number(-3.0), "not_positive"),
        ("wheels.1", "z", number(1.5), "not_whole"),
        ("wheels.0", "z", number(1e9), "out_of_range"),
        (
            "wheels.1",
            "centre_line_deg",
            number(f64::NAN),
            "not_a_number",
        ),
        ("tracers.0", "link", "wheel7".into(), "unknown_choice"),
        ("tracers.0", "x", number(1e300), "out_of_range"),
    ] {
        let state = full();
        put(&state, &format!("document.{place}"), field, value);
        let problems = thrown(simulator.set(state).unwrap_err());
        let (list, index) = place.split_once('.').unwrap();
        assert_eq!(
            problems,
            [(code.to_owned(), format!("{list}[{index}].{field}"))]
        );
        assert_eq!(frame(&simulator, 1.0), before);
    }
}

/// Returns a state with two peripheral wheels and a traced point on the second.
fn full() -> JsValue {
    let state = state();
    let wheels = r#"[{"z":18,"centre_line_deg":-40},{"z":24,"centre_line_deg":0}]"#;
    put(&state, "document", "wheels", JSON::parse(wheels).unwrap());
    let tracers = r#"[{"link":"wheel6","x":0.1,"y":0.05}]"#;
    put(&state, "document", "tracers", JSON::parse(tracers).unwrap());
    state
}

#[wasm_bindgen_test]
fn wheels_are_summed_up_one_by_one() {
    let mut simulator = Simulator::new();
    let summary = simulator.set(full()).unwrap();
    let outputs = simulator.outputs().unwrap();
    // The swing of the rocker, degrees; the travel is there and back over one turn of the crank.
    let stroke = 87.904_535_205_78;
    for (wheel, ratio) in [(0, 2.0), (1, 1.5)] {
        assert_eq!(number(&summary, &format!("ratios.{wheel}")), -ratio);
        let of = |key: &str| number(&outputs, &format!("{}.{key}", wheel + 1));
        assert!((of("swing.0.stroke").to_degrees() - ratio * stroke).abs() < 1e-7);
        assert!((of("turns.0") - ratio * stroke / 180.0).abs() < 1e-10);
    }
    // The two wheels overlap: their axes are 40° apart at distances of 27 and 30 modules, and their tip radii are 10
    // and 13.
    assert_eq!(number(&summary, "overlaps.0.0"), 0.0);
    assert_eq!(number(&summary, "overlaps.0.1"), 1.0);
    let free = number(&summary, "free_direction").to_degrees();
    assert!((free.abs() - 160.0).abs() < 5.0, "{free}");
}

#[wasm_bindgen_test]
fn points_are_put_on_links_and_dragged_along() {
    let mut simulator = Simulator::new();
    simulator.set(full()).unwrap();
    let state = full();
    let summary = simulator.set(state.clone()).unwrap();
    let handles: Array = get(&summary, "handles").unchecked_into();
    let names: Vec<String> = handles
        .iter()
        .map(|handle| get(&handle, "name").as_string().unwrap())
        .collect();
    let place = |simulator: &Simulator, name: &str| {
        let [_, places, ..] = at(simulator, 1.0).unwrap();
        let index = names.iter().position(|one| one == name).unwrap();
        [places[2 * index], places[2 * index + 1]]
    };
    let [x, y] = place(&simulator, "P1");
    let [x, y] = [x + 0.02, y - 0.03];
    let dragged = simulator.drag("P1", 1.0, x, y).unwrap();
    let tracers = get(&dragged, "document.tracers");
    assert_eq!(get(&tracers, "0.link").as_string().unwrap(), "wheel6");
    put(&state, "document", "tracers", tracers);
    simulator.set(state).unwrap();
    let [found_x, found_y] = place(&simulator, "P1");
    assert!((found_x - x).hypot(found_y - y) < 1e-14);

    // The new traced point is at the middle of the coupler.
    let [b, c] = ["B", "C"].map(|name| place(&simulator, name));
    let [x, y] = [0, 1].map(|axis| 0.5 * (b[axis] + c[axis]));
    let tracers = get(&simulator.trace(1.0, x, y).unwrap(), "document.tracers");
    assert_eq!(get(&tracers, "1.link").as_string().unwrap(), "coupler");
    assert!((number(&tracers, "1.x") - 0.425).abs() < 1e-12);
    assert!(number(&tracers, "1.y").abs() < 1e-12);
    assert_eq!(
        thrown(simulator.drag("P2", 1.0, x, y).unwrap_err())[0].0,
        "bad_state"
    );
}

#[wasm_bindgen_test]
fn an_assembly_is_chosen_by_its_number() {
    let simulator = simulator();
    let here = simulator.assemblies(1.0).unwrap();
    let shown = number(&here, "shown") as usize;
    assert_eq!(number(&here, &format!("all.{shown}.number")), 1.0);
    assert_eq!(number(&here, &format!("all.{}.number", 1 - shown)), 2.0);
    // The bodies of the shown assembly agree with the frame.
    let bodies: Array = get(&here, &format!("all.{shown}.bodies")).unchecked_into();
    let frame = frame(&simulator, 1.0);
    for (k, body) in bodies.iter().enumerate() {
        assert!((body.as_f64().unwrap() - frame[k]).abs() < 1e-6, "{k}");
    }
    for (chosen, said) in [(1, 1.0), (2, 2.0)] {
        let change = simulator.assemble(chosen, 1.0).unwrap();
        assert_eq!(number(&change, "document.assembly"), said);
        let document: Object = get(&change, "document").unchecked_into();
        assert_eq!(Object::keys(&document).length(), 1);
        assert!(get(&change, "input").is_undefined());
    }
    for none in [0, 3] {
        let problems = thrown(simulator.assemble(none, 1.0).unwrap_err());
        assert_eq!(problems[0].0, "bad_state");
    }
}

#[wasm_bindgen_test]
fn keys_that_stand_twice_are_refused_with_a_path() {
    assert!(check_keys(r#"{"document": {"l1": 1, "l2": 1}}"#).is_ok());
    let twice = check_keys(r#"{"document": {"l1": 1, "l1": 1}}"#).unwrap_err();
    assert_eq!(thrown(twice.clone())[0].0, "key_twice");
    assert_eq!(
        get(&twice, "problems.0.path").as_string().unwrap(),
        "document.l1"
    );
}

#[wasm_bindgen_test]
fn broken_states_are_refused_with_a_path() {
    let mut simulator = simulator();
    let before = frame(&simulator, 1.0);
    let path = |error: JsValue| get(&error, "problems.0.path").as_string().unwrap();
    for (at, key, value, expected) in [
        ("document", "l2", "long".into(), "document.l2"),
        ("document", "l2", JsValue::NULL, "document.l2"),
        ("document", "z4", Array::new().into(), "document.z4"),
        ("view", "traces", 7.into(), "view.traces"),
    ] {
        let state = state();
        put(&state, at, key, value);
        assert_eq!(path(simulator.set(state).unwrap_err()), expected);
    }
    for nothing in [
        JsValue::NULL,
        JsValue::UNDEFINED,
        3.into(),
        "text".into(),
        Array::new().into(),
    ] {
        let problems = thrown(simulator.set(nothing).unwrap_err());
        assert_eq!(problems[0].0, "bad_state");
    }
    assert_eq!(frame(&simulator, 1.0), before);
}

#[wasm_bindgen_test]
fn angles_without_a_pose_are_thrown() {
    let mut simulator = simulator();
    let state = state();
    put(&state, "document", "l1", 0.6.into());
    put(&state, "document", "l3", 0.3.into());
    let summary = simulator.set(state).unwrap();
    assert_eq!(get(&summary, "cycle.full").as_bool(), Some(false));
    assert_eq!(thrown(simulator.at(3.1).unwrap_err())[0].0, "apart");
    assert_eq!(
        thrown(simulator.at(f64::NAN).unwrap_err())[0].0,
        "not_a_number"
    );
    let end = number(&summary, "dead_points.0.input");
    let [place, _, readouts, plotted] = at(&simulator, end).unwrap();
    assert!(!place.is_empty() && readouts.is_empty() && plotted.is_empty());
    assert_eq!(listed(simulator.why(end).unwrap())[0].0, "dead_point");
    let home = number(&summary, "home");
    let [phi, _] = simulator.advance(home, 100.0).unwrap()[..] else {
        panic!("two numbers")
    };
    assert!(simulator.at(phi).is_ok());
    assert_eq!(listed(simulator.why(home).unwrap()), []);
}

#[wasm_bindgen_test]
fn nothing_is_set_before_set() {
    let simulator = Simulator::new();
    assert_eq!(thrown(simulator.at(0.0).unwrap_err())[0].0, "bad_state");
    assert_eq!(thrown(simulator.why(0.0).unwrap_err())[0].0, "bad_state");
    assert_eq!(thrown(simulator.scene().unwrap_err())[0].0, "bad_state");
    assert_eq!(
        thrown(simulator.advance(0.0, 1.0).unwrap_err())[0].0,
        "bad_state"
    );
}
