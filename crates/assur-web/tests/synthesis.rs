//! A synthesis through the interface in a real browser: its summary, dragged directions, chosen members of a family.

use assur_web::Simulator;
use js_sys::JSON;
use serde_json::Value;
use wasm_bindgen::JsValue;
use wasm_bindgen_test::wasm_bindgen_test;

use crate::problems;

const EXAMPLE: &str = r#"[{"output_deg":240,"input_deg":45},{"output_deg":253,"input_deg":60}]"#;

/// Returns the state of a synthesis with a frame of 10.4; `positions` and `more` are JSON.
fn state(positions: &str, more: &str) -> JsValue {
    let text = format!(
        r#"{{"format":2,"kind":"synthesis","document":{{"frame":10.4,"positions":{positions}{more}}},
        "view":{{"phi_deg":45,"playing":false,"direction":1,"speed":1,"traces":true,"lang":"en"}}}}"#
    );
    JSON::parse(&text).unwrap()
}

fn value(value: &JsValue) -> Value {
    let text: String = JSON::stringify(value).unwrap().into();
    serde_json::from_str(&text).unwrap()
}

fn near(found: &Value, exact: f64, within: f64) {
    let found = found.as_f64().unwrap();
    assert!((found - exact).abs() < within, "{found} {exact}");
}

