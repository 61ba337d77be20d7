//! Terms of each language: one term for one concept, and the numbers and apostrophes of that language.

use std::collections::BTreeSet;
use std::fs;

use assur_tests::files::{root, scripts, source};
use serde_json::Value;

use super::{PAGE, Words, kinds, lessons, page_words, tables, tables_of_lessons};

/// Words out of use, by how they begin in small letters, and what is said instead. They are words of everyday speech,
/// of another field or of another language, or second words for what has a term.
const UNUSED: [(&str, &[(&str, &str)]); 4] = [
    (
        "en",
        &[
            ("chief ", "main"),
            ("true time", "real time"),
            ("input link", "driver"),
            ("driving ", "driver"),
            ("one-freedom", "one degree of freedom"),
            ("least transmission", "minimum transmission angle"),
            ("hinges on the frame", "fixed pivots"),
            ("joints", "hinges"),
            ("passive constraint", "redundant constraint"),
            (
                "derivatives of points",
                "velocity and acceleration analogues of points",
            ),
        ],
    ),
    (
        "ru",
        &[
            ("истинн", "реальное время"),
            ("ведущ", "входное звено, входной вал"),
            ("чертёж", "схема"),
            ("чертеж", "схема"),
            ("настройк", "параметры"),
            ("вычислител", "расчётный модуль"),
            ("мёртвая точк", "мёртвое положение"),
            ("мёртвые точк", "мёртвые положения"),
            ("главные величин", "основные величины"),
            ("передаточное числ", "передаточное отношение"),
            ("пассивная связ", "избыточная связь"),
            ("пассивных связ", "избыточные связи"),
            ("цепь уатт", "шестизвенник Уатта"),
            ("цепь стефенс", "шестизвенник Стефенсона"),
            ("производные точ", "аналоги скорости и ускорения точек"),
        ],
    ),
    (
        "uk",
        &[
            ("істинн", "реальний час"),
            ("ведуч", "вхідна ланка, вхідний вал"),
            ("креслення", "схема"),
            ("налаштуван", "параметри"),
            ("обчислювач", "розрахунковий модуль"),
            ("мертва точк", "мертве положення"),
            ("мертві точк", "мертві положення"),
            ("головні величин", "основні величини"),
            ("передаточн", "передатне відношення"),
            ("кількість зуб", "число зубців"),
            ("пасивних в’яз", "надлишкові в’язі"),
            ("шестиланковик", "шестиланковий механізм"),
        ],
    ),
    (
        "kk",
        &[
            ("шынайы", "нақты уақыт"),
            ("жинақ", "жинау нұсқасы"),
            ("есептегіш", "есептеу модулі"),
            ("тербеліс шег", "тербелу бұрышы"),
            ("сызба", "сұлба"),
            ("жылжыма", "сырғақ; қозғалмалы"),
            ("баптау", "параметрлер"),
            ("кіріс буын", "жетекші буын"),
            ("беріліс саны", "беріліс қатынасы"),
            ("пассив байланыс", "артық байланыс"),
            ("чебышёв", "Чебышев"),
        ],
    ),
];

/// Keys of the same thing, by the table: its word is one.
const ALIKE: [(&str, &str); 12] = [
    ("name.l1", "link.crank"),
    ("name.l2", "link.coupler"),
    ("name.l3", "link.rocker"),
    ("name.l4", "link.frame"),
    ("name.wheels.z", "link.wheel"),
    ("map.coupler", "link.coupler"),
    ("map.output", "name.output"),
    ("dwell.dwell", "dwell.arc"),
    ("name.z2", "link.satellite"),
    ("link.planet", "link.satellite"),
    ("readouts.transmission", "show.transmission"),
    ("transport.true_time.time", "transport.true_time.angle"),
];

/// Every text of a language, with the table and the key that it has.
fn texts(lang: &str) -> Vec<(String, String)> {
    let of_lessons = lessons()
        .into_iter()
        .map(|lesson| format!("{lesson}/words.*.json"));
    let kinds = kinds::kinds();
    let of_kinds = kinds.iter().flat_map(kinds::Kind::places);
    let places = of_lessons.chain(of_kinds).chain(tables_of_lessons("paper"));
    let places: Vec<String> = places.chain([PAGE.to_owned()]).collect();
    let of_place = |place: &String| {
        let (_, _, words) = (tables(place).into_iter())
            .find(|(found, _, _)| *found == lang)
            .unwrap();
        let named = |(key, text)| (format!("{} {key}", place.replace('*', lang)), text);
        words.into_iter().map(named).collect::<Vec<_>>()
    };
    places.iter().flat_map(of_place).collect()
}

