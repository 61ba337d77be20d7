//! Under load: plots, the table, a halt.

use super::*;

#[wasm_bindgen_test]
fn the_load_is_scaled_and_its_times_stay() {
    let (simulator, _) = opened("train-magnets", "angles", &json!({}));
    let set = |simulator: &Simulator, load: f64| {
        value(&simulator.set_dimension("load", load, 0.0).unwrap())
    };
    let change = set(&simulator, 16.0);
    assert_eq!(
        change["document"]["load"],
        json!([[1, 0], [3, 16], [4.5, 16], [5, 0]])
    );
    let nothing = set(&simulator, 0.0)["document"]["load"].clone();
    assert_eq!(nothing, json!([[1, 0], [3, 0], [4.5, 0], [5, 0]]));
    let (unloaded, summary) = opened("train-magnets", "angles", &json!({"load": nothing}));
    assert_eq!(summary["load"]["value"], 0.0);
    let again = set(&unloaded, 4.0);
    assert_eq!(
        again["document"]["load"],
        json!([[1, 0], [3, 4], [4.5, 4], [5, 0]])
    );
    let (none, _) = opened("train-magnets", "angles", &json!({"load": []}));
    let begun = set(&none, 4.0)["document"]["load"].clone();
    assert_eq!(begun.as_array().unwrap().len(), 4);
    let (_, summary) = opened(
        "train-magnets",
        "angles",
        &json!({"load": begun, "loaded": true}),
    );
    near(&summary["load"]["value"], 4.0);
    let backwards = json!({"load": [[0, -1], [10, -1]]});
    let (backwards, summary) = opened("train-magnets", "angles", &backwards);
    assert_eq!(summary["load"]["value"], 1.0);
    assert_eq!(
        set(&backwards, 2.0)["document"]["load"],
        json!([[0, -2], [10, -2]])
    );
    for (field, wrong, code) in [
        ("load", f64::NAN, "not_a_number"),
        ("load", -1.0, "out_of_range"),
        ("z1", 30.0, "bad_state"),
    ] {
        let thrown = value(&problems(
            &simulator.set_dimension(field, wrong, 0.0).unwrap_err(),
        ));
        assert_eq!(thrown[0]["code"], code);
    }
    assert!(simulator.drag("sun", 0.0, 1.0, 1.0).is_err());
    assert!(simulator.as_kind("scheme", 0.0).is_err());
}

#[wasm_bindgen_test]
fn a_strong_load_makes_meshes_slip() {
    let load =
        |torque: f64| json!({"loaded": true, "load": [[1, 0], [3, torque], [4.5, torque], [5, 0]]});
    let (_, summary) = opened("train-magnets", "load", &load(8.0));
    assert_eq!(
        (&summary["slips"], &summary["halt"]),
        (&json!([0, 0]), &Value::Null)
    );
    let (simulator, summary) = opened("train-magnets", "load", &load(26.0));
    let slips = summary["slips"].as_array().unwrap();
    assert!(
        slips.iter().any(|one| one.as_i64().unwrap().abs() > 5),
        "{slips:?}"
    );
    // The load angle grows with every slipped period.
    let mesh = if slips[0].as_i64().unwrap().abs() > 5 {
        0
    } else {
        1
    };
    let (name, plates) = [("sun", 20.0), ("ring", 43.0)][mesh];
    let angle = readout(&simulator, 6.0, &format!("{name}.load_angle"), 0);
    let periods = angle / (std::f64::consts::TAU / plates);
    assert!(
        (periods - number(&slips[mesh])).abs() < 0.5,
        "{periods} {slips:?}"
    );
    let imbalance =
        readout(&simulator, 6.0, "imbalance", 0) / readout(&simulator, 6.0, "driven", 0);
    assert!(imbalance.abs() < 1e-6, "{imbalance}");
}

/// A run that halts at its start can be shown.
#[wasm_bindgen_test]
fn a_run_that_halts_at_once_is_shown() {
    let load = json!({"loaded": true, "load": [[0, -1e9]], "bodies": {"damping": [0, 0, 0, 0]}});
    let (simulator, summary) = opened("train-magnets", "load", &load);
    assert_eq!(summary["cycle"]["end"], 0);
    assert_eq!(summary["halt"]["time"], 0);
    assert_eq!(simulator.advance(0.0, 0.1).unwrap(), [0.0, 1.0]);
    lists(&simulator, 3.0);
    chart(&simulator, 0.0);
}

