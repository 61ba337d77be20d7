//! Problems as English sentences, from the string tables of the page.

use std::collections::BTreeMap;

use assur_file::Problem;
use serde_json::Value;

/// The sentence of a problem.
pub(crate) fn sentence(problem: &Problem) -> String {
    let table = table();
    // A problem holds nothing that JSON cannot.
    let said = serde_json::to_value(problem).unwrap_or_default();
    let code = said["code"].as_str().unwrap_or_default();
    let Some(text) = table.get(&format!("problem.{code}")) else {
        return code.to_owned();
    };
    let mut sentence = String::new();
    let mut rest = text.as_str();
    while let Some((before, (place, after))) = rest
        .split_once('{')
        .and_then(|(b, rest)| Some((b, rest.split_once('}')?)))
    {
        sentence += before;
        sentence += &filled(place, &said[place], &table);
        rest = after;
    }
    let detail = said["detail"].as_str();
    let detail = detail.map_or(String::new(), |detail| format!(" ({detail})"));
    sentence + rest + &detail
}

/// What the page says. Tests of the workspace check it.
fn table() -> BTreeMap<String, String> {
    serde_json::from_str(include_str!("../../../lang/en.json")).unwrap_or_default()
}

/// What stands in a place of a sentence.
fn filled(place: &str, value: &Value, table: &BTreeMap<String, String>) -> String {
    match (place, value) {
        ("path", Value::String(path)) if path == "." => text(table, "field.state"),
        ("field", Value::String(field)) => table
            .get(&format!("field.{field}"))
            .unwrap_or(field)
            .clone(),
        (_, Value::String(text)) => text.clone(),
        (_, Value::Array(all)) => {
            let all: Vec<&str> = all.iter().filter_map(Value::as_str).collect();
            all.join(", ")
        }
        ("phi", Value::Number(number)) => {
            format!(
                "{}°",
                short(number.as_f64().unwrap_or_default().to_degrees())
            )
        }
        (_, Value::Number(number)) => short(number.as_f64().unwrap_or_default()),
        _ => String::new(),
    }
}

fn text(table: &BTreeMap<String, String>, key: &str) -> String {
    table.get(key).cloned().unwrap_or_default()
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
        assert_eq!(
            sentence(&locked.into()),
            "There are too many pairs or drivers (W = -1); these links are locked: crank, third rocker."
        );
        let form = Problem::BadState {
            path: ".".to_owned(),
            detail: "no {code} here".to_owned(),
        };
        assert_eq!(
            sentence(&form),
            "These settings cannot be read: the whole record has the wrong format. (no {code} here)"
        );
    }

    #[test]
    fn numbers_have_four_digits() {
        let texts = [1.0 / 3.0, -0.0, 1234567.0, 1e-9].map(short);
        assert_eq!(texts, ["0.3333", "0", "1235000", "1e-9"]);
    }
}
