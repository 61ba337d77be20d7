//! Mobility and redundant constraints: by counting, by sections and by rank.

use std::io::Write;

use assur::mobility::{Cut, Generic, RankReport, Scheme, Sections, Space};
use assur_file::{KindDocument, Problem};
use serde_json::{Map, Value, json};

use crate::Failure;
use crate::source::{Name, Schemed, refused, schemed};

/// Maximum number of replacements in the report.
const REPLACEMENTS: usize = 20;

/// Keys of the lines of the report, in order.
const LINES: [&str; 21] = [
    "n",
    "pairs",
    "cuts",
    "w_open",
    "removed",
    "removed_spatial",
    "w",
    "w_planar",
    "w_spatial",
    "w_by_loops",
    "q",
    "q_by_sections",
    "loops",
    "rank_w",
    "rank_w_nearby",
    "rank_w_spatial",
    "rank_q",
    "redundant",
    "redundant_in_plane",
    "idle",
    "replacements",
];

/// Writes the report, as text or as JSON. The pairs to cut are those given on the command line, or else in the
/// document, or else chosen automatically.
///
/// # Errors
/// A document that is neither a scheme nor a linkage; cut pairs that are unknown, leave a contour closed or disconnect
/// links; output that cannot be written.
pub(crate) fn write(
    out: &mut impl Write,
    name: &Name,
    cut: Option<&[String]>,
    as_json: bool,
) -> Result<(), Failure> {
    let Schemed { scheme, cuts } = schemed(name)?;
    let refuse = |error| refused(name, &[Problem::from(error)]);
    let cuts: Vec<Cut> = match cut {
        Some(names) => {
            // Empty names between commas are ignored.
            let names = names.iter().filter(|name| !name.is_empty());
            let cuts = names
                .map(|name| scheme.cut_named(name))
                .collect::<Result<_, _>>();
            cuts.map_err(refuse)?
        }
        None if cuts.is_empty() => scheme.automatic(),
        None => cuts,
    };
    let sections = scheme.sections(&cuts).map_err(refuse)?;
    let mut told = counted(&scheme, &sections);
    told.append(&mut rank_report(&scheme));
    if as_json {
        writeln!(out, "{:#}", Value::Object(told))?;
        return Ok(());
    }
    for key in LINES {
        let value = &told[key];
        let lines = match value {
            Value::Object(numbers) => vec![numbers_of_pairs(numbers)],
            Value::Array(all) if all.iter().any(Value::is_object) => {
                all.iter().map(in_line).collect()
            }
            other => vec![in_line(other)],
        };
        for line in lines.iter().filter(|line| !line.is_empty()) {
            writeln!(out, "{key:<18} {line}")?;
        }
    }
    Ok(())
}

/// Formats the numbers of pairs as P1 = …, P2 = ….
fn numbers_of_pairs(numbers: &Map<String, Value>) -> String {
    let numbers = numbers.iter().map(|(i, count)| format!("P{i} = {count}"));
    numbers.collect::<Vec<_>>().join(", ")
}

/// Formats a value on one line; the text is empty for null.
fn in_line(value: &Value) -> String {
    match value {
        Value::Null => String::new(),
        Value::String(text) => text.clone(),
        Value::Array(all) => all.iter().map(in_line).collect::<Vec<_>>().join(", "),
        Value::Object(fields) => {
            let fields = fields.iter().filter(|(_, value)| !value.is_null());
            let fields = fields.map(|(key, value)| format!("{key} {}", in_line(value)));
            fields.collect::<Vec<_>>().join("; ")
        }
        other => other.to_string(),
    }
}

fn fields(value: Value) -> Map<String, Value> {
    match value {
        Value::Object(fields) => fields,
        _ => Map::new(),
    }
}

