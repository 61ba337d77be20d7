mod broken;

use super::*;
use assur::mixer::Case;
use assur::motion::InputRate;
use serde_json::json;

use crate::{Against, Axes, MixerDocument, MixerTracerDocument, Only, SpeedUnit, WheelDocument};

fn state() -> State {
    State {
        format: FORMAT,
        document: Document::Mixer(MixerDocument::new(&Case::A.dimensions())),
        view: View {
            phi_deg: 62.0,
            playing: true,
            vectors: true,
            transmission: true,
            groups: true,
            centrodes: true,
            about: "coupler".to_owned(),
            relative_to: "rocker".to_owned(),
            measures: vec!["A-C.distance".to_owned()],
            plot: "C2".to_owned(),
            against: Some(Against {
                x: "input".to_owned(),
                y: "C.dy".to_owned(),
            }),
            only: Only::First,
            axes: Axes::Physical,
            omega: -2.5,
            omega_unit: SpeedUnit::PerMin,
            epsilon: 0.5,
            true_time: true,
            differenced: true,
            lesson: Some(lesson()),
            projector: true,
            lang: "en".to_owned(),
            ..View::default()
        },
        lesson: None,
        compared: None,
        picture: None,
    }
}

fn lesson() -> OpenLesson {
    OpenLesson {
        id: "mixer".to_owned(),
        step: 3,
    }
}

/// A state as the first version wrote it.
fn first(state: &State) -> serde_json::Value {
    let mut value = serde_json::to_value(state).unwrap();
    let parts = value.as_object_mut().unwrap();
    parts["format"] = json!(1);
    let kind = parts.remove("kind").unwrap();
    parts.insert("lesson".to_owned(), kind);
    let view = parts["view"].as_object_mut().unwrap();
    view.remove("s");
    let lesson = view.remove("lesson");
    let step = lesson.map_or(json!(0), |lesson| lesson["step"].clone());
    view.insert("step".to_owned(), step);
    value
}

#[test]
fn round_trip() {
    let text = serde_json::to_string(&state()).unwrap();
    assert_eq!(State::parse(&text).unwrap(), state());
    assert_eq!(state().check(), Ok(()));
    let Moved {
        motion, plotted, ..
    } = state().moved().unwrap();
    let names: Vec<String> = plotted
        .iter()
        .map(|one| one.name(motion.mechanism(), 0))
        .collect();
    assert_eq!(names, ["C2.x", "C2.y"]);
}

#[test]
fn plots_and_inputs_are_checked() {
    for (key, value, problem) in [
        ("plot", json!("C4"), "unknown_choice plot"),
        ("plot", json!(""), "unknown_choice plot"),
        ("omega", json!(1.1e4), "out_of_range omega"),
        ("omega", json!(-1.1e4), "out_of_range omega"),
        ("omega", json!(0.0), "at_rest omega"),
        ("epsilon", json!(1e7), "out_of_range epsilon"),
    ] {
        let mut bad = serde_json::to_value(state()).unwrap();
        bad["view"][key] = value;
        let problems = State::parse(&bad.to_string()).unwrap().moved().unwrap_err();
        let problems = serde_json::to_value(problems).unwrap();
        let found = [&problems[0]["code"], &problems[0]["field"]];
        let found = found.map(|text| text.as_str().unwrap()).join(" ");
        assert_eq!(found, problem, "{problems}");
    }
    for (key, value) in [
        ("axes", json!("log")),
        ("omega_unit", json!("km_per_h")),
        ("true_time", json!(1)),
    ] {
        let mut bad = serde_json::to_value(state()).unwrap();
        bad["view"][key] = value;
        assert!(State::parse(&bad.to_string()).is_err(), "{key}");
    }
}

#[test]
fn axes_say_what_derivatives_are_by() {
    let mut view = state().view;
    let input = InputRate {
        speed: -2.5,
        acceleration: 0.5,
    };
    assert_eq!(view.input(), input);
    view.axes = Axes::Analogues;
    assert_eq!(view.input(), InputRate::ANALOGUES);
}

