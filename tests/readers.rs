//! Readers of external texts, given damaged texts. A reader refuses each text with problems that have codes, or accepts
//! it; an accepted text, written and read again, is the same. No reader panics or hangs. Tests of the same kind for the
//! terminal are in `crates/assur-cli/tests/damaged.rs`, for addresses of the page in `www/app/damage.test.js`.

use assur_file::{
    Document, FORMAT, State, catalogue, document, document_of, schemes, tasks, trains,
};
use assur_import::{read, recognised};
use assur_tests::damage::{Dice, checked, damaged, fuzz};
use assur_tests::files::{source, texts};
use assur_tests::scaled;
use serde::Serialize;
use serde_json::{Value, json};

/// Damaged texts of a target in a quick run.
const QUICK: usize = 300;

/// Every problem has a code.
fn coded<P: Serialize>(problems: &[P]) {
    assert!(!problems.is_empty());
    for problem in problems {
        assert!(serde_json::to_value(problem).unwrap()["code"].is_string());
    }
}

/// A document as the state that a file has.
fn stated(document: &Document) -> Value {
    let mut state = serde_json::to_value(document).unwrap();
    state["format"] = json!(FORMAT);
    state
}

/// Every document of the catalogue.
fn documents() -> impl Iterator<Item = Document> {
    let names = catalogue().chain(trains()).chain(schemes()).chain(tasks());
    names.map(|name| document(name).unwrap().unwrap())
}

/// A state with all that one may have: a lesson, a comparison, a picture.
fn full() -> Value {
    let compared = serde_json::to_value(document("jansen").unwrap().unwrap()).unwrap();
    let mut state = stated(&document("crank-rocker").unwrap().unwrap());
    let shown = json!({
        "kind": state["kind"], "document": state["document"], "view": {"phi_deg": 30, "vectors": true},
        "vary": [{"field": "points[0].x", "from": 0.5, "to": 0.9, "step": 0.05}],
    });
    let number =
        json!({"quantity": "rocker.angle", "at": 45, "within": 0.1, "shown": true, "unit": "°"});
    let choice = json!({"options": ["II", "III"], "answer": 0});
    let reach = json!({"quantity": "input", "value": 90, "within": 1});
    state["compared"] = compared;
    state["lesson"] = json!({"title": "Crank-rocker", "author": "A. Lecturer", "steps": [
        {"title": "Angle", "text": "φ", "formula": "W = 3n − 2p₁", "shows": shown, "question": {"text": "φ?", "hint": "Read it.", "number": number}},
        {"title": "Class", "text": "", "question": {"text": "Which?", "choice": choice}},
        {"title": "Drag", "text": "", "question": {"text": "To 90°.", "reach": reach}},
    ]});
    state["picture"] = json!({"image": "data:image/png;base64,iVBORw0KGgo=", "at": [1, -2], "width": 3.5, "turn_deg": -30, "opacity": 0.25});
    state
}

fn state(text: String) -> Option<String> {
    match State::parse(&text) {
        Err(problem) => {
            coded(&[problem]);
            None
        }
        Ok(state) => {
            state.moved().err().iter().for_each(|all| coded(all));
            state
                .document
                .numbers()
                .err()
                .iter()
                .for_each(|all| coded(all));
            Some(serde_json::to_string(&state).unwrap())
        }
    }
}

#[test]
fn damaged_states_are_refused_or_open() {
    let synthesis = json!({
        "format": FORMAT, "kind": "synthesis",
        "document": {
            "unit": "m", "frame": 10.4, "phi0_deg": 5, "free": true, "member": [5, 1], "solution": 1, "trial": [7, 5, 3],
            "positions": [{"output_deg": 240, "input_deg": 45, "weight": 2}, {"output_deg": 253, "input_deg": 60, "coupler_deg": 7}],
            "function": {"of": {"table": [[1, 0.5], [2, 3], [4, 7]]}, "x": [1, 4], "input_deg": [45, 60], "output_deg": [240, 253]},
        },
    });
    let draft = json!({"format": FORMAT, "kind": "draft", "document": {"points": [{"name": "A", "at": [0, 0]}], "frame": ["A"], "links": [], "drivers": []}});
    let usual = documents().map(|document| stated(&document));
    // With a whole view, so that it is damaged too.
    let whole = usual.chain([full(), synthesis, draft]).map(|state| {
        let state = State::read(&state).unwrap();
        serde_json::to_string(&state).unwrap()
    });
    let first = ["linkage-state", "mixer-state"]
        .map(|name| source(&format!("tests/data/linkages/{name}.json")));
    let corpus: Vec<String> = whole.chain(first).collect();
    let accepted = fuzz(&corpus, scaled(QUICK), damaged, state);
    assert!(accepted > scaled(QUICK) / 10, "{accepted}");
}

/// The document of a text of any program, written as a state; where there is none, the problems have codes.
fn opened(text: String) -> Option<String> {
    let document = if recognised(&text) {
        let imported = read(&text).map_err(|problem| coded(&[problem])).ok()?;
        Document::Linkage(imported.document)
    } else {
        document_of(&text).map_err(|all| coded(&all)).ok()?
    };
    document.motion().err().iter().for_each(|all| coded(all));
    Some(stated(&document).to_string())
}

#[test]
fn damaged_documents_are_refused_or_open() {
    let folders = [
        "crates/assur-file/catalogue",
        "tests/data/linkages",
        "tests/data/drawings",
    ];
    let corpus: Vec<String> = folders.into_iter().flat_map(texts).collect();
    let accepted = fuzz(&corpus, scaled(QUICK), damaged, opened);
    assert!(accepted > scaled(QUICK) / 10, "{accepted}");
}

/// Links whose queries begin so.
fn links(forms: &[&str]) -> Vec<String> {
    let all = source("crates/assur-import/tests/published/pmks.txt");
    let links = all.lines().filter_map(|line| line.splitn(3, " | ").nth(2));
    let query = |link: &str| {
        link.split_once('?')
            .map_or(String::new(), |(_, query)| query.to_owned())
    };
    let of_form = |link: &&str| forms.iter().any(|form| query(link).starts_with(form));
    links.filter(of_form).map(str::to_owned).collect()
}

#[test]
fn damaged_short_links_of_pmks_plus_are_refused_or_open() {
    let damage = |text: &str, dice: &mut Dice| checked(&damaged(text, dice));
    let corpus = links(&["2P.", "0P.", "0v."]);
    assert!(corpus.len() > 20);
    let accepted = fuzz(&corpus, scaled(QUICK), damage, opened);
    assert!(accepted > scaled(QUICK) / 30, "{accepted}");
}

#[test]
fn damaged_long_links_of_pmks_plus_are_refused_or_open() {
    let accepted = fuzz(&links(&["j="]), scaled(QUICK), damaged, opened);
    assert!(accepted > scaled(QUICK) / 30, "{accepted}");
}

#[test]
fn damaged_links_of_pmks_are_refused_or_open() {
    let corpus = links(&["mech=", "set="]);
    assert!(corpus.len() > 5);
    let accepted = fuzz(&corpus, scaled(QUICK), damaged, opened);
    assert!(accepted > scaled(QUICK) / 30, "{accepted}");
}

#[test]
fn damaged_files_of_linkage_are_refused_or_open() {
    let corpus = texts("crates/assur-import/tests/published/linkage2");
    let accepted = fuzz(&corpus, scaled(QUICK), damaged, opened);
    assert!(accepted > scaled(QUICK) / 30, "{accepted}");
}
