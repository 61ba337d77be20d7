//! The string tables: every language has every text, in every form that its nouns need; every problem of the engine has
//! a text; no key is missing or unused.

mod keys;
mod kinds;
mod limits;
mod problems;
mod terms;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use assur_tests::files::{root, scripts, source};
use keys::BUILT;

type Words = BTreeMap<String, String>;

/// Every language, with the forms that CLDR's plural rules give a noun beside a
/// number in it.
const LANGUAGES: [(&str, &[&str]); 4] = [
    ("en", &["one", "other"]),
    ("ru", &["few", "many", "one", "other"]),
    ("uk", &["few", "many", "one", "other"]),
    ("kk", &["one", "other"]),
];

/// The tables of all that the page says.
const PAGE: &str = "lang/*.json";

/// The tables that load after those of the first view.
const LATER: [&str; 2] = ["www/app/later.*.json", "www/forces/words.*.json"];

/// The folders of the lessons.
fn lessons() -> Vec<String> {
    let entries = fs::read_dir(root().join("www/lessons")).unwrap();
    let folders = entries.map(|entry| entry.unwrap().path());
    let names = folders.filter(|path| path.is_dir()).map(|path| {
        let name = path.file_name().unwrap().to_str().unwrap();
        format!("www/lessons/{name}")
    });
    let mut found: Vec<String> = names.collect();
    found.sort_unstable();
    assert!(found.len() > 1, "{found:?}");
    found
}

/// The places of the tables `NAME.*.json` of those lessons that have one: misprints of a paper, what is said of its items.
fn tables_of_lessons(name: &str) -> impl Iterator<Item = String> {
    let places = lessons()
        .into_iter()
        .map(move |lesson| format!("{lesson}/{name}.*.json"));
    places.filter(|place| root().join(place.replace('*', "en")).exists())
}

