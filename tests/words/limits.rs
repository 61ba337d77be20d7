//! Limits in the messages, in every language: documents are refused at exactly these limits.

use assur_file::{PictureDocument, Problem, document_of, from_text};
use assur_tests::files::source;
use serde_json::{Value, json};

use super::LANGUAGES;
use super::terms::page_words_in;

/// The numbers of a sentence in their order, with the decimal sign and the minus of the language.
fn numbers(lang: &str, key: &str) -> Vec<f64> {
    let words = page_words_in(lang);
    let text = words[key].replace('−', "-");
    let bare: Vec<&str> = (text.split('{'))
        .map(|part| part.split_once('}').map_or(part, |(_, rest)| rest))
        .collect();
    let sign = if lang == "en" { '.' } else { ',' };
    let part = |c: char| c.is_ascii_digit() || c == sign || c == '-';
    let bare = bare.join(" ");
    let parts = bare.split(|c: char| !part(c));
    let parts = parts.map(|part| part.trim_end_matches([sign, '-']).replace(sign, "."));
    parts.filter_map(|part| part.parse().ok()).collect()
}

/// Whether the first thing wrong with a document is this.
fn has(problems: Result<(), Vec<Problem>>, code: &str) -> bool {
    let Err(problems) = problems else {
        return false;
    };
    let written = serde_json::to_value(&problems[0]).unwrap();
    assert_eq!(written["code"], code, "{written}");
    true
}

fn refused(linkage: &Value, code: &str) -> bool {
    let document = from_text(&linkage.to_string()).unwrap();
    has(document.mechanism().map(drop), code)
}

/// A five-bar, whose second crank goes at a rate to the first.
fn five_bar(rate: f64) -> Value {
    json!({
        "points": [
            { "name": "A", "at": [0, 0] },
            { "name": "B", "at": [0.6, 0.8] },
            { "name": "C", "at": [2.6, 3] },
            { "name": "D", "at": [4.6, 0.8] },
            { "name": "E", "at": [4, 0] },
        ],
        "frame": ["A", "E"],
        "links": [
            { "name": "AB", "points": ["A", "B"] },
            { "name": "BC", "points": ["B", "C"] },
            { "name": "CD", "points": ["C", "D"] },
            { "name": "ED", "points": ["E", "D"] },
        ],
        "drivers": [{ "crank": "AB" }, { "crank": "ED", "rate": rate }],
    })
}

#[test]
fn rates_that_repeat_in_time() {
    for (lang, _) in LANGUAGES {
        let [most, examples @ ..] = &numbers(lang, "problem.rate")[..] else {
            panic!("{lang}: no number");
        };
        let is_refused = |rate: f64| refused(&five_bar(rate), "rate");
        assert!(
            !is_refused(1.0 / most) && is_refused(1.0 / (most + 1.0)),
            "{lang}: {most}"
        );
        assert_eq!(examples, [2.0, -1.0, 0.75], "{lang}");
        assert!(!examples.iter().any(|rate| is_refused(*rate)), "{lang}");
    }
    // Thirds with all digits.
    assert!(!refused(&five_bar(1.0 / 3.0), "rate") && refused(&five_bar(0.333), "rate"));
}

#[test]
fn numbers_of_teeth() {
    let pair = |teeth: f64| {
        json!({
            "points": [{ "name": "A", "at": [0, 0] }, { "name": "B", "at": [1, 0] }, { "name": "E", "at": [3, 0] }],
            "frame": ["A", "E"],
            "links": [{ "name": "crank", "points": ["A", "B"] }, { "name": "pinion", "points": ["E"] }],
            "gears": [{ "links": ["crank", "pinion"], "carrier": "frame", "teeth": [40, teeth], "mesh": "external" }],
            "drivers": [{ "crank": "crank" }],
        })
    };
    for (lang, _) in LANGUAGES {
        let numbers = numbers(lang, "problem.teeth");
        let &[least, most] = &numbers[..] else {
            panic!("{lang}: {numbers:?}");
        };
        for (teeth, bad) in [
            (least - 1.0, true),
            (least, false),
            (most, false),
            (most + 1.0, true),
        ] {
            assert_eq!(refused(&pair(teeth), "teeth"), bad, "{lang}: {teeth}");
        }
        assert!(refused(&pair(least + 0.5), "teeth"));
    }
}

#[test]
fn formats_that_can_be_read() {
    let state = |format: f64| {
        // The first version calls the kind `lesson`, which later ones have for a lesson.
        let kind = if format == 1.0 { "lesson" } else { "kind" };
        json!({ "format": format, kind: "linkage", "document": five_bar(1.0) })
    };
    for (lang, _) in LANGUAGES {
        let known = numbers(lang, "problem.unknown_format");
        for format in [0.0, 1.0, 2.0, 3.0] {
            let read = document_of(&state(format).to_string()).map(drop);
            assert_eq!(
                !has(read, "unknown_format"),
                known.contains(&format),
                "{lang}: {format}"
            );
        }
    }
}

#[test]
fn freedoms_of_pairs() {
    let scheme = |planar: bool, freedoms: f64| {
        json!({
            "planar": planar,
            "ground": "0",
            "pairs": [{ "name": "A", "kind": "class", "freedoms": freedoms as u8, "links": ["0", "1"] }],
        })
    };
    let is_refused = |planar: bool, freedoms: f64| {
        let assur_file::Document::Scheme(scheme) =
            document_of(&scheme(planar, freedoms).to_string()).unwrap()
        else {
            panic!("no scheme");
        };
        has(scheme.scheme().map(drop), "freedoms_of_pair")
    };
    for (lang, _) in LANGUAGES {
        let numbers = numbers(lang, "problem.freedoms_of_pair");
        let &[least, most, least_planar, most_planar] = &numbers[..] else {
            panic!("{lang}: {numbers:?}");
        };
        for (planar, least, most) in [(false, least, most), (true, least_planar, most_planar)] {
            for freedoms in [least, most] {
                assert!(!is_refused(planar, freedoms), "{lang}: {freedoms}");
            }
            for freedoms in [least - 1.0, most + 1.0] {
                assert!(is_refused(planar, freedoms), "{lang}: {freedoms}");
            }
        }
    }
}

/// The page makes photographs so small that they are taken.
#[test]
fn the_page_and_files_take_images_of_one_length() {
    let script = source("www/drawing/image.js");
    let (_, longest) = script.split_once("const MAX_TEXT = ").unwrap();
    let digits = longest.split(';').next().unwrap().replace('_', "");
    let longest: usize = digits.parse().unwrap();
    let start = "data:image/gif;base64,";
    let checked = |long: usize| {
        let image = format!("{start}{}", "A".repeat(long));
        let picture = PictureDocument {
            image,
            at: [0.0, 0.0],
            width: 1.0,
            turn_deg: 0.0,
            opacity: 0.5,
        };
        picture.check()
    };
    // As long as base64 can be.
    let most = (longest - start.len()) / 4 * 4;
    assert_eq!(checked(most), Ok(()));
    assert!(has(checked(most + 4), "picture_long"));
}