/// Whether a word of the text begins so.
fn begins(text: &str, start: &str) -> bool {
    let mut found = text.match_indices(start);
    found.any(|(at, _)| !text[..at].ends_with(char::is_alphabetic))
}

#[test]
fn words_out_of_use_stay_out() {
    for (lang, unused) in UNUSED {
        let texts = texts(lang);
        assert!(texts.len() > 900, "{lang}: {}", texts.len());
        for (key, text) in texts {
            let text = text.to_lowercase();
            for (start, instead) in unused {
                assert!(
                    !begins(&text, start),
                    "{key}: “{start}…”, the term is {instead}: {text}"
                );
            }
        }
    }
    assert!(begins("the driver", "driv") && !begins("overdriven", "driv"));
}

/// Everything that the page says of its tables, the kinds' among them, in one language.
pub(crate) fn page_words_in(lang: &str) -> Words {
    let kinds = kinds::kinds();
    let places = kinds.iter().flat_map(kinds::Kind::places);
    let tables = places.chain([PAGE.to_owned()]).map(|place| {
        let mut all = tables(&place).into_iter();
        all.find(|(found, _, _)| *found == lang).unwrap().2
    });
    tables.flatten().collect()
}

#[test]
fn one_thing_has_one_word() {
    for (lang, _) in UNUSED {
        let words = page_words_in(lang);
        for (one, other) in ALIKE {
            let [one_text, other_text] = [one, other].map(|key| words[key].as_str());
            assert!(
                one_text.contains(other_text) || other_text.contains(one_text),
                "{lang} {one}: {one_text}; {other}: {other_text}"
            );
        }
    }
}

/// Mechanisms of the catalogue call their links by letters, or by a word that every language has; a number may follow it.
#[test]
fn links_of_the_catalogue_have_words() {
    let words = page_words();
    let folder = "crates/assur-file/catalogue";
    let mut named = BTreeSet::new();
    for entry in fs::read_dir(root().join(folder)).unwrap() {
        let file = format!("{folder}/{}", entry.unwrap().file_name().to_str().unwrap());
        let document: Value = serde_json::from_str(&source(&file)).unwrap();
        for link in document["links"].as_array().into_iter().flatten() {
            let name = link["name"].as_str().unwrap();
            let word = name.trim_end_matches(|c: char| c.is_ascii_digit() || c == ' ');
            let small = |c: char| c.is_lowercase();
            if word.matches(small).count() < 2 {
                continue;
            }
            let key = format!("link.{word}");
            assert!(words.contains_key(&key), "{file}: {key}");
            named.insert(word.to_owned());
        }
    }
    assert!(named.len() > 10, "{named:?}");
}

/// Whether the sign stands between two characters of this kind.
fn between(text: &str, sign: char, kind: fn(char) -> bool) -> bool {
    let mut found = text.match_indices(sign).map(|(at, _)| text.split_at(at));
    found.any(|(before, from)| before.ends_with(kind) && from[sign.len_utf8()..].starts_with(kind))
}

fn digit(c: char) -> bool {
    c.is_ascii_digit()
}

/// A decimal point in English, a comma in the other languages. A script that writes a number into a formula leaves
/// the sign to the language.
#[test]
fn numbers_have_the_decimal_sign_of_the_language() {
    for (lang, _) in UNUSED {
        let other = if lang == "en" { ',' } else { '.' };
        for (key, text) in texts(lang) {
            assert!(!between(&text, other, digit), "{key}: {text}");
        }
    }
    let mut formulas = 0;
    for (name, script) in scripts("www/lessons") {
        for rest in script.split("formula: \"").skip(1) {
            let formula = rest.split('"').next().unwrap();
            let decimals = ['.', ','].map(|sign| between(formula, sign, digit));
            assert_eq!(decimals, [false, false], "{name}: {formula}");
            formulas += 1;
        }
    }
    assert!(formulas > 20, "{formulas}");
    assert!(between("FK = 4.112", '.', digit) && !between("1a. 2", '.', digit));
}

/// One sign for the apostrophe.
#[test]
fn apostrophes_are_alike() {
    for (lang, _) in UNUSED {
        for (key, text) in texts(lang) {
            assert!(!between(&text, '\'', char::is_alphabetic), "{key}: {text}");
        }
    }
}
