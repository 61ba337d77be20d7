//! Problems as English sentences, from the string tables of the page.

use std::collections::BTreeMap;

use assur_file::Problem;
use serde::Deserialize;
use serde_json::{Error, Map, Value};

/// The English tables: what all kinds have, and what schemes and differentials have of their own.
pub(crate) struct Words(BTreeMap<String, String>);

/// A problem as it is written for programs.
#[derive(Deserialize)]
struct Written {
    code: String,
    #[serde(flatten)]
    parameters: Map<String, Value>,
}

impl Words {
    /// # Errors
    /// A table that is none, which tests of the workspace rule out.
    pub(crate) fn english() -> Result<Self, Error> {
        let tables = [
            include_str!("../../../lang/en.json"),
            include_str!("../../../www/kinds/scheme/words.en.json"),
            include_str!("../../../www/kinds/gear-train/words.en.json"),
        ];
        let tables = tables
            .into_iter()
            .map(serde_json::from_str::<BTreeMap<_, _>>);
        let tables = tables.collect::<Result<Vec<_>, _>>()?;
        Ok(Self(tables.into_iter().flatten().collect()))
    }

    /// The sentence of a problem, or its code where there is none.
    ///
    /// # Errors
    /// A problem that cannot be written.
    pub(crate) fn sentence(&self, problem: &Problem) -> Result<String, Error> {
        let Written { code, parameters } = serde_json::from_value(serde_json::to_value(problem)?)?;
        let Some(text) = self.0.get(&format!("problem.{code}")) else {
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
                Some(value) => self.filled(place, value),
                None => format!("{{{place}}}"),
            };
            rest = after;
        }
        sentence += rest;
        if let Some(Value::String(detail)) = parameters.get("detail") {
            sentence += &format!(" ({detail})");
        }
        Ok(sentence)
    }

    /// What stands in a place of a sentence.
    fn filled(&self, place: &str, value: &Value) -> String {
        match value {
            Value::String(path) if place == "path" && path == "." => self.name("state"),
            Value::String(field) if place == "field" => self.name(field),
            Value::String(text) => text.clone(),
            Value::Array(all) => {
                let all: Vec<String> = all.iter().map(|one| self.filled(place, one)).collect();
                all.join(", ")
            }
            other => match other.as_f64() {
                Some(phi) if place == "phi" => format!("{}°", short(phi.to_degrees())),
                Some(number) => short(number),
                None => other.to_string(),
            },
        }
    }

    /// What a field is called; a dimension of a linkage as it is saved.
    fn name(&self, field: &str) -> String {
        let name = self.0.get(&format!("field.{field}"));
        name.map_or(field, String::as_str).to_owned()
    }
}

/// A number with four digits that count.
fn short(value: f64) -> String {
    let rounded: f64 = format!("{value:.3e}").parse().unwrap_or(value);
    if rounded == 0.0 || (1e-4..1e9).contains(&rounded.abs()) {
        format!("{}", rounded + 0.0)
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use assur_file::LinkageProblem;

    #[test]
    fn places_are_filled() {
        let locked = LinkageProblem::Locked {
            mobility: -1,
            links: ["crank", "third rocker"].map(str::to_owned).to_vec(),
        };
        let words = Words::english().unwrap();
        assert_eq!(
            words.sentence(&locked.into()).unwrap(),
            "There are too many pairs or drivers (W = -1); these links are locked: crank, third rocker."
        );
        let form = Problem::BadState {
            path: ".".to_owned(),
            detail: "no {code} here".to_owned(),
        };
        assert_eq!(
            words.sentence(&form).unwrap(),
            "These settings cannot be read: the whole record has the wrong format. (no {code} here)"
        );
    }

    #[test]
    fn numbers_have_four_digits() {
        let texts = [1.0 / 3.0, -0.0, 1234567.0, 1e-9].map(short);
        assert_eq!(texts, ["0.3333", "0", "1235000", "1e-9"]);
    }
}