#[wasm_bindgen_test]
fn a_family_is_said_and_chosen_from() {
    let mut simulator = Simulator::new();
    let summary = value(&simulator.set(state(EXAMPLE, r#","member":[5,5]"#)).unwrap());
    assert_eq!(
        (&summary["moves"], &summary["input"]),
        (&"angle".into(), &"3".into())
    );
    assert_eq!(
        (&summary["from"], &summary["number"]),
        (&"family".into(), &Value::Null)
    );
    near(&summary["drawn"]["lengths"][0], 9.31217191060936, 1e-10);
    near(
        &summary["wanted"][0]["coupler"],
        4.4024803443332_f64.to_radians(),
        1e-10,
    );
    let curve = &summary["family"]["curve"];
    let lengths = ["l2", "l3", "verdicts"].map(|key| curve[key].as_array().unwrap().len());
    assert!(
        lengths[0] > 200 && lengths == [lengths[0]; 3],
        "{lengths:?}"
    );
    // A member of the same family with l₂ = 6. No member has an l₂ beyond the end of the family.
    let change = value(&simulator.set_dimension("output", 6.0, 0.0).unwrap());
    near(&change["document"]["member"][1], 6.1600075360616, 1e-10);
    let refused = value(&problems(
        &simulator.set_dimension("output", 300.0, 0.0).unwrap_err(),
    ));
    assert_eq!(refused[0]["code"], "out_of_range");
    near(
        &refused[0]["max"],
        summary["family"]["lengths"][1][1].as_f64().unwrap(),
        1e-9,
    );
    assert!(simulator.set_dimension("input", 6.0, 0.0).is_err());
}

#[wasm_bindgen_test]
fn directions_are_dragged() {
    let mut simulator = Simulator::new();
    let summary = value(&simulator.set(state(EXAMPLE, "")).unwrap());
    let handles = summary["handles"].as_array().unwrap();
    let names: Vec<&str> = handles
        .iter()
        .map(|one| one["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, ["B", "input1", "output1", "input2", "output2"]);
    let positions = |point: &str, x: f64, y: f64| {
        let change = value(&simulator.drag(point, 0.785, x, y).unwrap());
        change["document"]["positions"].clone()
    };
    // The input angle is the direction from A to the dragged place; the output angle is that from the place to D =
    // (10.4, 0).
    near(&positions("input2", -3.0, 3.0)[1]["input_deg"], 135.0, 1e-9);
    near(
        &positions("output1", 10.4, 7.0)[0]["output_deg"],
        270.0,
        1e-9,
    );
    let crank = value(&simulator.drag("B", 0.785, 0.0, 5.0).unwrap());
    near(&crank["input"], std::f64::consts::FRAC_PI_2, 1e-9);
    for (point, x) in [("input3", 1.0), ("C", 1.0), ("input1", f64::NAN)] {
        assert!(simulator.drag(point, 0.785, x, 1.0).is_err(), "{point}");
    }
}

/// A given coupler angle has a handle. Trial lengths are drawn unchanged, and both positions have the formulas of the
/// paper.
#[wasm_bindgen_test]
fn coupler_angles_and_trial_lengths() {
    let mut simulator = Simulator::new();
    let given = r#"[{"output_deg":240,"input_deg":45,"coupler_deg":10},{"output_deg":253,"input_deg":60,"coupler_deg":9}]"#;
    let summary = value(&simulator.set(state(given, r#","trial":[10,5,4]"#)).unwrap());
    assert_eq!(summary["from"], "trial");
    // ΣJ is dimensionless: l₀²ΣJ is 0.1663 and 0.0361.
    near(
        &summary["printed"]["drawn"],
        0.1663 / 10.4_f64.powi(2),
        1e-6,
    );
    near(
        &summary["printed"]["least"],
        0.0361 / 10.4_f64.powi(2),
        1e-6,
    );
    let handles = summary["handles"].as_array().unwrap();
    assert!(handles.iter().any(|one| one["name"] == "coupler2"));
    let [x, y] = [4.0 / 2.0_f64.sqrt(); 2];
    let change = value(&simulator.drag("coupler1", 0.785, x, y + 5.0).unwrap());
    near(
        &change["document"]["positions"][0]["coupler_deg"],
        90.0,
        1e-9,
    );
    let relations = value(&simulator.relations(0.785).unwrap());
    let open = relations.as_array().unwrap().iter();
    let open: Vec<&Value> = open.filter(|one| one["item"] == "000.ex.lengths").collect();
    assert_eq!(open.len(), 2);
    near(&open[0]["value"], 0.3241, 5e-5);
    near(&open[1]["value"], 0.2474, 5e-5);
    let wrong = simulator.set(state(given, r#","trial":[10,-5,4]"#));
    let wrong = value(&problems(&wrong.unwrap_err()));
    assert_eq!(
        (&wrong[0]["code"], &wrong[0]["field"]),
        (&"not_positive".into(), &"trial[1]".into())
    );
}

/// A change that is impossible throws its problem, and the document shown before stays.
#[wasm_bindgen_test]
fn what_cannot_be_changes_nothing() {
    let mut simulator = Simulator::new();
    simulator.set(state(EXAMPLE, "")).unwrap();
    let scene = simulator.scene().unwrap();
    let apart = r#"[{"output_deg":90,"input_deg":120},{"output_deg":60,"input_deg":100}]"#;
    let refused = value(&problems(&simulator.set(state(apart, "")).unwrap_err()));
    assert_eq!(refused[0]["code"], "no_family");
    assert_eq!(simulator.scene().unwrap(), scene);
}

#[wasm_bindgen_test]
fn many_positions_are_searched() {
    let positions =
        "[[269,30],[269,60],[284,90],[300,120],[311,150],[321,180],[330,210],[326,240]]";
    let given: Vec<[f64; 2]> = serde_json::from_str(positions).unwrap();
    let given = given
        .iter()
        .map(|[output, input]| format!(r#"{{"output_deg":{output},"input_deg":{input}}}"#));
    let given = format!("[{}]", given.collect::<Vec<String>>().join(","));
    let mut simulator = Simulator::new();
    let summary = value(&simulator.set(state(&given, "")).unwrap());
    assert_eq!(summary["from"], "found");
    let solutions = summary["solutions"].as_array().unwrap();
    let sums: Vec<f64> = solutions
        .iter()
        .map(|one| one["sum"].as_f64().unwrap())
        .collect();
    assert!(sums.len() > 1 && sums.is_sorted(), "{sums:?}");
    let number = summary["number"].as_u64().unwrap() as usize;
    assert_eq!(solutions[number - 1]["at_bound"], false);
    // Solutions are sorted by output error, those at a bound last.
    let shown = summary["shown"].as_array().unwrap();
    let shown: Vec<usize> = shown
        .iter()
        .map(|one| one.as_u64().unwrap() as usize)
        .collect();
    assert_eq!(shown[0], number);
    let key = |number: &usize| {
        let one = &solutions[number - 1];
        let error = one["output_error"].as_f64().unwrap_or(f64::INFINITY);
        (one["at_bound"].as_bool().unwrap(), error)
    };
    let keys: Vec<(bool, f64)> = shown.iter().map(key).collect();
    assert!(keys.len() == sums.len() && keys.is_sorted(), "{keys:?}");
    assert_eq!(summary["turned"], false);
    assert_eq!(
        solutions[number - 1]["lengths"],
        summary["drawn"]["lengths"]
    );
    assert_eq!(
        summary["found"]["sum"]["values"].as_array().unwrap().len(),
        40
    );
}
