//! String tables in the folders of the kinds of document: a new kind needs no change here.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use assur_tests::files::{root, scripts, source};

use super::{BUILT, Words, names, page_words, quoted, snake, tables};

/// A kind whose folder has words.
pub(crate) struct Kind {
    id: String,
    /// Its scripts, and what the engine and the files have of it.
    sources: BTreeMap<String, String>,
}

impl Kind {
    /// Where its tables stand; `*` for the language: those of the first view and, if there are any, those that are
    /// loaded with the kind.
    pub(crate) fn places(&self) -> impl Iterator<Item = String> {
        let places = ["words", "later"].map(|name| format!("www/kinds/{}/{name}.*.json", self.id));
        let there = |place: &String| root().join(place.replace('*', "en")).exists();
        places.into_iter().filter(there)
    }

    pub(crate) fn words(&self) -> Words {
        let tables = self.places().map(|place| tables(&place).swap_remove(0).2);
        tables.flatten().collect()
    }

    /// How the keys begin that its scripts build.
    fn starts(&self) -> BTreeSet<&str> {
        let scripts = self
            .sources
            .iter()
            .filter(|(path, _)| path.ends_with(".js"));
        let built = scripts.flat_map(|(_, text)| quoted(text, '`'));
        let starts = built.filter_map(|built| built.split_once("${"));
        starts.map(|(start, _)| start).collect()
    }

    /// Whether one of its sources names this.
    fn names(&self, word: &str) -> bool {
        self.sources.keys().any(|source| names(source, word)) || self.has_field(word)
    }

    /// Whether its files name this part of an entry of a list: `positions.weight`, where they say
    /// `positions[{k}].weight`.
    fn has_field(&self, name: &str) -> bool {
        let Some((list, part)) = name.split_once('.') else {
            return false;
        };
        let of_entry = |text: &&str| {
            let rest = text
                .strip_prefix(list)
                .and_then(|rest| rest.strip_prefix('['));
            rest.and_then(|rest| rest.split_once("]."))
                .is_some_and(|(_, found)| found == part)
        };
        self.sources
            .values()
            .any(|text| quoted(text, '"').iter().any(of_entry))
    }

    /// Whether a key, or what is left of it, is one that scripts build of this kind: they begin it, and the rest
    /// is named in the kind's sources or built there itself.
    pub(crate) fn builds(&self, key: &str) -> bool {
        let own = self.starts();
        let starts = BUILT.iter().map(|(start, _)| *start).chain(own);
        let mut rests = starts
            .filter_map(|start| key.strip_prefix(start))
            .filter(|rest| *rest != key);
        rests.any(|rest| self.names(rest) || self.builds(rest))
    }

    /// Whether a script of this kind builds keys of its own that begin so.
    pub(crate) fn begins(&self, script: &str, start: &str) -> bool {
        script.starts_with(&format!("www/kinds/{}/", self.id))
            && self.words().keys().any(|key| key.starts_with(start))
    }
}

/// The kinds that have words.
pub(crate) fn kinds() -> Vec<Kind> {
    let entries = fs::read_dir(root().join("www/kinds")).unwrap();
    let folders = entries.map(|entry| entry.unwrap().path());
    let worded = folders.filter(|path| path.join("words.en.json").exists());
    let ids = worded.map(|path| path.file_name().unwrap().to_str().unwrap().to_owned());
    let mut found: Vec<Kind> = ids
        .map(|id| Kind {
            sources: sources(&id),
            id,
        })
        .collect();
    found.sort_unstable_by(|one, other| one.id.cmp(&other.id));
    assert!(!found.is_empty());
    found
}

/// Modules that are not of one kind and name problems or conditions of its documents.
const SHARED: [(&str, &[&str]); 4] = [
    (
        "scheme",
        &[
            "crates/assur-file/src/problem.rs",
            "crates/assur/src/mobility/spec.rs",
            "crates/assur/src/mobility/cut.rs",
        ],
    ),
    (
        "gear-train",
        &["crates/assur/src/gears/train/conditions.rs"],
    ),
    (
        "point-path",
        &["crates/assur-web/src/kinds/synthesis/summary.rs"],
    ),
    (
        "poses",
        &[
            "crates/assur/src/synthesis/poses/verdict.rs",
            "crates/assur-web/src/kinds/synthesis/summary.rs",
        ],
    ),
];

/// The scripts of a kind and its modules of every crate, by their paths.
fn sources(id: &str) -> BTreeMap<String, String> {
    let mut found = scripts(&format!("www/kinds/{id}"));
    let shared = SHARED.iter().filter(|(kind, _)| *kind == id);
    for path in shared.flat_map(|(_, paths)| *paths) {
        modules(path, &mut found);
    }
    let id = id.replace('-', "_");
    for entry in fs::read_dir(root().join("crates")).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let folder = format!("crates/{name}/src/kinds");
        for path in [format!("{folder}/{id}.rs"), format!("{folder}/{id}")] {
            modules(&path, &mut found);
        }
    }
    found
}

/// Puts a module, or those of a folder, to the others.
fn modules(path: &str, found: &mut BTreeMap<String, String>) {
    let place = root().join(path);
    if place.is_dir() {
        for entry in fs::read_dir(place).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            modules(&format!("{path}/{name}"), found);
        }
    } else if place.exists() {
        found.insert(path.to_owned(), source(path));
    }
}

/// The build puts all of them into the tables of the page: none may take the place of another.
#[test]
fn no_two_tables_have_the_same_key() {
    let mut all: BTreeSet<String> = tables(super::PAGE).swap_remove(0).2.into_keys().collect();
    for kind in kinds() {
        for key in kind.words().into_keys() {
            assert!(!all.contains(&key), "{}: {key}", kind.id);
            all.insert(key);
        }
    }
}

/// What can be wrong with a kind's document is a variant of an enum of codes in its modules.
#[test]
fn every_problem_of_a_kind_has_words() {
    let words = page_words();
    let mut count = 0;
    for kind in kinds() {
        for (path, text) in &kind.sources {
            for variant in variants(text) {
                let key = format!("problem.{}", snake(variant));
                assert!(words.contains_key(&key), "{path}: {key}");
                count += 1;
            }
        }
    }
    assert!(count > 0);
}

/// The variants of the enums of a module that are written with a code; not those written as another one.
fn variants(text: &str) -> Vec<&str> {
    let enums = text.split("tag = \"code\"").skip(1);
    let problems = enums.filter_map(|rest| rest.split_once("\npub enum "));
    let bodies = problems.filter_map(|(_, rest)| rest.split_once("\n}"));
    let lines = bodies.flat_map(|(body, _)| body.lines());
    let names = lines.filter_map(|line| line.strip_prefix("    "));
    let names = names.filter(|line| line.starts_with(|c: char| c.is_ascii_uppercase()));
    // A variant that holds another enum has the codes of that enum.
    let codes = names.filter(|line| !line.contains('('));
    codes
        .filter_map(|line| line.split(|c: char| !c.is_alphanumeric()).next())
        .collect()
}

/// A row of the rail has a short name, and its field a long one; a slider as well where it has one.
#[test]
fn every_row_of_a_kind_has_its_names() {
    for kind in kinds() {
        let words = kind.words();
        for key in words.keys() {
            for start in ["name.", "slider."] {
                let Some(field) = key.strip_prefix(start) else {
                    continue;
                };
                for other in ["name.", "field."] {
                    assert!(
                        words.contains_key(&format!("{other}{field}")),
                        "{}: {other}{field}",
                        kind.id
                    );
                }
            }
        }
    }
}