fn chart(simulator: &Simulator, around: f64) -> Value {
    let document = web_sys::window().unwrap().document().unwrap();
    let canvas: HtmlCanvasElement = document.create_element("canvas").unwrap().unchecked_into();
    let context: CanvasRenderingContext2d =
        canvas.get_context("2d").unwrap().unwrap().unchecked_into();
    let request =
        js(&json!({"width": 400, "height": 600, "palette": vec![[0, 0, 0]; role_names().len()]}));
    js_sys::Reflect::set(&request, &"around".into(), &around.into()).unwrap();
    value(&simulator.chart(&context, request).unwrap())
}

#[wasm_bindgen_test]
fn plots_go_on_around_a_time() {
    let (simulator, _) = opened("train-magnets", "angles", &json!({}));
    for (around, start) in [
        (0.0, 0.0),
        (5.9, 0.0),
        (6.1, 6.0),
        (6000.5, 6000.0),
        (-3.0, 0.0),
        (f64::NAN, 0.0),
        (f64::INFINITY, 999_996.0),
    ] {
        let chart = chart(&simulator, around);
        let panels = chart["panels"].as_array().unwrap();
        assert_eq!(panels.len(), 3);
        for panel in panels {
            let axis = [&panel["x0"], &panel["x1"]].map(number);
            assert_eq!(axis, [start, start + 6.0], "{around}");
            assert_eq!(panel["series"].as_array().unwrap().len(), 4);
        }
    }
    let (run, _) = opened(
        "train-magnets",
        "load",
        &json!({"loaded": true, "span_s": 2}),
    );
    for around in [0.0, 100.0] {
        let panel = &chart(&run, around)["panels"][0];
        assert_eq!((&panel["x0"], &panel["x1"]), (&json!(0), &json!(2)));
        assert_eq!(panel["series"].as_array().unwrap().len(), 2);
    }
}

#[wasm_bindgen_test]
fn the_table_has_a_row_for_every_step() {
    for loaded in [false, true] {
        let (simulator, _) = opened(
            "train-magnets",
            "angles",
            &json!({"loaded": loaded, "span_s": 1}),
        );
        let table = value(&simulator.sweep(8).unwrap());
        let column = |(quantity, order): &(String, usize)| match quantity.split_once('.') {
            Some((of, what)) => format!("{of}.{}{what}", "d".repeat(*order)),
            None => quantity.clone(),
        };
        let columns: Vec<Value> = readouts(&simulator)[1..]
            .iter()
            .map(|id| json!({"name": column(id), "quantity": null}))
            .collect();
        assert_eq!(table["columns"], json!(columns));
        let rows = table["rows"].as_array().unwrap();
        assert_eq!(rows.len(), 9);
        for (step, row) in rows.iter().enumerate() {
            let time = step as f64 / 8.0;
            assert_eq!(
                (number(&row["input"]), &row["reason"]),
                (time, &Value::Null)
            );
            let values: Vec<f64> = row["values"]
                .as_array()
                .unwrap()
                .iter()
                .map(number)
                .collect();
            let expected = &lists(&simulator, time)[2][1..];
            assert_eq!(values.len(), expected.len());
            // The last digit of a number may change in the conversion through JSON.
            for (value, expected) in values.iter().zip(expected) {
                let off = (value - expected).abs();
                assert!(off <= 1e-15 * expected.abs(), "{value} {expected}");
            }
        }
    }
}

/// Prints how long runs take, without asserting it.
#[wasm_bindgen_test]
fn how_long_it_takes() {
    let now = || web_sys::window().unwrap().performance().unwrap().now();
    for (what, loaded, torque) in [
        ("nothing slips", false, 8.0),
        ("synchronous run", true, 8.0),
        ("slipping run", true, 26.0),
    ] {
        let mut document = known("train-magnets");
        document["loaded"] = json!(loaded);
        document["load"] = json!([[1, 0], [3, torque], [4.5, torque], [5, 0]]);
        let state = state(&document, "angles");
        let mut simulator = Simulator::new();
        let start = now();
        for _ in 0..5 {
            simulator.set(state.clone()).unwrap();
        }
        let set = (now() - start) / 5.0;
        let start = now();
        for step in 0..1000 {
            simulator.at(f64::from(step) * 0.006).unwrap();
        }
        let at = (now() - start) / 1000.0;
        console_log!("time: {what}: set {set:.1} ms, at {at:.4} ms");
    }
}
