//! Structure of a mechanism: drivers and Assur groups, the inputs over which it moves, and its outputs.

mod outputs;

use std::f64::consts::TAU;
use std::io::Write;

use assur::mechanism::{LinkId, Mechanism};
use assur::motion::DeadPointKind;
use assur::structure::{Step, roman};
use serde_json::{Value, json};

use crate::Failure;
use crate::source::{Moved, Name};

/// Writes the structure, as text or as JSON.
///
/// # Errors
/// A mechanism without links; output that cannot be written.
pub(crate) fn write<W: Write>(
    out: &mut W,
    moved: &Moved,
    name: &Name,
    as_json: bool,
) -> Result<(), Failure> {
    let described = described(moved, moved.output(name)?);
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
    for key in ["links", "mobility", "class", "formula"] {
        writeln!(out, "{key:<12} {}", word(&described[key]))?;
    }
    let more = match &described["assemblies_whole"] {
        Value::Bool(true) => "",
        _ => ", and there may be more",
    };
    let assemblies = format!(
        "{} at {}{more}",
        described["assemblies"],
        at(&described["assemblies_at"])
    );
    writeln!(out, "{:<12} {assemblies}", "assemblies")?;
    if described["q"] != json!(0) {
        let [count, rank, q] = ["w_count", "w_rank", "q"].map(|key| &described[key]);
        let pairs = word(&described["redundant"]);
        let said = format!("{pairs} (W = {count} by count, {rank} by rank; q = {q})");
        writeln!(out, "{:<12} {said}", "redundant")?;
    }
    if described["passive"]
        .as_array()
        .is_some_and(|passive| !passive.is_empty())
    {
        writeln!(out, "{:<12} {}", "passive", word(&described["passive"]))?;
    }
    for (k, step) in described["steps"]
        .as_array()
        .into_iter()
        .flatten()
        .enumerate()
    {
        let dyad = step["dyad"].as_str().unwrap_or_default();
        let said = format!("{} {dyad}", word(&step["symbol"]));
        writeln!(out, "{:<12} {said:<8} {}", k + 1, word(&step["links"]))?;
    }
    let list = |key: &str| described[key].as_array().into_iter().flatten();
    let line = |out: &mut W, key: &str, said: &str| writeln!(out, "{key:<12} {said}");
    let repeats = match &described["turns"] {
        Value::Null => String::new(),
        turns if *turns == json!(1) => ", repeats after 1 turn".to_owned(),
        turns => format!(", repeats after {turns} turns"),
    };
    for arc in list("range") {
        let [from, to] = ["from", "to"].map(|end| at(&arc[end]));
        line(out, "range", &format!("{from} to {to}{repeats}"))?;
    }
    for end in list("dead_points") {
        let [kind, links] = ["kind", "links"].map(|key| word(&end[key]));
        line(out, "dead point", &format!("{} {kind}: {links}", at(end)))?;
    }
    for end in list("followed_to") {
        let [kind, links] = ["kind", "links"].map(|key| word(&end[key]));
        let why = match kind.as_str() {
            "near_singular" => format!("too near to a singular pose to follow: {links}"),
            _ => "it goes on for longer than it is followed".to_owned(),
        };
        line(out, "ends", &format!("{} {why}", at(end)))?;
    }
    for change in list("change_points") {
        line(out, "change point", &at(change))?;
    }
    for (key, said) in outputs::lines(&described, moved.motion.mechanism().size()) {
        line(out, key, &said)?;
    }
    Ok(())
}

/// Formats an input, as the JSON report gives it, for the text report.
fn at(input: &Value) -> String {
    match input["phi_deg"].as_f64() {
        Some(degrees) => rounded(degrees),
        None => input["s"].to_string(),
    }
}

/// Formats an angle, rounded to a millionth of a degree.
fn rounded(degrees: f64) -> String {
    format!("{}°", (degrees * 1e6).round() / 1e6 + 0.0)
}

