//! The numbers of a document that a lesson may vary and the page shows beside the drawing, with the paths of their
//! fields.

use serde::Serialize;
use serde_json::Value;

use crate::Field;

/// A number of a document.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct NumberField {
    /// Path of the number's field, such as `wheels[0].z`.
    #[cfg_attr(test, ts(type = "string"))]
    pub field: Field,
    /// Value of the number.
    pub value: f64,
    /// Whether only whole numbers are allowed, as for a number of teeth.
    pub whole: bool,
    /// Whether the engine sets the number, starting from the current pose, and changes other fields, too;
    /// otherwise only this field is written.
    pub followed: bool,
}

/// Path of a field, with `[]` for any index in a list, and the type of the field's number.
pub(super) type Pattern = (&'static str, Sort);

/// Type of a number that is set without the engine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    Measure,
    Count,
}

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

/// Fields of a linkage that are not dimensions of the mechanism.
pub(super) const LINKAGE: [Pattern; 10] = [
    ("band", Sort::Measure),
    ("links[].mass_kg", Sort::Measure),
    ("links[].inertia", Sort::Measure),
    ("loads[].value", Sort::Measure),
    ("springs[].stiffness", Sort::Measure),
    ("springs[].free_length", Sort::Measure),
    ("dampers[].damping", Sort::Measure),
    ("friction[].coefficient", Sort::Measure),
    ("friction[].radius", Sort::Measure),
    ("flywheel", Sort::Measure),
];

pub(super) const POSES: [Pattern; 3] = [
    ("poses[].x", Sort::Measure),
    ("poses[].y", Sort::Measure),
    ("poses[].angle_deg", Sort::Measure),
];

pub(super) const SYNTHESIS: [Pattern; 6] = [
    ("frame", Sort::Measure),
    ("phi0_deg", Sort::Measure),
    ("positions[].output_deg", Sort::Measure),
    ("positions[].input_deg", Sort::Measure),
    ("positions[].coupler_deg", Sort::Measure),
    ("positions[].weight", Sort::Measure),
];

/// The numbers in the fields that match the patterns, in the order of the patterns.
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

/// Collects the numbers in a part of a document that match the rest of a pattern, with their paths. `path` is the path
/// of the part.
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

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::super::Kind;
    use crate::{LinkageDocument, from_catalogue};

    /// Masses and loads are not dimensions of the drawing, but a lesson may vary them.
    #[test]
    fn masses_and_loads_are_numbers_of_a_linkage() {
        let mut linkage: LinkageDocument = from_catalogue("crank-rocker").unwrap().unwrap();
        linkage.links[1].mass_kg = Some(2.5);
        linkage.loads =
            serde_json::from_value(json!([{ "link": "rocker", "value": 4.0 }])).unwrap();
        let friction = json!([{ "hinge": "B", "coefficient": 0.1, "radius": 0.2 }]);
        linkage.friction = serde_json::from_value(friction).unwrap();
        let numbers = linkage.numbers().unwrap();
        for (field, value) in [
            ("links[1].mass_kg", 2.5),
            ("loads[0].value", 4.0),
            ("friction[0].coefficient", 0.1),
            ("friction[0].radius", 0.2),
        ] {
            let own = numbers.iter().find(|number| &*number.field == field);
            let own = own.unwrap_or_else(|| panic!("{field}: {numbers:?}"));
            assert_eq!((own.value, own.whole, own.followed), (value, false, false));
        }
        assert!(
            !numbers
                .iter()
                .any(|number| &*number.field == "links[0].mass_kg")
        );
    }
}