/// Returns mobility and redundant constraints by counting and by sections.
fn counted(scheme: &Scheme, sections: &Sections) -> Map<String, Value> {
    let counts = scheme.counts();
    let numbered = |pairs: &std::collections::BTreeMap<u8, usize>| {
        let pairs = pairs.iter().map(|(i, count)| (i.to_string(), json!(count)));
        Value::Object(pairs.collect())
    };
    let loops = sections.loops.iter().map(|closed| {
        json!({
            "cut": scheme.cut_name(closed.cut),
            "pairs": pair_names(scheme, &closed.pairs),
            "constraints": closed.constraints,
            "spatial_constraints": closed.spatial_constraints,
            "motion_space": closed.motion_space,
            "q": closed.redundant,
        })
    });
    let cuts = sections.cuts.iter().map(|cut| scheme.cut_name(*cut));
    fields(json!({
        "planar": scheme.is_planar(),
        "n": counts.links,
        "pairs": numbered(&counts.pairs),
        "spatial_pairs": numbered(&counts.spatial_pairs),
        "cuts": cuts.collect::<Vec<_>>(),
        "w_open": sections.open,
        "removed": sections.removed,
        "w": sections.mobility,
        "w_open_spatial": sections.open_spatial,
        "removed_spatial": sections.removed_spatial,
        "w_planar": counts.planar,
        "w_spatial": counts.spatial,
        "w_by_loops": sections.by_loops(),
        "q": counts.redundant(counts.mobility()),
        "q_by_sections": sections.redundant,
        "q_by_plane": counts.redundant_by_plane(),
        "loops": loops.collect::<Vec<_>>(),
    }))
}

/// Returns mobility and redundant constraints by rank, in space and, for a planar scheme, in the
/// plane. All values are null if positions, axes or kinds of pairs are missing.
fn rank_report(scheme: &Scheme) -> Map<String, Value> {
    let own = if scheme.is_planar() {
        Space::Plane
    } else {
        Space::Whole
    };
    let space = scheme.rank_report(Space::Whole).ok();
    let verdict = scheme.rank_report(own).ok();
    let parts = |verdict: &Option<RankReport>| {
        verdict.as_ref().map(|verdict| {
            let parts = verdict
                .redundancies
                .iter()
                .map(|part| json!({"count": part.count, "pairs": pair_names(scheme, &part.pairs)}));
            parts.collect::<Vec<_>>()
        })
    };
    let redundant = |verdict: &RankReport| -> usize {
        verdict.redundancies.iter().map(|part| part.count).sum()
    };
    let idle = verdict.as_ref().map(|verdict| {
        let idle = verdict.idle.iter().map(|links| {
            links
                .iter()
                .map(|link| scheme.link_name(*link))
                .collect::<Vec<_>>()
        });
        idle.collect::<Vec<_>>()
    });
    let generic = scheme.generic(own).ok().map(|generic| match generic {
        Generic::At { mobility } => json!(mobility),
        Generic::Contact { .. } => json!("contact"),
        _ => json!("instantaneous"),
    });
    let replacements = scheme.replacements(REPLACEMENTS).ok();
    let complete = replacements.as_ref().map(|found| found.complete);
    let replacements = replacements.map(|found| {
        let replacements = found.list.iter().map(|replacement| {
            let changes = replacement.changes.iter().map(|change| {
                let name = scheme.pairs()[change.pair].name.clone();
                (name, json!(KindDocument::from(change.kind)))
            });
            Value::Object(changes.collect())
        });
        replacements.collect::<Vec<_>>()
    });
    fields(json!({
        "rank_w": verdict.as_ref().map(|verdict| verdict.mobility),
        "rank_w_nearby": generic,
        "rank_w_spatial": space.as_ref().map(|verdict| verdict.mobility),
        "rank_q": space.as_ref().map(redundant),
        "redundant": parts(&space),
        "redundant_in_plane": if scheme.is_planar() { parts(&verdict) } else { None },
        "idle": idle,
        "replacements": replacements,
        "replacements_complete": complete,
    }))
}

fn pair_names<'a>(scheme: &'a Scheme, pairs: &[usize]) -> Vec<&'a str> {
    let names = pairs.iter().map(|pair| scheme.pairs()[*pair].name.as_str());
    names.collect()
}
