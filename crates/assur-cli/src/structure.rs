//! What a mechanism is made of: drivers and Assur groups.

use std::io::Write;

use assur::mechanism::Mechanism;
use assur::motion::{DeadPointKind, Motion};
use assur::structure::{Step, roman};
use serde_json::{Value, json};

use crate::Failure;

/// Writes the structure, as lines for people or as JSON.
///
/// # Errors
/// What cannot be written.
pub(crate) fn write(out: &mut impl Write, motion: &Motion, as_json: bool) -> Result<(), Failure> {
    let described = described(motion);
    if as_json {
        writeln!(out, "{described:#}")?;
        return Ok(());
    }
    let word = |value: &Value| match value {
        Value::String(text) => text.clone(),
        Value::Array(all) => {
            let all: Vec<&str> = all.iter().filter_map(Value::as_str).collect();
            all.join(", ")
        }
        other => other.to_string(),
    };
    for key in ["links", "mobility", "class", "formula", "assemblies"] {
        writeln!(out, "{key:<11} {}", word(&described[key]))?;
    }
    if described["passive"]
        .as_array()
        .is_some_and(|passive| !passive.is_empty())
    {
        writeln!(out, "{:<11} {}", "passive", word(&described["passive"]))?;
    }
    for (k, step) in described["steps"]
        .as_array()
        .into_iter()
        .flatten()
        .enumerate()
    {
        let dyad = step["dyad"].as_str().unwrap_or_default();
        let said = format!("{} {dyad}", word(&step["symbol"]));
        writeln!(out, "{:<11} {said:<8} {}", k + 1, word(&step["links"]))?;
    }
    for end in described["dead_points"].as_array().into_iter().flatten() {
        let at = end["phi_deg"].as_f64().map(|at| format!("{at:.6}°"));
        let at = at.unwrap_or_else(|| end["s"].to_string());
        writeln!(
            out,
            "{:<11} {at} {}: {}",
            "dead point",
            word(&end["kind"]),
            word(&end["links"])
        )?;
    }
    Ok(())
}

fn described(motion: &Motion) -> Value {
    let mechanism = motion.mechanism();
    let structure = mechanism.structure();
    let names = |links: &[usize]| -> Vec<String> {
        links
            .iter()
            .filter_map(|link| mechanism.body_names().nth(*link))
            .map(str::to_owned)
            .collect()
    };
    let driving = structure.steps.iter();
    let driving = driving
        .filter(|step| matches!(step, Step::Driver { .. }))
        .count();
    let steps = structure.steps.iter().map(|step| match step {
        Step::Driver { links, .. } => json!({"symbol": "I", "links": names(links)}),
        Step::Group(group) => json!({
            "symbol": group.symbol(),
            "class": group.class,
            "order": group.order(),
            "dyad": group.dyad.map(|dyad| format!("{dyad:?}")),
            "links": names(&group.links()),
        }),
    });
    let key = if mechanism.turns() { "phi_deg" } else { "s" };
    let ends = motion.dead_points().iter();
    let ends = ends
        .filter(|end| end.kind != DeadPointKind::Range)
        .map(|end| {
            let at = if mechanism.turns() {
                end.input.to_degrees()
            } else {
                end.input
            };
            let links: Vec<&str> = motion.links_at(end).collect();
            json!({key: at, "kind": end.kind.code(), "links": links})
        });
    let passive = mechanism.passive_wheels();
    let passive = passive.map(|wheel| mechanism.link_name(wheel));
    json!({
        "links": mechanism.links().collect::<Vec<_>>(),
        "drivers": drivers(mechanism),
        // Of a mechanism there are as many drivers as freedoms.
        "mobility": driving,
        "class": roman(structure.class()),
        "formula": mechanism.formula(),
        // Wheels that repeat what others do, as further satellites.
        "passive": passive.collect::<Vec<_>>(),
        "assemblies": mechanism.assemblies(),
        "drawn_assembly": mechanism.drawn_assembly() + 1,
        "steps": steps.collect::<Vec<_>>(),
        "turns_fully": motion.cycle().is_full() && mechanism.turns(),
        "dead_points": ends.collect::<Vec<_>>(),
    })
}

/// What is driven, and at which rates to the first.
fn drivers(mechanism: &Mechanism) -> Vec<Value> {
    let draft = mechanism.draft();
    let drivers = draft.drivers.iter();
    let drivers =
        drivers.map(|driver| json!({"link": draft.driven(driver), "rate": driver.rate()}));
    drivers.collect()
}
