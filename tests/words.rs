//! The string tables: every language says everything, and every problem of the
//! engine has its words.
#![cfg(not(target_family = "wasm"))]

use std::collections::{BTreeMap, BTreeSet};

type Words = BTreeMap<String, String>;

const LANGUAGES: [(&str, &str); 4] = [
    ("en", include_str!("../lang/en.json")),
    ("ru", include_str!("../lang/ru.json")),
    ("uk", include_str!("../lang/uk.json")),
    ("kk", include_str!("../lang/kk.json")),
];

fn tables() -> Vec<(&'static str, Words)> {
    LANGUAGES
        .into_iter()
        .map(|(lang, text)| (lang, serde_json::from_str(text).unwrap()))
        .collect()
}

/// The `{places}` of a sentence.
fn places(sentence: &str) -> BTreeSet<&str> {
    let parts = sentence.split('{').skip(1);
    parts
        .filter_map(|part| part.split_once('}'))
        .map(|(name, _)| name)
        .collect()
}

#[test]
fn every_language_says_everything() {
    let tables = tables();
    let (_, first) = &tables[0];
    for (lang, words) in &tables {
        let keys: Vec<&String> = words.keys().collect();
        assert_eq!(keys, first.keys().collect::<Vec<_>>(), "{lang}");
        for (key, sentence) in words {
            assert!(!sentence.trim().is_empty(), "{lang}: {key}");
            assert_eq!(places(sentence), places(&first[key]), "{lang}: {key}");
        }
    }
}

/// Codes and fields as `assur-file` writes them.
#[test]
fn every_problem_has_words() {
    let codes = [
        "not_a_number",
        "not_positive",
        "out_of_range",
        "not_whole",
        "unknown_choice",
        "at_rest",
        "too_long",
        "concentric_wheels",
        "mixed_wheels",
        "apart",
        "inside",
        "undetermined",
        "dead_point",
        "bad_state",
        "trapped",
        "not_settings",
    ];
    let fields = [
        "l1",
        "l2",
        "l3",
        "l4",
        "z4",
        "wheels",
        "wheels.z",
        "wheels.centre_line_deg",
        "mesh",
        "module",
        "tracers",
        "tracers.link",
        "tracers.x",
        "tracers.y",
        "assembly",
        "format",
        "phi_deg",
        "direction",
        "speed",
        "omega",
        "epsilon",
        "plot",
    ];
    for (lang, words) in tables() {
        for code in codes {
            assert!(
                words.contains_key(&format!("problem.{code}")),
                "{lang}: {code}"
            );
        }
        for field in fields {
            assert!(
                words.contains_key(&format!("field.{field}")),
                "{lang}: {field}"
            );
        }
    }
}
