//! The saved form of a scheme: default fields, reading, refusals.

use assur_file::{Document, SchemeDocument, State, document, document_of, from_text, schemes};
use serde_json::{Value, json};

/// A saved four-bar.
fn four_bar() -> Value {
    let pairs = [
        ("A", "0", "1"),
        ("B", "1", "2"),
        ("C", "2", "3"),
        ("D", "3", "0"),
    ];
    let pairs = pairs
        .map(|(name, one, other)| json!({"name": name, "kind": "revolute", "links": [one, other]}));
    json!({"ground": "0", "planar": true, "pairs": pairs})
}

/// Returns the document of the four-bar after a change.
fn changed(change: impl FnOnce(&mut Value)) -> SchemeDocument {
    let mut document = four_bar();
    change(&mut document);
    serde_json::from_value(document).unwrap()
}

/// Returns the problems of the four-bar and of its cuts after a change.
fn refused(change: impl FnOnce(&mut Value)) -> Vec<Value> {
    let document = changed(change);
    let problems = document
        .scheme()
        .and_then(|scheme| document.cuts(&scheme))
        .unwrap_err();
    let said = problems.iter().map(serde_json::to_value);
    said.map(Result::unwrap).collect()
}

#[test]
fn what_is_left_out_is_usual() {
    let read = changed(|_| ());
    assert_eq!(
        (read.cut.len(), read.look_deg, read.task),
        (0, [-30.0, 25.0], None)
    );
    let state = json!({"format": 2, "kind": "scheme", "document": four_bar()});
    let state = State::read(&state).unwrap();
    assert!(matches!(&state.document, Document::Scheme(document) if *document == read));
    let again = State::read(&serde_json::to_value(&state).unwrap()).unwrap();
    assert_eq!(again, state);
    let mut misspelt = four_bar();
    misspelt["grond"] = "0".into();
    assert!(document_of(&misspelt.to_string()).is_err());
}

#[test]
fn a_bare_document_with_pairs_is_a_scheme() {
    let read = document_of(&four_bar().to_string()).unwrap();
    assert!(matches!(read, Document::Scheme(_)));
    // A scheme has no motion, so reading it as a linkage is refused.
    let problem = from_text(&four_bar().to_string()).unwrap_err();
    assert_eq!(
        serde_json::to_value(&problem[0]).unwrap(),
        json!({"code": "no_motion"})
    );
}

#[test]
fn every_scheme_of_the_catalogue_is_opened_by_its_cuts() {
    let mut count = 0;
    for name in schemes() {
        let Document::Scheme(document) = document(name).unwrap().unwrap() else {
            unreachable!("{name}");
        };
        assert_eq!(document.origin.as_deref(), Some(name));
        let scheme = document.scheme().unwrap();
        let cuts = document.cuts(&scheme).unwrap();
        assert!(scheme.sections(&cuts).is_ok(), "{name}");
        count += 1;
    }
    assert_eq!(count, 6);
}

#[test]
fn a_draft_is_written_and_read_alike() {
    for name in schemes() {
        let Document::Scheme(document) = document(name).unwrap().unwrap() else {
            unreachable!("{name}");
        };
        let scheme = document.scheme().unwrap();
        let written = SchemeDocument::new(&scheme.spec());
        let value = serde_json::to_value(&written).unwrap();
        let read: SchemeDocument = serde_json::from_value(value).unwrap();
        assert_eq!(read, written, "{name}");
        assert_eq!(read.scheme().unwrap().counts(), scheme.counts(), "{name}");
    }
}

#[test]
fn what_is_wrong_is_named() {
    let pair = |at: usize, key: &'static str, value: Value| {
        refused(move |document| document["pairs"][at][key] = value)
    };
    assert_eq!(
        refused(|document| document["pairs"] = json!([])),
        [json!({"code": "no_pairs"})]
    );
    assert_eq!(
        refused(|document| document["ground"] = "7".into()),
        [json!({"code": "no_ground", "link": "7"})]
    );
    assert_eq!(
        pair(1, "name", "A".into()),
        [json!({"code": "same_pair", "pair": "A"})]
    );
    assert_eq!(
        pair(1, "links", json!(["1", "1"]))[0],
        json!({"code": "pair_with_itself", "pair": "B", "link": "1"})
    );
    assert_eq!(
        pair(1, "links", json!(["1"]))[0],
        json!({"code": "links_of_pair", "pair": "B", "count": 1})
    );
    let class = |freedoms: u8| {
        refused(|document| {
            document["pairs"][2]["kind"] = "class".into();
            document["pairs"][2]["freedoms"] = freedoms.into();
        })
    };
    for freedoms in [0, 3, 6, 255] {
        let said = json!({"code": "freedoms_of_pair", "pair": "C", "freedoms": freedoms});
        assert_eq!(class(freedoms), [said]);
    }
    assert_eq!(
        pair(0, "axis", json!([1, 0, 0])),
        [json!({"code": "out_of_plane", "pair": "A"})]
    );
    assert_eq!(
        pair(0, "axis", json!([0, 0, 0])),
        [json!({"code": "pair_geometry", "pair": "A"})]
    );
    assert_eq!(
        pair(3, "links", json!(["4", "5"])),
        [json!({"code": "scheme_apart", "links": ["4", "5"]})]
    );
    let cut = |cut: Value| refused(|document| document["cut"] = cut);
    assert_eq!(
        cut(json!(["X"])),
        [json!({"code": "no_such_pair", "pair": "X"})]
    );
    assert_eq!(
        cut(json!(["D:1"])),
        [json!({"code": "not_of_pair", "pair": "D", "link": "1"})]
    );
    assert_eq!(pair(0, "name", "A:1".into())[0]["code"], "bad_name");
    assert_eq!(
        refused(|document| document["ends"] = json!([{"link": "9", "at": [0, 0]}])),
        [json!({"code": "unknown_name", "name": "9"})]
    );
}