/// Returns the JSON key and the value of an input: degrees of a crank, or the displacement of a driven slide.
fn placed(mechanism: &Mechanism, input: f64) -> (&'static str, f64) {
    if mechanism.turns() {
        ("phi_deg", input.to_degrees())
    } else {
        ("s", input)
    }
}

fn described(moved: &Moved, output: LinkId) -> Value {
    let motion = &moved.motion;
    let mechanism = motion.mechanism();
    let assemblies = motion.assemblies_at(motion.drawn_input(), output);
    let drawn = motion.pose::<1>(motion.drawn_input()).ok();
    let drawn = drawn.and_then(|pose| mechanism.number_of(&pose, &assemblies.poses));
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
    let doubled = mechanism.doubled().iter().map(|doubled| {
        json!({
            "symbol": doubled.symbol(),
            "class": 1,
            "order": doubled.shared.len(),
            "dyad": null,
            "links": [mechanism.link_name(doubled.link)],
        })
    });
    let at = |input: f64| {
        let (key, at) = placed(mechanism, input);
        json!({key: at})
    };
    let cycle = motion.cycle();
    let range = cycle.arcs().iter();
    let range = range.map(|[from, to]| json!({"from": at(*from), "to": at(*to)}));
    let turns = cycle.period().filter(|_| cycle.is_full());
    let turns = turns.map(|period| (period / TAU).round() as u64);
    let ends = |of: fn(DeadPointKind) -> bool| -> Vec<Value> {
        let ends = motion.dead_points().iter().filter(|end| of(end.kind));
        let told = ends.map(|end| {
            let (key, at) = placed(mechanism, end.input);
            let links: Vec<&str> = motion.links_at(end).collect();
            json!({key: at, "kind": end.kind.code(), "links": links})
        });
        told.collect()
    };
    let unfollowed = |kind: DeadPointKind| !kind.is_dead_point() && kind != DeadPointKind::Range;
    let change_points = motion.change_points().iter().copied().map(at);
    let mobility = mechanism.mobility();
    let passive = mechanism.passive_wheels();
    let passive = passive.map(|wheel| mechanism.link_name(wheel));
    let mut described = json!({
        "links": mechanism.links().collect::<Vec<_>>(),
        "drivers": drivers(mechanism),
        // The number of drivers equals the degree of freedom.
        "mobility": driving,
        "w_count": mobility.by_count,
        "w_rank": mobility.by_rank,
        "q": mobility.q(),
        // Names of the pairs with redundant constraints: points, slides, gears, then hinges of doubled links.
        "redundant": mobility.redundant,
        "class": roman(structure.class()),
        "formula": mechanism.formula(),
        // Wheels whose constraint repeats that of others, such as further satellites.
        "passive": passive.collect::<Vec<_>>(),
        // Number of assemblies at the drawn input; the drawn input; whether all assemblies were found.
        "assemblies": assemblies.poses.len(),
        "assemblies_at": at(motion.drawn_input()),
        "assemblies_whole": assemblies.whole,
        "drawn_assembly": drawn.map(|number| number + 1),
        "steps": steps.chain(doubled).collect::<Vec<_>>(),
        "turns_fully": cycle.is_full() && mechanism.turns(),
        "range": range.collect::<Vec<_>>(),
        // Number of turns after which the motion repeats; null if the driver turns back.
        "turns": turns,
        "dead_points": ends(DeadPointKind::is_dead_point),
        // Inputs at which the motion continues, but was not followed further.
        "followed_to": ends(unfollowed),
        "change_points": change_points.collect::<Vec<_>>(),
    });
    if let Value::Object(fields) = &mut described {
        fields.append(&mut outputs::described(moved));
    }
    described
}

/// Returns the driven links, with their rates as multiples of the first driver's rate.
fn drivers(mechanism: &Mechanism) -> Vec<Value> {
    let draft = mechanism.spec();
    let drivers = draft.drivers.iter();
    let drivers =
        drivers.map(|driver| json!({"link": draft.driven(driver), "rate": driver.rate()}));
    drivers.collect()
}
