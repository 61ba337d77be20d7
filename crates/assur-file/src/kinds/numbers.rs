//! The numbers of a document that a lesson may vary: those that stand beside the drawing, by the paths of their fields.

use serde::Serialize;
use serde_json::Value;

use crate::Field;

/// A number of a document.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct NumberField {
    /// Where it stands, such as `wheels[0].z`.
    #[cfg_attr(test, ts(type = "string"))]
    pub field: Field,
    /// What it is.
    pub value: f64,
    /// Whether it counts, as a number of teeth does.
    pub whole: bool,
    /// Whether the engine sets it, from the pose at hand, and changes more than this field; else it is only
    /// written down.
    pub followed: bool,
}

/// A field of a document, `[]` for any place in a list, and what its number is.
pub(super) type Pattern = (&'static str, Sort);

/// What a number that is only written down is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    Measure,
    Count,
}

/// Those of a mixer.
pub(super) const MIXER: [Pattern; 10] = [
    ("l1", Sort::Measure),
    ("l2", Sort::Measure),
    ("l3", Sort::Measure),
    ("l4", Sort::Measure),
    ("z4", Sort::Count),
    ("module", Sort::Measure),
    ("wheels[].z", Sort::Count),
    ("wheels[].centre_line_deg", Sort::Measure),
    ("tracers[].x", Sort::Measure),
    ("tracers[].y", Sort::Measure),
];

/// Those of a differential.
pub(super) const GEAR_TRAIN: [Pattern; 18] = [
    ("z1", Sort::Count),
    ("z2", Sort::Count),
    ("z2_step", Sort::Count),
    ("z4", Sort::Count),
    ("satellites", Sort::Count),
    ("module_mm", Sort::Measure),
    ("axis_distance_mm", Sort::Measure),
    ("drives[].rpm", Sort::Measure),
    ("drives[].factor", Sort::Measure),
    ("drives[].start_s", Sort::Measure),
    ("span_s", Sort::Measure),
    ("magnets.peak[]", Sort::Measure),
    ("magnets.damping[]", Sort::Measure),
    ("bodies.inertia[]", Sort::Measure),
    ("bodies.mass", Sort::Measure),
    ("bodies.damping[]", Sort::Measure),
    ("members.satellite.torque", Sort::Measure),
    ("members.carrier.torque", Sort::Measure),
];

/// Those of a linkage that are no dimensions of the mechanism.
pub(super) const LINKAGE: [Pattern; 1] = [("band", Sort::Measure)];

/// Those of a synthesis.
pub(super) const SYNTHESIS: [Pattern; 6] = [
    ("frame", Sort::Measure),
    ("phi0_deg", Sort::Measure),
    ("positions[].output_deg", Sort::Measure),
    ("positions[].input_deg", Sort::Measure),
    ("positions[].coupler_deg", Sort::Measure),
    ("positions[].weight", Sort::Measure),
];

/// The numbers that a document has of these fields, in their order.
pub(super) fn written(document: &impl Serialize, patterns: &[Pattern]) -> Vec<NumberField> {
    let Ok(document) = serde_json::to_value(document) else {
        return Vec::new();
    };
    let found = patterns.iter().flat_map(|(pattern, sort)| {
        let mut found = Vec::new();
        collect(&document, String::new(), pattern, &mut found);
        found.into_iter().map(|(field, value)| NumberField {
            field: field.into(),
            value,
            whole: *sort == Sort::Count,
            followed: false,
        })
    });
    found.collect()
}

/// The numbers at the rest of a pattern within a part of a document, with their paths.
fn collect(part: &Value, path: String, rest: &str, found: &mut Vec<(String, f64)>) {
    if rest.is_empty() {
        found.extend(part.as_f64().map(|value| (path, value)));
    } else if let Some(rest) = rest.strip_prefix("[]") {
        for (index, part) in part.as_array().into_iter().flatten().enumerate() {
            collect(part, format!("{path}[{index}]"), rest, found);
        }
    } else {
        let rest = rest.trim_start_matches('.');
        let (name, rest) = rest.split_at(rest.find(['.', '[']).unwrap_or(rest.len()));
        let dot = if path.is_empty() { "" } else { "." };
        if let Some(part) = part.get(name) {
            collect(part, format!("{path}{dot}{name}"), rest, found);
        }
    }
}