/// The tables of all languages; in `place` the language stands for `*`.
fn tables(place: &str) -> Vec<(&'static str, &'static [&'static str], Words)> {
    let table = |(lang, forms)| {
        let text = source(&place.replace('*', lang));
        (lang, forms, serde_json::from_str(&text).unwrap())
    };
    LANGUAGES.into_iter().map(table).collect()
}

/// Every word the page ever says outside its lessons, in the first language: with those of the
/// kinds, which the build puts there, and of the parts loaded on demand.
fn page_words() -> Words {
    let mut words = tables(PAGE).swap_remove(0).2;
    for place in LATER {
        words.extend(tables(place).swap_remove(0).2);
    }
    words.extend(kinds::kinds().iter().flat_map(kinds::Kind::words));
    words
}

/// A key without the form of the noun, and the form.
fn split(key: &str) -> (&str, Option<&str>) {
    match key.rsplit_once('.') {
        Some((base, form @ ("one" | "few" | "many" | "other"))) => (base, Some(form)),
        _ => (key, None),
    }
}

/// What a script may ask for: keys, of those with several forms what is common.
fn asked(words: &Words) -> BTreeSet<&str> {
    words.keys().map(|key| split(key).0).collect()
}

/// The `{places}` of a sentence.
fn places(sentence: &str) -> BTreeSet<&str> {
    let parts = sentence.split('{').skip(1);
    parts
        .filter_map(|part| part.split_once('}'))
        .map(|(name, _)| name)
        .collect()
}

/// What stands between two of these marks in one line.
fn quoted(text: &str, mark: char) -> BTreeSet<&str> {
    let lines = text.lines();
    lines
        .flat_map(|line| line.split(mark).skip(1).step_by(2))
        .collect()
}

/// Whether a source names a word: in quotes, as a number, as the key of an object; a
/// code as the variant of an enum `…Problem` or `LeftOut`. What stands in its tests does not count.
fn names(source_name: &str, word: &str) -> bool {
    let text = source(source_name);
    let text = text.split("#[cfg(test)]").next().unwrap();
    let letter = |c: char| c.is_alphanumeric() || c == '_';
    let alone = |word: &str| {
        let mut ends = text.match_indices(word).map(|(at, _)| text.split_at(at));
        ends.any(|(before, from)| {
            !before.ends_with(letter) && !from[word.len()..].starts_with(letter)
        })
    };
    let number = word.parse::<u8>().is_ok();
    let variant = text.contains("tag = \"code\"");
    quoted(text, '"').contains(word)
        || (number && alone(word))
        || (variant && alone(&pascal(word)))
        || text.contains(&format!("  {word}: ("))
}

/// `too_long` as `TooLong`.
fn pascal(code: &str) -> String {
    let capital = |word: &str| {
        let mut letters = word.chars();
        let first = letters.next().map(|first| first.to_ascii_uppercase());
        first.into_iter().chain(letters).collect::<String>()
    };
    code.split('_').map(capital).collect()
}

/// `TooLong` as `too_long`.
fn snake(variant: &str) -> String {
    let mut code = String::new();
    for letter in variant.chars() {
        if letter.is_ascii_uppercase() && !code.is_empty() {
            code.push('_');
        }
        code.push(letter.to_ascii_lowercase());
    }
    code
}

#[test]
fn every_language_says_everything() {
    let steps = lessons()
        .into_iter()
        .map(|lesson| format!("{lesson}/words.*.json"));
    let kinds = kinds::kinds();
    let kinds = kinds.iter().flat_map(kinds::Kind::places);
    let of_lessons = tables_of_lessons("paper");
    let of_page = [PAGE].into_iter().chain(LATER).map(str::to_owned);
    let all = steps.chain(of_lessons).chain(kinds).chain(of_page);
    for place in all {
        let tables = tables(&place);
        let (_, _, first) = &tables[0];
        for (lang, forms, words) in &tables {
            assert_eq!(asked(words), asked(first), "{place} {lang}");
            let mut found: BTreeMap<&str, BTreeSet<&str>> = BTreeMap::new();
            for (key, sentence) in words {
                assert!(!sentence.trim().is_empty(), "{place} {lang}: {key}");
                let (base, form) = split(key);
                let model = first.get(&format!("{base}.other"));
                let model = model.or_else(|| first.get(key)).unwrap();
                assert_eq!(places(sentence), places(model), "{place} {lang}: {key}");
                if let Some(form) = form {
                    found.entry(base).or_default().insert(form);
                }
            }
            for (base, found) in found {
                assert!(found.iter().eq(*forms), "{place} {lang}: {base} {found:?}");
                assert!(places(&words[&format!("{base}.other")]).contains("count"));
            }
        }
    }
}

#[test]
fn no_key_is_left_over() {
    let page = source("www/index.html");
    let scripts = scripts("www");
    let named: BTreeSet<&str> = quoted(&page, '"')
        .into_iter()
        .chain(scripts.values().flat_map(|script| quoted(script, '"')))
        .collect();
    let words = page_words();
    let kinds = kinds::kinds();
    let mut over = Vec::new();
    for key in asked(&words) {
        let built = BUILT.iter().any(|(start, sources)| {
            key.strip_prefix(start)
                .is_some_and(|rest| sources.iter().any(|source| names(source, rest)))
        });
        let mut owners = kinds.iter().filter(|kind| kind.words().contains_key(key));
        let used = named.contains(key)
            || page.contains(&format!("{{{{{key}}}}}"))
            || built
            || owners.any(|kind| kind.builds(key));
        if !used {
            over.push(key);
        }
    }
    assert!(over.is_empty(), "used nowhere: {over:?}");
}

#[test]
fn no_key_is_missing() {
    let words = page_words();
    let kinds = kinds::kinds();
    let keys = asked(&words);
    let spaces: BTreeSet<&str> = keys
        .iter()
        .map(|key| key.split('.').next().unwrap())
        .collect();
    let is_key = |text: &&str| {
        let mut parts = text.split('.');
        let space = parts.next().is_some_and(|part| spaces.contains(part));
        let plain = |c: char| c.is_ascii_alphanumeric() || "._-".contains(c);
        space && parts.next().is_some() && text.chars().all(plain)
    };
    let page = source("www/index.html");
    for part in page.split("data-t").skip(1) {
        let key = part.split('"').nth(1).unwrap();
        assert!(keys.contains(key), "index.html asks for {key}");
    }
    for part in page.split("{{").skip(1) {
        let key = part.split("}}").next().unwrap();
        let known = keys.contains(key) || ["version", "languages"].contains(&key);
        assert!(known, "index.html: {key}");
    }
    for (name, script) in scripts("www") {
        for key in quoted(&script, '"').into_iter().filter(is_key) {
            let mut parts = BUILT.iter().map(|(start, _)| format!("{start}{key}"));
            let known = keys.contains(key) || parts.any(|key| keys.contains(key.as_str()));
            assert!(known, "{name} asks for {key}");
        }
        for built in quoted(&script, '`') {
            let Some((start, _)) = built.split_once("${") else {
                continue;
            };
            let known = BUILT.iter().any(|(listed, _)| *listed == start)
                || kinds.iter().any(|kind| kind.begins(&name, start));
            let key = start.ends_with('.') && spaces.contains(start.split('.').next().unwrap());
            assert!(known || !key, "{name} builds keys from {start}");
        }
    }
}

/// What stands in the brackets of a list, or of the constant of the script that is named instead.
fn list_of<'a>(value: &'a str, script: &'a str) -> &'a str {
    let list = value.strip_prefix('[').unwrap_or_else(|| {
        let name = value.split(|c: char| !c.is_alphanumeric()).next().unwrap();
        let (_, constant) = script.split_once(&format!("const {name} = ")).unwrap();
        constant.split_once('[').unwrap().1
    });
    list.split(']').next().unwrap()
}

/// What every step of a lesson says, its choices, what it shows and draws.
#[test]
fn lessons_have_their_words_and_no_more() {
    for name in lessons() {
        let script = source(&format!("{name}/lesson.js"));
        let words = &tables(&format!("{name}/words.*.json"))[0].2;
        let mut expected = BTreeSet::from(["title", "line", "learnt"].map(str::to_owned));
        for step in script.split("    id: \"").skip(1) {
            let id = step.split('"').next().unwrap();
            expected.extend(
                ["title", "text", "question", "hint", "right"].map(|part| format!("{id}.{part}")),
            );
            if let Some((_, list)) = step.split_once("choices: ") {
                let list = list_of(list, &script);
                expected.extend(
                    quoted(list, '"')
                        .iter()
                        .map(|one| format!("{id}.choice.{one}")),
                );
            }
            let names = step
                .split("name: \"")
                .skip(1)
                .map(|rest| rest.split('"').next().unwrap());
            expected.extend(names.map(|name| format!("{id}.show.{name}")));
            let integer = words.contains_key(&format!("{id}.right.other"));
            assert_eq!(
                step.contains("integer: true"),
                integer,
                "{name}: {id}.right"
            );
        }
        assert!(
            (3..=16).contains(&script.matches("    id: \"").count()),
            "{name}"
        );
        // What a step draws of its own is a script beside that of the lesson.
        for script in scripts(&name).values() {
            let words = quoted(script, '"').into_iter();
            expected.extend(
                words
                    .filter(|one| one.contains(".figure."))
                    .map(str::to_owned),
            );
        }
        let expected: BTreeSet<&str> = expected.iter().map(String::as_str).collect();
        assert_eq!(asked(words), expected, "{name}");
    }
}
