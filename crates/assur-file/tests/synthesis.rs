//! The saved form of a synthesis: default fields, the linkage that is shown, refusals.

use assur_file::{Document, FunctionDocument, Kind, State, SynthesisDocument};
use serde_json::{Value, json};

/// The example of the paper, with additional fields.
fn document(more: &Value) -> Value {
    let mut document = json!({
        "frame": 10.4,
        "positions": [{"output_deg": 240, "input_deg": 45}, {"output_deg": 253, "input_deg": 60}],
    });
    for (key, value) in more.as_object().unwrap() {
        document[key] = value.clone();
    }
    document
}

fn read(more: &Value) -> SynthesisDocument {
    serde_json::from_value(document(more)).unwrap()
}

/// Returns the problems of a document: codes with parameters.
fn refused(more: &Value) -> Vec<Value> {
    let problems = read(more).linkage().unwrap_err();
    let said = problems.iter().map(serde_json::to_value);
    said.map(Result::unwrap).collect()
}

fn lengths(more: &Value) -> [f64; 3] {
    let solved = read(more).synthesis().unwrap();
    let [l3, l1, l2, _] = solved.shown.proportions.lengths(10.4);
    [l1, l2, l3]
}

#[test]
fn what_is_left_out_is_usual() {
    let read = read(&json!({}));
    assert_eq!(
        (read.phi0_deg, read.free, read.member, read.trial),
        (0.0, false, None, None)
    );
    assert!(read.positions.iter().all(|position| position.weight == 1.0));
    let state = json!({"format": 2, "kind": "synthesis", "document": document(&json!({}))});
    let state = State::read(&state).unwrap();
    assert!(matches!(&state.document, Document::Synthesis(document) if *document == read));
    let again = State::read(&serde_json::to_value(&state).unwrap()).unwrap();
    assert_eq!(again, state);
    let misspelt = State::read(&json!({
        "format": 2, "kind": "synthesis", "document": document(&json!({"fre": true})),
    }));
    assert!(misspelt.is_err());
}

/// The member of the family with l₂ = 5 has l₁ = 9.31217191060936 and l₃ = 5.11281237799864.
#[test]
fn a_member_is_meant_by_its_output() {
    let [l1, l2, l3] = lengths(&json!({"member": [5, 1]}));
    for (found, exact) in [(l1, 9.31217191060936), (l2, 5.0), (l3, 5.11281237799864)] {
        assert!((found - exact).abs() < 1e-10, "{found} {exact}");
    }
    // A short l₂ still belongs to the family. For an l₂ beyond the family, the last member searched is shown.
    assert_eq!(lengths(&json!({"member": [1e-3, 1]}))[1], 1e-3);
    let [l1, l2, l3] = lengths(&json!({"member": [1e5, 1]}));
    assert!(
        l1 > 10.0 && l2 > 50.0 && (100.0..=104.0).contains(&l3),
        "{l1} {l2} {l3}"
    );
    assert_eq!(lengths(&json!({"trial": [10, 5, 4]})), [10.0, 5.0, 4.0]);
}

/// The rocker's angle is φ₂ in the drawing, and φ₂ + 180° in the linkage for the simulator.
#[test]
fn angles_are_those_of_the_paper() {
    let solved = read(&json!({"member": [5, 5]})).synthesis().unwrap();
    for (document, expected) in [(solved.drawn(), 240.0), (solved.linkage(), 60.0)] {
        let document = document.unwrap();
        let rocker = document
            .links
            .iter()
            .find(|link| link.name == "rocker")
            .unwrap();
        let at = |index: usize| {
            let name = &rocker.points[index];
            document
                .points
                .iter()
                .find(|point| point.name == *name)
                .unwrap()
                .at
        };
        let [from, to] = [at(0), at(1)];
        let angle = (to[1] - from[1]).atan2(to[0] - from[0]).to_degrees();
        let off = (angle - expected).rem_euclid(360.0);
        assert!(off.min(360.0 - off) < 1e-9, "{angle} {expected}");
    }
}

#[test]
fn what_is_wrong_is_named() {
    let position = |output: f64, input: f64| json!({"output_deg": output, "input_deg": input});
    let codes = |more: &Value| -> Vec<Value> {
        refused(more)
            .iter()
            .map(|said| said["code"].clone())
            .collect()
    };
    assert_eq!(
        refused(&json!({"frame": 0})),
        [json!({"code": "not_positive", "field": "frame", "value": 0.0})]
    );
    assert_eq!(codes(&json!({"frame": 1e12})), ["out_of_range"]);
    let twice = json!({"positions": [position(240.0, 45.0), position(600.0, -315.0)]});
    assert_eq!(
        refused(&twice),
        [json!({"code": "equal_positions", "one": 1, "other": 2})]
    );
    let one = json!({"positions": [position(240.0, 45.0)]});
    assert_eq!(
        refused(&one),
        [json!({"code": "too_few_positions", "least": 2, "count": 1})]
    );
    assert_eq!(codes(&json!({"free": true})), ["too_few_positions"]);
    let many: Vec<Value> = (0..65)
        .map(|k| position(f64::from(k), f64::from(2 * k)))
        .collect();
    assert_eq!(codes(&json!({"positions": many})), ["too_many_positions"]);
    let apart = json!({"positions": [position(90.0, 120.0), position(60.0, 100.0)]});
    let said = refused(&apart);
    assert_eq!(said[0]["code"], "no_family");
    let [output, input, right] =
        ["output", "input", "right"].map(|key| said[0][key].as_f64().unwrap());
    assert!(output < 0.0 && input < 0.0 && right > 0.0, "{said:?}");
    let weighed = json!({"positions": [
        {"output_deg": 240, "input_deg": 45, "weight": -1}, position(253.0, 60.0),
    ]});
    assert_eq!(refused(&weighed)[0]["field"], "positions[0].weight");
    assert_eq!(codes(&json!({"member": [-1, 1]})), ["not_a_number"]);
    assert_eq!(codes(&json!({"trial": [100, 1, 1]})), ["too_long"]);
}

