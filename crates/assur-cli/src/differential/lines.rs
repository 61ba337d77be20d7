//! Report on an epicyclic train as text.

use std::io::{self, Write};

use serde_json::{Map, Value};

/// Keys of the report that are printed on one line each, in this order.
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

/// Writes the report.
///
/// # Errors
/// Output that cannot be written.
pub(super) fn write(out: &mut impl Write, told: &Map<String, Value>) -> io::Result<()> {
    for key in LINES {
        if let Some(value) = told.get(key).filter(|value| !value.is_null()) {
            writeln!(out, "{key:<14} {}", in_line(value))?;
        }
    }
    ratios(out, told)?;
    let torques = ["1", "4", "3"].map(|shaft| told["torques"][shaft].to_string());
    writeln!(out, "torques 1:4:3  {}", torques.join(" : "))?;
    conditions(out, told)?;
    suggestions(out, told)?;
    for (_, note) in entries(told, "notes") {
        writeln!(out, "note           {}", in_line(note))?;
    }
    Ok(())
}

/// Writes the six speed ratios as numbers and fractions, marking the largest, then the identities between ratios.
fn ratios(out: &mut impl Write, told: &Map<String, Value>) -> io::Result<()> {
    let largest = entries(told, "largest");
    for (name, value) in entries(told, "ratios") {
        let fraction = in_line(&told["fractions"][name]).replace(", ", "/");
        let is_largest = largest.iter().any(|(_, other)| *other == name);
        let mark = if is_largest { "  largest" } else { "" };
        writeln!(out, "u {name:<12} {value} = {fraction}{mark}")?;
    }
    for (_, identity) in entries(told, "identities") {
        let terms = in_line(&identity["terms"]).replace(", ", " + ");
        writeln!(out, "identity       {terms} = {}", identity["sum"])?;
    }
    Ok(())
}

/// Writes the conditions for gears in contact and for magnets, with the two sides of each relation.
fn conditions(out: &mut impl Write, told: &Map<String, Value>) -> io::Result<()> {
    for (coupling, conditions) in shown(told, "conditions") {
        for (name, told) in conditions.as_object().into_iter().flatten() {
            let met = told["met"] == true;
            let met = if met { "met" } else { "not met" };
            let relation = in_line(&told["relation"]);
            let [left, right] = [&told["left"], &told["right"]];
            writeln!(
                out,
                "{coupling:<14} {name}: {left} {relation} {right}: {met}"
            )?;
        }
    }
    Ok(())
}

/// Writes similar trains that can be built, if the given train cannot.
fn suggestions(out: &mut impl Write, told: &Map<String, Value>) -> io::Result<()> {
    for (coupling, found) in shown(told, "suggestions") {
        if told["can_be_built"][coupling] == true {
            continue;
        }
        for train in found.as_array().into_iter().flatten() {
            let teeth = train.as_object().into_iter().flatten();
            let teeth = teeth.map(|(name, count)| format!("{name} = {count}"));
            let teeth = teeth.collect::<Vec<_>>().join(", ");
            writeln!(out, "possible       {coupling}: {teeth}")?;
        }
    }
    Ok(())
}

/// Returns those entries under a key that belong to the kinds of coupling shown in the report.
fn shown<'a>(told: &'a Map<String, Value>, key: &str) -> Vec<(&'a str, &'a Value)> {
    let couplings = entries(told, "couplings");
    let mut all = entries(told, key);
    all.retain(|(coupling, _)| couplings.iter().any(|(_, one)| one == coupling));
    all
}

/// Returns the entries under a key: those of an object with their names, those of a list with empty names. There are no
/// entries if the key is missing.
fn entries<'a>(told: &'a Map<String, Value>, key: &str) -> Vec<(&'a str, &'a Value)> {
    match told.get(key) {
        Some(Value::Object(fields)) => fields
            .iter()
            .map(|(name, one)| (name.as_str(), one))
            .collect(),
        Some(Value::Array(all)) => all.iter().map(|one| ("", one)).collect(),
        _ => vec![],
    }
}

fn in_line(value: &Value) -> String {
    match value {
        Value::String(text) => text.clone(),
        Value::Array(all) => all.iter().map(in_line).collect::<Vec<_>>().join(", "),
        other => other.to_string(),
    }
}