#[test]
fn another_lesson_has_another_document() {
    let mut value = serde_json::to_value(state()).unwrap();
    value["kind"] = json!("linkage");
    let path = |value: &serde_json::Value| match State::parse(&value.to_string()) {
        Err(Problem::BadState { path, .. }) => path,
        other => panic!("{other:?}"),
    };
    assert!(path(&value).starts_with("document"));
    value["document"] = json!({
        "points": [{"name": "A", "at": [0, 0]}, {"name": "B", "at": [1, 0]}],
        "frame": ["A"],
        "links": [{"name": "crank", "points": ["A", "B"]}],
        "drivers": [{"crank": "crank"}],
    });
    let state = State::parse(&value.to_string()).unwrap();
    assert!(state.linkage().unwrap().mechanism().is_ok());
    assert_eq!(serde_json::to_value(&state).unwrap()["kind"], "linkage");
    // A file may omit the view.
    value.as_object_mut().unwrap().remove("view");
    let state = State::parse(&value.to_string()).unwrap();
    assert_eq!(
        (state.view.clone(), state.check()),
        (View::default(), Ok(()))
    );
    value["document"]["links"][0]["points"][1] = json!(2);
    assert_eq!(path(&value), "document.links[0].points[1]");
}

#[test]
fn the_first_version_is_read() {
    let old = first(&state());
    assert_eq!(State::parse(&old.to_string()).unwrap(), state());
    let mut closed = old.clone();
    closed["view"]["step"] = json!(0);
    assert_eq!(State::parse(&closed.to_string()).unwrap().view.lesson, None);
    let mut bad = old.clone();
    bad["lesson"] = json!("clock");
    for (value, at) in [(bad, "lesson"), (json!({"format": 1}), ".")] {
        match State::parse(&value.to_string()) {
            Err(Problem::BadState { path, .. }) => assert_eq!(path, at),
            other => panic!("{other:?}"),
        }
    }
    // In the first version, only the title identifies a linkage of the catalogue.
    let mut document = crate::from_catalogue("class4-dwell").unwrap().unwrap();
    document.origin = None;
    let mut linkage = state();
    linkage.document = Document::Linkage(document.clone());
    let read = State::parse(&first(&linkage).to_string()).unwrap();
    assert_eq!(read.document.origin(), Some("class4-dwell"));
    let id = "class4-dwell".to_owned();
    assert_eq!(read.view.lesson, Some(OpenLesson { id, step: 3 }));
    document.title = Some("Mine".to_owned());
    linkage.document = Document::Linkage(document);
    let read = State::parse(&first(&linkage).to_string()).unwrap();
    assert_eq!(read.document.origin(), None);
}

#[test]
fn a_lesson_has_the_name_of_a_folder() {
    for id in ["", "../mixer", "Mixer", "a/b", &"a".repeat(65)] {
        let mut bad = state();
        let id = id.to_owned();
        bad.view.lesson = Some(OpenLesson { id, step: 1 });
        let field = "lesson".into();
        assert_eq!(bad.check(), Err(vec![Problem::UnknownChoice { field }]));
    }
}

#[test]
fn an_unknown_version_is_said_first() {
    let format = Problem::UnknownFormat { format: 3.0 };
    let text = r#"{"format": 3, "kind": "mixer", "document": 7}"#;
    assert_eq!(State::parse(text), Err(format));
}

#[test]
fn older_views_say_less() {
    let mut older = first(&state());
    let view = older["view"].as_object_mut().unwrap();
    for added in [
        "centres",
        "vectors",
        "loop_vectors",
        "transmission",
        "plot",
        "measures",
        "against",
        "only",
        "axes",
        "omega",
        "omega_unit",
        "epsilon",
        "true_time",
        "differenced",
        "step",
        "projector",
    ] {
        assert!(view.remove(added).is_some(), "{added}");
    }
    let mut expected = state();
    expected.view = View {
        phi_deg: 62.0,
        playing: true,
        groups: true,
        centrodes: true,
        about: expected.view.about,
        relative_to: expected.view.relative_to,
        lang: expected.view.lang,
        ..View::default()
    };
    assert_eq!(State::parse(&older.to_string()).unwrap(), expected);
}

#[test]
fn one_wheel_of_old_is_a_list_of_one() {
    let mut older = serde_json::to_value(state()).unwrap();
    let document = older["document"].as_object_mut().unwrap();
    let wheels = document.remove("wheels").unwrap();
    assert!(document.remove("tracers").is_some());
    document.insert("z5".to_owned(), wheels[0]["z"].clone());
    let line = wheels[0]["centre_line_deg"].clone();
    document.insert("centre_line_deg".to_owned(), line);
    assert_eq!(State::parse(&older.to_string()).unwrap(), state());
    let text = serde_json::to_string(&State::parse(&older.to_string()).unwrap()).unwrap();
    assert!(!text.contains("z5") && text.contains("\"wheels\":[{\"z\":18.0,"));
    // The old form needs both `z5` and `centre_line_deg`.
    older["document"].as_object_mut().unwrap().remove("z5");
    assert!(
        matches!(State::parse(&older.to_string()), Err(Problem::BadState { path, .. }) if path == "document")
    );
}
