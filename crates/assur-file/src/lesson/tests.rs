use super::*;
use serde_json::json;

use crate::{NumberField, document};

/// A lesson with every kind of question. Only its first step has a document.
fn written() -> Value {
    json!({
        "title": "Crank-rocker",
        "author": "A. Lecturer",
        "steps": [
            {
                "title": "Angle", "text": "<img src=x onerror=alert(1)> *Look* at φ_3.", "formula": "W = 3n − 2p₁",
                "shows": {
                    "kind": "linkage",
                    "document": {
                        "points": [
                            { "name": "A", "at": [0.0, 0.0] }, { "name": "B", "at": [1.0, 0.0] },
                            { "name": "C", "at": [2.5, 2.0] }, { "name": "D", "at": [3.0, 0.0] }
                        ],
                        "frame": ["A", "D"],
                        "links": [
                            { "name": "crank", "points": ["A", "B"] }, { "name": "coupler", "points": ["B", "C"] },
                            { "name": "rocker", "points": ["D", "C"] }
                        ],
                        "drivers": [{ "crank": "crank" }]
                    },
                    "view": { "phi_deg": 30.0, "vectors": true },
                    "vary": [{ "field": "links[0].length", "from": 0.5, "to": 0.9, "step": 0.05 }]
                },
                "question": { "text": "φ₃?", "hint": "Read it.", "number": { "quantity": "rocker.angle", "at": 45.0, "within": 0.1 } }
            },
            { "title": "Class", "text": "", "question": { "text": "Which?", "choice": { "options": ["II", "III"], "answer": 0 } } },
            { "title": "Drag", "text": "", "question": { "text": "To 90°.", "reach": { "quantity": "input", "value": 90.0, "within": 1.0 } } },
            { "title": "Fixed", "text": "", "question": { "text": "g?", "number": { "value": 9.81, "unit": "m/s²", "within": 0.01 } } }
        ]
    })
}

fn read(lesson: &Value) -> Result<LessonDocument, Problem> {
    let state = json!({ "lesson": lesson });
    within(&state, "lesson").map(Option::unwrap)
}

/// The problems of the written lesson with one part replaced.
fn with(pointer: &str, value: Value) -> Result<(), Vec<Problem>> {
    let mut lesson = written();
    *lesson.pointer_mut(pointer).unwrap() = value;
    read(&lesson).map_err(|problem| vec![problem])?.check()
}

#[test]
fn it_is_written_as_it_was_read() {
    let lesson = read(&written()).unwrap();
    lesson.check().unwrap();
    assert_eq!(serde_json::to_value(&lesson).unwrap(), written());
    let shown: Vec<_> = lesson.shown().collect();
    assert_eq!(shown.len(), 1);
    assert_eq!((shown[0].0, shown[0].1.view.phi_deg), (1, 30.0));
    shown[0].1.moved().unwrap();
}

#[test]
fn texts_are_taken_as_they_are() {
    let lesson = read(&written()).unwrap();
    assert!(lesson.steps[0].text.starts_with("<img src=x onerror="));
}

#[test]
fn what_has_not_the_form_is_told_by_its_place() {
    for (pointer, value, place) in [
        ("/title", json!(7), "lesson.title"),
        ("/steps", json!({}), "lesson.steps"),
        ("/steps/1", json!("II"), "lesson.steps[1]"),
        ("/steps/1/text", json!(["a"]), "lesson.steps[1].text"),
        (
            "/steps/1/question",
            json!("Which?"),
            "lesson.steps[1].question",
        ),
        (
            "/steps/1/question/choice/answer",
            json!(-1),
            "lesson.steps[1].question.choice.answer",
        ),
        (
            "/steps/2/question/reach/value",
            json!("90"),
            "lesson.steps[2].question.reach.value",
        ),
        (
            "/steps/0/shows/kind",
            json!("poem"),
            "lesson.steps[0].shows",
        ),
        (
            "/steps/0/shows/document/links/0/points",
            json!(1),
            "lesson.steps[0].shows",
        ),
        (
            "/steps/0/shows/view/phi_deg",
            json!("x"),
            "lesson.steps[0].shows",
        ),
    ] {
        match &with(pointer, value).unwrap_err()[..] {
            [Problem::BadState { path, .. }] => assert_eq!(path, place),
            other => panic!("{pointer}: {other:?}"),
        }
    }
}

