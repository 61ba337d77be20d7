//! Problems as English sentences, from the string tables of the page.

use std::collections::BTreeMap;

use assur::Grashof;
use assur_import::LeftOut;
use serde::{Deserialize, Serialize};
use serde_json::{Error, Map, Value};

/// Sentences about faults in files. They replace the page's sentences about its saved settings.
const OF_FILES: [(&str, &str); 2] = [
    ("problem.bad_state", "{path} has the wrong form: {detail}."),
    ("problem.not_json", "This is not JSON: {detail}."),
];

/// Prefixes of serde's messages on faults, with their replacements in JSON terms.
const FAULTS: [(&str, &str); 5] = [
    ("invalid type: ", ""),
    ("invalid value: ", ""),
    ("missing field ", "missing key "),
    ("unknown field ", "unknown key "),
    ("unknown variant ", "unknown choice "),
];

/// Prefixes of serde's names of types, with their replacements in JSON terms.
const TYPES: [(&str, &str); 16] = [
    ("struct ", "an object"),
    ("internally tagged enum ", "an object"),
    ("map", "an object"),
    ("sequence", "a list"),
    ("a sequence", "a list"),
    ("tuple ", "a list"),
    ("enum ", "a text"),
    ("string or map", "a text"),
    ("f64", "a number"),
    ("i64", "a whole number"),
    ("u64", "a whole number"),
    ("usize", "a whole number from 0 on"),
    ("u32", "a whole number from 0 on"),
    ("u8", "a whole number from 0 to 255"),
    ("a map", "an object"),
    ("unit", "null"),
];

/// English sentences by key, from the common table and from the tables of some kinds of documents.
pub(crate) struct Words(BTreeMap<String, String>);

/// A problem as serialized: its code and parameters.
#[derive(Deserialize)]
struct Written {
    code: String,
    #[serde(flatten)]
    parameters: Map<String, Value>,
}

impl Words {
    /// Reads the English sentences from the tables.
    ///
    /// # Errors
    /// A table is invalid; the workspace's tests rule this out.
    pub(crate) fn english() -> Result<Self, Error> {
        let tables = [
            include_str!("../../../lang/en.json"),
            include_str!("../../../www/kinds/scheme/words.en.json"),
            include_str!("../../../www/kinds/gear-train/words.en.json"),
            include_str!("../../../www/kinds/synthesis/words.en.json"),
        ];
        let tables = tables
            .into_iter()
            .map(serde_json::from_str::<BTreeMap<_, _>>);
        let tables = tables.collect::<Result<Vec<_>, _>>()?;
        let of_files = OF_FILES.map(|(key, text)| (key.to_owned(), text.to_owned()));
        Ok(Self(tables.into_iter().flatten().chain(of_files).collect()))
    }

    /// Returns the sentence for a problem, or the code of the problem if the tables have no sentence.
    ///
    /// # Errors
    /// A problem that cannot be written.
    pub(crate) fn sentence(&self, problem: &impl Serialize) -> Result<String, Error> {
        self.said("problem", problem)
    }

    /// Returns the sentence for a part that could not be imported from another program.
    ///
    /// # Errors
    /// A part that cannot be written.
    pub(crate) fn left_out(&self, told: &LeftOut) -> Result<String, Error> {
        self.said("import", told)
    }

    /// Returns the sentence with the key `space.code`, with its parameters filled in.
    fn said(&self, space: &str, told: &impl Serialize) -> Result<String, Error> {
        let Written { code, parameters } = serde_json::from_value(serde_json::to_value(told)?)?;
        let Some(text) = self.0.get(&format!("{space}.{code}")) else {
            return Ok(code);
        };
        let mut sentence = String::new();
        let mut rest = text.as_str();
        while let Some((before, (place, after))) = rest
            .split_once('{')
            .and_then(|(b, rest)| Some((b, rest.split_once('}')?)))
        {
            sentence += before;
            sentence += &match parameters.get(place) {
                Some(value) => filled(place, value),
                None => format!("{{{place}}}"),
            };
            rest = after;
        }
        sentence += rest;
        Ok(sentence)
    }
}