/// A saved function log₁₀ x from 1 to 2, over 60° of both links.
fn function(of: &Value) -> Value {
    json!({"of": of, "x": [1, 2], "input_deg": [90, 150], "output_deg": [210, 270]})
}

fn wanted(of: &Value) -> FunctionDocument {
    serde_json::from_value(function(of)).unwrap()
}

/// A function yields positions with Chebyshev spacing or in even steps. The document keeps the function, and is refused
/// if the function is invalid.
#[test]
fn functions_give_positions() {
    let log = wanted(&json!("log10"));
    let half = 3.0_f64.sqrt() / 4.0;
    for (count, even, places) in [
        (3, false, vec![1.5 - half, 1.5, 1.5 + half]),
        (5, true, vec![1.0, 1.25, 1.5, 1.75, 2.0]),
    ] {
        let positions = log.positions(count, even).unwrap();
        assert_eq!(positions.len(), count);
        for (position, x) in positions.iter().zip(places) {
            assert!((position.input_deg - (30.0 + 60.0 * x)).abs() < 1e-12);
            let output = 210.0 + 60.0 * x.log10() / 2_f64.log10();
            assert!((position.output_deg - output).abs() < 1e-12);
        }
    }
    let more = json!({"positions": log.positions(3, false).unwrap(), "function": log});
    let kept = read(&more);
    let written = serde_json::to_value(&kept).unwrap();
    assert_eq!(written["function"]["of"], "log10");
    assert_eq!(
        serde_json::from_value::<SynthesisDocument>(written).unwrap(),
        kept
    );
    assert!(serde_json::to_value(read(&json!({}))).unwrap()["function"].is_null());
    let solved = kept.synthesis().unwrap();
    let curve = log.wanted().unwrap();
    let curve = curve.error_curve(&solved.task, &solved.shown).unwrap();
    let greatest = curve.greatest.unwrap();
    assert!(curve.complete && (greatest.x - 2.0).abs() < 1e-9);
    assert!((greatest.error().unwrap() + 0.000521470237586174).abs() < 1e-12);
    let values = |of: &Value, degrees: f64| {
        let positions = wanted(of).positions(3, true).unwrap();
        assert!((positions[1].output_deg - degrees).abs() < 1e-9, "{of}");
    };
    values(&json!({"power": 2}), 210.0 + 60.0 * 1.25 / 3.0);
    values(&json!({"table": [[0, 1], [1, 3], [2, 4]]}), 240.0);
    values(&json!("exp"), 210.0 + 60.0 / (1.0 + 0.5_f64.exp()));
    let sin = |degrees: f64| degrees.to_radians().sin();
    let share = (sin(1.5) - sin(1.0)) / (sin(2.0) - sin(1.0));
    values(&json!("sin"), 210.0 + 60.0 * share);
}

#[test]
fn what_is_wrong_with_a_function_is_named() {
    let refused = |changed: &Value| {
        let mut function = function(&json!("log10"));
        for (key, value) in changed.as_object().unwrap() {
            function[key] = value.clone();
        }
        refused(&json!({ "function": function }))
    };
    let ends = |field: &str| json!({"code": "equal_ends", "field": field});
    assert_eq!(refused(&json!({"x": [2, 2]})), [ends("function.x")]);
    assert_eq!(
        refused(&json!({"input_deg": [5, 5], "output_deg": [5, 5]})),
        [ends("function.input_deg"), ends("function.output_deg")]
    );
    let none = |x: f64| [json!({"code": "no_value", "field": "function.x", "x": x})];
    assert_eq!(refused(&json!({"x": [-1, 2]})), none(-1.0));
    assert_eq!(refused(&json!({"x": [1, 0]})), none(0.0));
    assert_eq!(
        refused(&json!({"of": {"power": -1}, "x": [2, -1]})),
        none(0.0)
    );
    assert_eq!(refused(&json!({"of": "exp", "x": [0, 1000]})), none(1000.0));
    assert_eq!(
        refused(&json!({"of": {"power": 2}, "x": [-1, 1]})),
        [json!({"code": "equal_values", "field": "function.x"})]
    );
    assert_eq!(
        refused(&json!({"of": {"table": [[0, 1], [2, 1], [2, 3]]}})),
        [json!({"code": "bad_row", "field": "function.of", "row": 3})]
    );
    assert_eq!(
        refused(&json!({"of": {"table": []}})),
        [json!({"code": "too_few_rows", "field": "function.of"})]
    );
    let log = wanted(&json!("log10"));
    for (count, code) in [(1, "too_few_positions"), (65, "too_many_positions")] {
        let said = serde_json::to_value(log.positions(count, false).unwrap_err()).unwrap();
        assert_eq!(said[0]["code"], code);
    }
    let unknown = json!({"function": function(&json!("tan"))});
    assert!(serde_json::from_value::<SynthesisDocument>(document(&unknown)).is_err());
}
