//! The saved form of a path: default fields, the linkage that is shown, refusals.

use assur::synthesis::approximation::Tracing;
use assur_file::{Document, Kind, PathDocument, State, TracingDocument, document};
use serde_json::{Value, json};

/// A saved path of five points, with additional fields.
fn five(more: &Value) -> Value {
    let mut document = json!({"path": [[0, 0], [1, 0.4], [1.6, 1.2], [1.2, 2.1], [0.2, 2.2]]});
    for (key, value) in more.as_object().unwrap() {
        document[key] = value.clone();
    }
    document
}

fn read(document: Value) -> PathDocument {
    serde_json::from_value(document).unwrap()
}

/// Returns the problems of a document: codes with parameters.
fn refused(document: Value) -> Vec<Value> {
    let problems = read(document).linkage().unwrap_err();
    let said = problems.iter().map(serde_json::to_value);
    said.map(Result::unwrap).collect()
}

const FOUR_BAR: [[f64; 2]; 5] = [[0.0, 0.0], [5.0, 0.0], [0.0, 2.0], [3.0, 4.0], [1.0, 5.0]];

fn four_bar() -> Value {
    let [a, d, b, c, p] = FOUR_BAR;
    json!({"four_bar": {"pivots": [a, d], "joints": [b, c], "point": p}})
}

#[test]
fn without_a_linkage_a_short_search_finds_one() {
    let document = read(five(&json!({})));
    let found = document.task().unwrap();
    assert!(matches!(found.shown, Some(Tracing::FourBar(_))));
    let linkage = document.linkage().unwrap();
    assert_eq!(linkage.traces, ["P"]);
    assert_eq!(document.linkage().unwrap(), linkage, "not the same again");
}

#[test]
fn a_given_linkage_is_shown_as_it_is_given() {
    let document = read(five(&json!({ "linkage": four_bar() })));
    let shown = document.task().unwrap().shown.unwrap();
    assert_eq!(TracingDocument::from(&shown), document.linkage.unwrap());
    let linkage = document.linkage().unwrap();
    for (name, at) in ["A", "D", "B", "C", "P"].into_iter().zip(FOUR_BAR) {
        let mut points = linkage.points.iter();
        assert_eq!(points.find(|point| point.name == name).unwrap().at, at);
    }
    let state = json!({"format": 2, "kind": "point-path", "document": five(&json!({"linkage": four_bar(), "course": "closed"}))});
    let state = State::read(&state).unwrap();
    assert!(matches!(&state.document, Document::Path(_)));
    let again = State::read(&serde_json::to_value(&state).unwrap()).unwrap();
    assert_eq!(again, state);
}

#[test]
fn what_is_wrong_is_named() {
    let codes = |document| {
        let problems = refused(document);
        let code = |problem: &Value| problem["code"].as_str().unwrap().to_owned();
        problems.iter().map(code).collect::<Vec<_>>()
    };
    assert_eq!(codes(json!({"path": [[0, 0], [1, 1]]})), ["out_of_range"]);
    let equal = json!({"path": [[0, 0], [1, 1], [0, 0], [1, 1]]});
    assert_eq!(
        refused(equal),
        [json!({"code": "too_few_points", "distinct": 2})]
    );
    let far = json!({"path": [[0, 0], [1, 2e9], [2, 1]]});
    assert_eq!(refused(far)[0]["field"], "path[1].y");
    let short = json!({"four_bar": {"pivots": [[0, 0], [9, 0]], "joints": [[0, 0], [1, 1]], "point": [0, 0]}});
    let problems = refused(five(&json!({ "linkage": short })));
    assert!(!problems.is_empty());
    let none = json!({"slider_crank": {"pivot": [0, 0], "joints": [[0, 1], [3, 0]], "guide": [0, 0], "point": [1, 1]}});
    assert_eq!(
        codes(five(&json!({ "linkage": none }))),
        ["no_slider_crank"]
    );
    let four = five(&json!({"angles_deg": [0, 10, 20, 30]}));
    assert_eq!(
        refused(four),
        [json!({"code": "angles_of_points", "angles": 4, "points": 5})]
    );
    let angles = [0, 10, 20, 30, 40];
    let curve = five(&json!({"angles_deg": angles, "course": "open"}));
    assert_eq!(codes(curve), ["angles_of_curve"]);
    let misspelt = five(&json!({"cours": "open"}));
    let misspelt = State::read(&json!({"format": 2, "kind": "point-path", "document": misspelt}));
    assert!(misspelt.is_err());
}

/// Three points with crank angles leave a family of linkages, so they are met exactly. Points in line with crank angles
/// are not a special path.
#[test]
fn points_at_crank_angles_are_met() {
    let document = read(json!({"path": [[0, 0], [2, 0.3], [3, -0.4]], "angles_deg": [0, 40, 100]}));
    let motion = document.motion().unwrap();
    let found = document.task().unwrap();
    let traced =
        assur::synthesis::approximation::Traced::new(&found.shown.unwrap(), &motion, &found.target);
    let traced = traced.unwrap();
    assert!(traced.deviation.greatest < 1e-8, "{:?}", traced.deviation);
    let [first, second] = [0, 1].map(|k| traced.inputs[k].unwrap());
    let step = (second - first).rem_euclid(std::f64::consts::TAU);
    let step = step.min(std::f64::consts::TAU - step).to_degrees();
    assert!((step - 40.0).abs() < 1e-9, "{step}");
    let line = read(json!({"path": [[0, 0], [1, 1], [3, 3]], "angles_deg": [0, 40, 100]}));
    assert_eq!(line.task().unwrap().target.special(), None);
}

/// A slide passes through points in line, and a crank passes through points on a circle.
#[test]
fn special_paths_have_exact_linkages() {
    for points in [
        json!([[0, 0], [1, 1], [2, 2], [3.5, 3.5]]),
        json!([[1, 0], [0, 1], [-1, 0], [0, -1]]),
    ] {
        let document = read(json!({ "path": points }));
        let motion = document.motion().unwrap();
        let found = document.task().unwrap();
        let traced = assur::synthesis::approximation::Traced::new(
            &found.shown.unwrap(),
            &motion,
            &found.target,
        );
        let greatest = traced.unwrap().deviation.greatest;
        assert!(greatest < 1e-9, "{points}: {greatest}");
    }
}

#[test]
fn the_catalogue_has_paths() {
    for name in ["path-nine", "path-drawn"] {
        let document = document(name).unwrap().unwrap();
        assert!(document.linkage().is_ok());
    }
}