/// Formats a parameter of a sentence.
fn filled(place: &str, value: &Value) -> String {
    match value {
        // The path of a fault that concerns the whole file.
        Value::String(path) if place == "path" && [".", "?"].contains(&path.as_str()) => {
            "The file".to_owned()
        }
        Value::String(detail) if place == "detail" => shortened(&plain(detail)),
        Value::String(text) => shortened(text),
        Value::Array(all) => {
            let all: Vec<String> = all.iter().map(|one| filled(place, one)).collect();
            all.join(", ")
        }
        // A count is written with all its digits.
        Value::Number(count) if count.is_u64() => count.to_string(),
        other => match other.as_f64() {
            Some(phi) if place == "phi" => format!("{}°", short(phi.to_degrees())),
            Some(number) => short(number),
            None => other.to_string(),
        },
    }
}

/// Shortens a long text from a file to its beginning and end, for use in a message.
fn shortened(text: &str) -> String {
    const MAX_LENGTH: usize = 300;
    const END: usize = 100;
    let count = text.chars().count();
    if count <= MAX_LENGTH {
        return text.to_owned();
    }
    let beginning: String = text.chars().take(MAX_LENGTH - END).collect();
    let end: String = text.chars().skip(count - END).collect();
    format!("{beginning}…{end}")
}

/// Rewrites a serde error message in JSON terms.
fn plain(detail: &str) -> String {
    let replaced = |text: &str, words: &[(&str, &str)]| {
        let mut words = words.iter();
        let found = words.find_map(|(start, said)| Some((*said, text.strip_prefix(start)?)));
        found.map(|(said, rest)| (said.to_owned(), rest.to_owned()))
    };
    // Keeps only the JSON term for the type of an expected or found value.
    let typed = |text: &str| {
        let named = replaced(text, &TYPES);
        named.map_or_else(|| text.to_owned(), |(said, _)| said)
    };
    let (found, expected) = match detail.rsplit_once(", expected ") {
        Some((found, expected)) => (found, format!(", expected {}", typed(expected))),
        None => (detail, String::new()),
    };
    let found = match replaced(found, &FAULTS) {
        Some((said, rest)) => said + &typed(&rest),
        None => found.to_owned(),
    };
    found + &expected
}

/// Parses the number of an option.
///
/// # Errors
/// A number with a unit, with a decimal comma, or anything else that is not a number.
pub(crate) fn number(text: &str) -> Result<f64, String> {
    let said = "give a number alone, as 0.5: without a unit, which `--help` tells, and with a decimal point";
    text.trim().parse().map_err(|_| said.to_owned())
}

pub(crate) fn class(class: Grashof) -> String {
    class.code().replace('_', "-")
}

