//! What is told of a train, as lines for people.

use std::io::{self, Write};

use serde_json::{Map, Value};

/// Values of one line, in the order in which people read them; the rest is for programs.
const LINES: [&str; 14] = [
    "z1",
    "z2",
    "z2_step",
    "z4",
    "satellites",
    "w1",
    "w2",
    "w2_across",
    "w2_to_carrier",
    "w3",
    "w4",
    "mobility",
    "passive",
    "gaps",
];

/// Writes the lines.
///
/// # Errors
/// What cannot be written.
pub(super) fn write(out: &mut impl Write, told: &Map<String, Value>) -> io::Result<()> {
    for key in LINES {
        if let Some(value) = told.get(key).filter(|value| !value.is_null()) {
            writeln!(out, "{key:<14} {}", in_line(value))?;
        }
    }
    let largest: Vec<&str> = entries(told, "largest")
        .filter_map(|(_, name)| name.as_str())
        .collect();
    for (name, value) in entries(told, "ratios") {
        let fraction = in_line(&told["fractions"][&name]).replace(", ", "/");
        let mark = if largest.contains(&name.as_str()) {
            "  largest"
        } else {
            ""
        };
        writeln!(out, "u {name:<12} {value} = {fraction}{mark}")?;
    }
    for (_, identity) in entries(told, "identities") {
        let terms = in_line(&identity["terms"]).replace(", ", " + ");
        writeln!(out, "{:<14} {terms} = {}", "identity", identity["sum"])?;
    }
    writeln!(
        out,
        "{:<14} {}",
        "torques 1:4:3",
        ["1", "4", "3"]
            .map(|shaft| told["torques"][shaft].to_string())
            .join(" : ")
    )?;
    for (coupling, conditions) in entries(told, "conditions") {
        for (name, told) in conditions.as_object().into_iter().flatten() {
            let met = if told["met"] == true {
                "met"
            } else {
                "not met"
            };
            let relation = in_line(&told["relation"]);
            writeln!(
                out,
                "{coupling:<14} {name}: {} {relation} {}: {met}",
                told["left"], told["right"]
            )?;
        }
    }
    for (coupling, found) in entries(told, "suggestions") {
        let built = told["can_be_built"][&coupling] == true;
        for train in found.as_array().into_iter().flatten().filter(|_| !built) {
            let teeth = train.as_object().into_iter().flatten();
            let teeth: Vec<String> = teeth
                .map(|(name, count)| format!("{name} = {count}"))
                .collect();
            writeln!(out, "{:<14} {coupling}: {}", "possible", teeth.join(", "))?;
        }
    }
    for (_, note) in entries(told, "notes") {
        writeln!(out, "{:<14} {}", "note", in_line(&note))?;
    }
    Ok(())
}

/// What is in a list or a record; nothing where there is none.
fn entries<'a>(
    told: &'a Map<String, Value>,
    key: &str,
) -> Box<dyn Iterator<Item = (String, Value)> + 'a> {
    match told.get(key) {
        Some(Value::Object(fields)) => Box::new(
            fields
                .iter()
                .map(|(name, value)| (name.clone(), value.clone())),
        ),
        Some(Value::Array(all)) => Box::new(all.iter().map(|value| (String::new(), value.clone()))),
        _ => Box::new(std::iter::empty()),
    }
}

/// A value on one line.
fn in_line(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(all) => all.iter().map(in_line).collect::<Vec<_>>().join(", "),
        other => other.to_string(),
    }
}
