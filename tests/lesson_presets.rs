//! Presets that belong to a lesson: the engine accepts them as documents, and they contain the subject of the lesson.

use std::fs;
use std::path::{Path, PathBuf};

use assur_file::{Document, Problem, State, View, gallery};
use assur_tests::files::{presets, root};
use serde_json::{Value, json};

/// The folders of the lessons, with that of the tests.
fn lessons() -> Vec<PathBuf> {
    let places = ["www/lessons", "tests/data/page/lessons"];
    let entries = places.map(|place| fs::read_dir(root().join(place)).unwrap());
    let paths = entries
        .into_iter()
        .flatten()
        .map(|entry| entry.unwrap().path());
    paths.filter(|path| path.is_dir()).collect()
}

/// A file of a lesson, where it has it.
fn file(lesson: &Path, name: &str) -> Option<Value> {
    let text = fs::read_to_string(lesson.join(name)).ok()?;
    Some(serde_json::from_str(&text).unwrap_or_else(|error| panic!("{lesson:?} {name}: {error}")))
}

/// Everything that a value has, by its path.
fn keys(value: &Value) -> Vec<String> {
    let under = |key: &str, value: &Value| {
        let inner = keys(value).into_iter();
        let inner = inner.map(|path| format!("{key}.{path}"));
        [key.to_owned()]
            .into_iter()
            .chain(inner)
            .collect::<Vec<_>>()
    };
    let mut found: Vec<String> = match value {
        Value::Object(fields) => fields
            .iter()
            .flat_map(|(key, one)| under(key, one))
            .collect(),
        Value::Array(all) => (all.iter().enumerate())
            .flat_map(|(index, one)| under(&index.to_string(), one))
            .collect(),
        _ => Vec::new(),
    };
    found.sort_unstable();
    found
}

/// The engine takes it: a scheme with its cuts, a train by time, of all others the motion.
fn taken(state: &State) -> Result<(), Vec<Problem>> {
    state.check()?;
    match &state.document {
        Document::Scheme(document) => document.cuts(&document.scheme()?).map(|_| ()),
        Document::GearTrain(document) => document.train().map(|_| ()),
        _ => state.moved().map(|_| ()),
    }
}

#[test]
fn presets_are_documents() {
    let mut count = 0;
    for lesson in lessons() {
        for (name, mut state) in presets(&lesson) {
            state["format"] = json!(2);
            state["view"] = serde_json::to_value(View::default()).unwrap();
            let read = State::read(&state).map_err(|problem| vec![problem]);
            // What the page takes from it as it stands is all there.
            let saved = read
                .as_ref()
                .map(|state| serde_json::to_value(state).unwrap());
            let saved = saved.unwrap_or_default();
            assert_eq!(keys(&state["document"]), keys(&saved["document"]), "{name}");
            let taken = read.and_then(|state| taken(&state));
            assert!(taken.is_ok(), "{lesson:?} {name}: {taken:?}");
            count += 1;
        }
    }
    assert!(count > 0);
}

/// A subject is a kind of document, an origin of the catalogue, or one of a lesson's own
/// presets.
#[test]
fn what_a_lesson_is_about_is_there() {
    let own = |(_, preset): (String, Value)| {
        let origin = preset["document"]["origin"].as_str().map(str::to_owned);
        [origin, preset["kind"].as_str().map(str::to_owned)]
    };
    let own = lessons()
        .into_iter()
        .flat_map(|lesson| presets(&lesson).into_iter().flat_map(own));
    let mut known: Vec<String> = own.flatten().collect();
    known.extend(gallery().map(str::to_owned));
    known.extend(["mixer", "linkage"].map(str::to_owned));
    for lesson in lessons() {
        let facts = file(&lesson, "lesson.json").unwrap();
        let about = facts["about"].as_array().unwrap();
        assert!(!about.is_empty(), "{lesson:?}");
        for subject in about {
            let found = known.iter().any(|one| *subject == json!(one));
            assert!(found, "{lesson:?} is about {subject}, which there is not");
        }
    }
}