#[test]
fn a_key_that_is_not_known_is_refused() {
    for pointer in [
        "",
        "/steps/0",
        "/steps/0/shows",
        "/steps/0/shows/vary/0",
        "/steps/0/question",
        "/steps/0/question/number",
    ] {
        let mut lesson = written();
        lesson.pointer_mut(pointer).unwrap()["onclick"] = json!("alert(1)");
        match read(&lesson) {
            Err(Problem::BadState { detail, .. }) => {
                assert!(detail.contains("onclick"), "{detail}")
            }
            other => panic!("{pointer}: {other:?}"),
        }
    }
}

#[test]
fn numbers_and_texts_have_bounds() {
    let long = |count: usize| json!("ж".repeat(count));
    let steps = |count: usize| json!(vec![json!({ "title": "", "text": "" }); count]);
    for (pointer, good, bad, field) in [
        ("/title", long(200), long(201), "lesson.title"),
        ("/author", long(200), long(201), "lesson.author"),
        ("/steps", steps(40), steps(41), "lesson.steps"),
        ("/steps", steps(1), steps(0), "lesson.steps"),
        ("/steps/1/title", long(200), long(201), "lesson.step_title"),
        ("/steps/1/text", long(5000), long(5001), "lesson.text"),
        ("/steps/0/formula", long(1000), long(1001), "lesson.formula"),
        (
            "/steps/1/question/text",
            long(500),
            long(501),
            "lesson.question",
        ),
        (
            "/steps/0/question/hint",
            long(500),
            long(501),
            "lesson.hint",
        ),
        (
            "/steps/1/question/choice/options/0",
            long(500),
            long(501),
            "lesson.option",
        ),
        (
            "/steps/1/question/choice/options",
            json!(vec!["a"; 8]),
            json!(vec!["a"; 9]),
            "lesson.options",
        ),
        (
            "/steps/1/question/choice/options",
            json!(["a", "b"]),
            json!(["a"]),
            "lesson.options",
        ),
        (
            "/steps/1/question/choice/answer",
            json!(1),
            json!(2),
            "lesson.right",
        ),
        (
            "/steps/2/question/reach/within",
            json!(0.0),
            json!(-0.1),
            "lesson.within",
        ),
        (
            "/steps/2/question/reach/value",
            json!(-1e9),
            json!(2e9),
            "lesson.value",
        ),
        (
            "/steps/0/question/number/at",
            json!(720.0),
            json!(1e10),
            "lesson.at",
        ),
        (
            "/steps/0/shows/vary/0/to",
            json!(0.5),
            json!(0.4),
            "lesson.to",
        ),
        (
            "/steps/0/shows/vary/0/step",
            json!(1.0),
            json!(0.0),
            "lesson.step",
        ),
        (
            "/steps/0/shows/vary/0/step",
            json!(0.00005),
            json!(0.00003),
            "lesson.step",
        ),
    ] {
        assert_eq!(with(pointer, good), Ok(()), "{pointer}");
        let problems = with(pointer, bad).unwrap_err();
        let found = problems.iter().any(
            |problem| matches!(problem, Problem::OutOfRange { field: found, .. } if found == field),
        );
        assert!(found, "{pointer}: {problems:?}");
    }
}

#[test]
fn every_question_has_one_answer() {
    let said = |pointer: &str, value: Value| -> Vec<Problem> { with(pointer, value).unwrap_err() };
    let at = |step: usize, problem: LessonProblem| -> Vec<Problem> {
        in_step(step, vec![problem.into()])
    };
    let choice = json!({ "options": ["a", "b"], "answer": 0 });
    let number = json!({ "value": 1.0, "within": 0.0 });
    assert_eq!(
        said("/steps/1/question", json!({ "text": "?" })),
        at(2, LessonProblem::LessonQuestion)
    );
    assert_eq!(
        said(
            "/steps/1/question",
            json!({ "text": "?", "choice": choice, "number": number })
        ),
        at(2, LessonProblem::LessonQuestion)
    );
    for number in [
        json!({ "within": 1.0 }),
        json!({ "within": 1.0, "value": 1.0, "quantity": "input" }),
    ] {
        assert_eq!(
            said("/steps/3/question/number", number),
            at(4, LessonProblem::LessonAnswer)
        );
    }
    assert_eq!(
        said("/steps/0/shows", Value::Null),
        at(1, LessonProblem::LessonShowsNothing)
    );
}

