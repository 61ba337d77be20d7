//! Comparison, broken forms, bad numbers.

use super::*;

/// The compared document may be of any kind. An error names the path of the malformed part.
#[test]
fn what_it_is_compared_with() {
    let alone = serde_json::to_value(state()).unwrap();
    assert!(alone.get("compared").is_none());
    let with = |compared: serde_json::Value| {
        let mut value = alone.clone();
        value["compared"] = compared;
        State::read(&value)
    };
    assert_eq!(with(json!(null)).unwrap(), state());
    let document = json!({ "kind": "mixer", "document": alone["document"] });
    let both = with(document.clone()).unwrap();
    assert_eq!(both.compared.as_ref(), Some(&state().document));
    assert_eq!(serde_json::to_value(&both).unwrap()["compared"], document);
    for (broken, path) in [
        (json!(7), "compared"),
        (json!({ "kind": "mixer" }), "compared"),
        (json!({ "document": {} }), "compared"),
        (
            json!({ "kind": "mixture", "document": {} }),
            "compared.kind",
        ),
        (
            json!({ "kind": "linkage", "document": { "points": 3 } }),
            "compared.document.points",
        ),
    ] {
        match with(broken) {
            Err(Problem::BadState { path: found, .. }) => assert_eq!(found, path),
            other => panic!("{path}: {other:?}"),
        }
    }
}

#[test]
fn broken_form_names_its_path() {
    let text = serde_json::to_string(&state()).unwrap();
    for (from, to, path) in [
        ("\"l2\":0.85", "\"l2\":\"long\"", "document.l2"),
        ("\"l2\":0.85", "\"l2\":null", "document.l2"),
        ("\"kind\":\"mixer\"", "\"kind\":\"mixture\"", "kind"),
        ("\"z4\":36.0,", "", "document"),
        ("\"z\":18.0", "\"z\":[]", "document.wheels[0].z"),
        ("\"tracers\":[]", "\"tracers\":[7]", "document.tracers[0]"),
        ("\"playing\":true", "\"playing\":1", "view.playing"),
        ("\"step\":3", "\"step\":-1", "view.lesson.step"),
        ("\"step\":3", "\"step\":1.5", "view.lesson.step"),
    ] {
        assert!(text.contains(from), "{from}");
        match State::parse(&text.replace(from, to)) {
            Err(Problem::BadState { path: found, .. }) => assert_eq!(found, path),
            other => panic!("{to}: {other:?}"),
        }
    }
}

#[test]
fn bad_numbers_name_their_fields() {
    let mut bad = state();
    (bad.format, bad.view.direction, bad.view.speed) = (3.0, 0.5, f64::NAN);
    bad.view.phi_deg = f64::INFINITY;
    let fields = [
        Problem::UnknownFormat { format: 3.0 },
        Problem::NotANumber {
            field: "phi_deg".into(),
        },
        Problem::UnknownChoice {
            field: "direction".into(),
        },
        Problem::NotANumber {
            field: "speed".into(),
        },
    ];
    assert_eq!(bad.check(), Err(fields.to_vec()));

    let mut document = MixerDocument::new(&Case::A.dimensions());
    (document.l1, document.l2, document.l3) = (f64::NAN, -0.85, 0.0);
    (document.l4, document.z4, document.module) = (1e300, 0.0, 0.0);
    (document.mesh, document.assembly) = ("worm".to_owned(), 3.0);
    let wheel = |z, centre_line_deg| WheelDocument { z, centre_line_deg };
    document.wheels = vec![wheel(18.0, 0.0), wheel(1.5, f64::NAN)];
    let tracer = |link: &str, x, y| MixerTracerDocument {
        link: link.to_owned(),
        x,
        y,
    };
    document.tracers = vec![
        tracer("frame", 0.0, 0.0),
        tracer("wheel6", 0.0, 1e300),
        tracer("wheel7", f64::NAN, 0.0),
    ];
    let problems = document.mixer().unwrap_err();
    let text = serde_json::to_value(&problems).unwrap();
    let named: Vec<(&str, &str)> = text
        .as_array()
        .unwrap()
        .iter()
        .map(|problem| {
            (
                problem["code"].as_str().unwrap(),
                problem["field"].as_str().unwrap(),
            )
        })
        .collect();
    assert_eq!(
        named,
        [
            ("unknown_choice", "mesh"),
            ("unknown_choice", "assembly"),
            ("unknown_choice", "tracers[0].link"),
            ("not_a_number", "l1"),
            ("not_positive", "l2"),
            ("not_positive", "l3"),
            ("out_of_range", "l4"),
            ("not_positive", "z4"),
            ("not_positive", "module"),
            ("not_whole", "wheels[1].z"),
            ("not_a_number", "wheels[1].centre_line_deg"),
            ("out_of_range", "tracers[1].y"),
            ("unknown_choice", "tracers[2].link"),
            ("not_a_number", "tracers[2].x"),
        ]
    );
}