/// Formats a number with four significant digits.
pub(crate) fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    // The greatest floating-point number would be rounded up to infinity.
    let rounded = if rounded.is_finite() { rounded } else { value };
    if rounded == 0.0 || (1e-4..1e9).contains(&rounded.abs()) {
        format!("{}", rounded + 0.0)
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur::mechanism::Defect;
    use assur_file::Problem;

    #[test]
    fn places_are_filled() {
        let locked = Defect::Locked {
            mobility: -1,
            links: ["crank", "third rocker"].map(str::to_owned).to_vec(),
        };
        let words = Words::english().unwrap();
        assert_eq!(
            words.sentence(&Problem::from(locked)).unwrap(),
            "There are too many pairs or drivers (W = -1); these links are locked: crank, third rocker. Remove one of them, or a driver."
        );
        let form = Problem::BadState {
            path: ".".to_owned(),
            detail: "no {code} here".to_owned(),
        };
        assert_eq!(
            words.sentence(&form).unwrap(),
            "The file has the wrong form: no {code} here."
        );
    }

    #[test]
    fn long_texts_of_files_are_shortened() {
        let words = Words::english().unwrap();
        let long = "é".repeat(1 << 20);
        let file = format!(r#"{{"points": "{long}", "links": []}}"#);
        let problems = assur_file::document_of(&file).unwrap_err();
        let unknown = Defect::UnknownName { name: long };
        for problem in problems.into_iter().chain([unknown.into()]) {
            let said = words.sentence(&problem).unwrap();
            assert!(
                said.contains('…') && said.chars().count() < 400,
                "{}",
                said.len()
            );
        }
    }

    /// Replaces each value in each file of the catalogue by values of every JSON type.
    #[test]
    fn no_sentence_has_the_name_of_a_type_of_ours() {
        fn places(value: &Value, at: &str, all: &mut Vec<String>) {
            all.push(at.to_owned());
            for (key, inner) in value.as_object().into_iter().flatten() {
                places(inner, &format!("{at}/{key}"), all);
            }
            // The first entries of a list are representative.
            for (k, inner) in value.as_array().into_iter().flatten().take(2).enumerate() {
                places(inner, &format!("{at}/{k}"), all);
            }
        }
        let words = Words::english().unwrap();
        let mut said = std::collections::BTreeSet::new();
        let folder =
            std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../assur-file/catalogue");
        for file in std::fs::read_dir(folder).unwrap() {
            let text = std::fs::read_to_string(file.unwrap().path()).unwrap();
            let bare: Value = serde_json::from_str(&text).unwrap();
            let kind = match (&bare["pairs"], &bare["drives"]) {
                (Value::Null, Value::Null) => "linkage",
                (_, Value::Null) => "scheme",
                _ => "gear-train",
            };
            let state =
                serde_json::json!({"format": 2, "kind": kind, "document": bare, "view": {}});
            for whole in [bare, state] {
                let mut all = Vec::new();
                places(&whole, "", &mut all);
                for place in all {
                    for bad in [
                        "null",
                        "true",
                        "7",
                        "-7.5",
                        "300",
                        "\"x\"",
                        "[]",
                        "[[1]]",
                        "{}",
                        "{\"x\": 1}",
                    ] {
                        let mut whole = whole.clone();
                        *whole.pointer_mut(&place).unwrap() = serde_json::from_str(bad).unwrap();
                        let read = assur_file::document_of(&whole.to_string());
                        let problems = read.err().into_iter().flatten();
                        said.extend(problems.map(|problem| words.sentence(&problem).unwrap()));
                    }
                }
            }
        }
        assert!(said.len() > 300, "{}", said.len());
        let rust = [
            "struct", "enum", "tuple", "variant", "field", "unit", "map", "sequence", "settings",
        ];
        let rust = |word: &str| {
            let numbered = word.starts_with(['f', 'i', 'u']) && word.ends_with(['8', '2', '4']);
            let chars = word.chars().zip(word.chars().skip(1));
            let camel = chars
                .into_iter()
                .any(|(a, b)| a.is_lowercase() && b.is_uppercase());
            rust.contains(&word) || word == "usize" || numbered || camel
        };
        let rusty = said.iter().filter(|sentence| {
            // Keys of the file are not checked: they precede the fault or are in backquotes.
            let prose: String = sentence.split('`').step_by(2).collect();
            let prose = prose
                .split_once(" has the wrong form")
                .map_or(&*prose, |(_, detail)| detail);
            let mut words = prose.split(|c: char| !c.is_alphanumeric());
            words.any(rust) || sentence.contains('?')
        });
        assert_eq!(rusty.collect::<Vec<_>>(), Vec::<&String>::new());
    }

    #[test]
    fn numbers_of_options_have_no_units() {
        for (text, value) in [("0.5", 0.5), ("-3", -3.0), (" 7 ", 7.0), ("1e-3", 1e-3)] {
            assert_eq!(number(text), Ok(value));
        }
        for text in ["90deg", "90°", "1.5rad", "2 mm", "0,5", ""] {
            assert!(
                number(text).unwrap_err().contains("without a unit"),
                "{text}"
            );
        }
    }

    #[test]
    fn numbers_have_four_digits() {
        let texts = [1.0 / 3.0, -0.0, 1234567.0, 1e-9].map(short);
        assert_eq!(texts, ["0.3333", "0", "1235000", "1e-9"]);
    }
}