#[test]
fn a_state_has_it_and_tells_what_is_wrong() {
    let mut state = json!({
        "format": 2, "kind": "linkage", "document": written()["steps"][0]["shows"]["document"], "lesson": written()
    });
    let read = State::read(&state).unwrap();
    read.check().unwrap();
    assert_eq!(serde_json::to_value(&read).unwrap()["lesson"], written());
    state["lesson"]["steps"] = json!([]);
    assert_eq!(State::read(&state).unwrap().check().unwrap_err().len(), 1);
    state["lesson"] = Value::Null;
    assert_eq!(State::read(&state).unwrap().lesson, None);
}

/// Checks a step that shows a document with one number varied.
fn varied(
    document: &Document,
    field: &str,
    [from, to, step]: [f64; 3],
) -> Result<(), Vec<Problem>> {
    let mut shows = serde_json::to_value(document).unwrap();
    shows["vary"] = json!([{ "field": field, "from": from, "to": to, "step": step }]);
    let lesson = json!({ "title": "", "steps": [{ "title": "", "text": "", "shows": shows }] });
    read(&lesson).map_err(|problem| vec![problem])?.check()
}

#[test]
fn every_number_of_a_rail_can_vary() {
    for (name, count, some) in [
        (
            "jansen",
            17,
            &[
                "links[0].length",
                "links[2].side[1][2]",
                "links[2].corner_deg[2]",
                "points[0].y",
            ][..],
        ),
        ("geared-five-bar", 8, &["links[0].length"]),
        (
            "slider-crank-offset",
            9,
            &["links[1].length", "slides[0].offset", "points[3].y"],
        ),
        (
            "mixer-a",
            8,
            &[
                "l1",
                "z4",
                "module",
                "wheels[0].z",
                "wheels[0].centre_line_deg",
            ],
        ),
        (
            "train-magnets",
            27,
            &[
                "z1",
                "satellites",
                "drives[1].rpm",
                "magnets.peak[0]",
                "bodies.inertia[3]",
            ],
        ),
    ] {
        let document = document(name).unwrap().unwrap();
        let numbers = document.numbers().unwrap();
        let fields: Vec<&str> = numbers.iter().map(|number| &*number.field).collect();
        assert_eq!(fields.len(), count, "{name}: {fields:?}");
        for field in some {
            assert!(fields.contains(field), "{name}: {field}");
        }
        for NumberField { field, value, .. } in &numbers {
            varied(&document, field, [*value, *value + 2.0, 1.0]).unwrap();
        }
    }
}

#[test]
fn what_varies_is_a_number_of_what_is_shown() {
    let mixer = document("mixer-a").unwrap().unwrap();
    for field in [
        "",
        "assembly",
        "mesh",
        "wheels",
        "wheels[1].z",
        "wheels[0]",
        "l1.x",
        "__proto__",
        "<b>",
    ] {
        let varies = LessonProblem::LessonVaries {
            name: field.to_owned(),
        };
        assert_eq!(
            varied(&mixer, field, [1.0, 2.0, 1.0]).unwrap_err(),
            in_step(1, vec![varies.into()])
        );
    }
    // Counts vary by whole numbers.
    for (range, field, value) in [
        ([18.5, 24.0, 1.0], "lesson.from", 18.5),
        ([18.0, 24.5, 1.0], "lesson.to", 24.5),
        ([18.0, 24.0, 0.5], "lesson.step", 0.5),
    ] {
        let whole = Problem::NotWhole {
            field: field.into(),
            value,
        };
        assert_eq!(
            varied(&mixer, "wheels[0].z", range).unwrap_err(),
            in_step(1, vec![whole])
        );
        varied(&mixer, "l1", range).unwrap();
    }
}
