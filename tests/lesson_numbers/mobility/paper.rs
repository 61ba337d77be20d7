//! What the comments on the paper's items and the text on its two layouts say.

use std::collections::BTreeMap;

use assur::mobility::PairKind::{self, Revolute, Spherical};
use serde_json::Value;

use super::{LANGUAGES, LESSON, scheme};
use crate::lesson_numbers::numbers;

/// The steps to which the comment on open chains refers are those of (1) and (2).
#[test]
fn steps_of_the_formulas() {
    let items: Vec<Value> = serde_json::from_str(&LESSON.file("paper.json")).unwrap();
    let script = LESSON.file("lesson.js");
    let steps: Vec<&str> = (script.lines())
        .filter_map(|line| line.trim().strip_prefix("id: \"")?.strip_suffix("\","))
        .collect();
    let number = |item: &str| {
        let row = items.iter().find(|row| row["item"] == item).unwrap();
        1 + steps.iter().position(|step| row["step"] == *step).unwrap()
    };
    let expected = [number("001.(1)"), number("001.(2)")];
    for lang in LANGUAGES {
        let text = LESSON.file(&format!("paper.{lang}.json"));
        let comments: BTreeMap<String, String> = serde_json::from_str(&text).unwrap();
        let found = numbers(&comments["paper.open.valid"], lang);
        let found: Vec<usize> = found.iter().map(|(value, _)| *value as usize).collect();
        assert_eq!(found, [&[1, 2], &expected[..]].concat(), "{lang}");
    }
}

/// Both layouts have the same pairs, but for the kinds of B and D, which change places.
#[test]
fn kinds_of_pairs_in_both_layouts() {
    let kinds = ["mobility-3", "layout"].map(|name| {
        let scheme = scheme(name);
        let pairs = scheme.pairs().iter();
        pairs
            .map(|pair| (pair.name.clone(), pair.kind))
            .collect::<BTreeMap<String, PairKind>>()
    });
    let [ours, other] = &kinds;
    let changed = ours.iter().filter(|(name, kind)| other[*name] != **kind);
    let names: Vec<&str> = changed.map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["B", "D"]);
    assert_eq!([ours["B"], ours["D"]], [Spherical, Revolute]);
    assert_eq!([other["B"], other["D"]], [Revolute, Spherical]);
}
