//! The dimensions of a linkage, as the page lists them.

use assur::mechanism::Dimension;
use assur_draw::Role;
use assur_file::{Field, dimension_field};
use serde::Serialize;

use crate::moving::Moving;

/// A dimension: its field in the document, what it is of, its value and those it may
/// have. `kind` is `length`, `x` or `y`; `index` counts the links or points from 0.
#[derive(Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub(crate) struct DimensionSummary<'a> {
    #[cfg_attr(test, ts(type = "string"))]
    field: Field,
    #[cfg_attr(test, ts(type = "\"length\" | \"x\" | \"y\""))]
    kind: &'static str,
    index: usize,
    name: &'a str,
    role: &'static str,
    value: f64,
    min: f64,
    max: f64,
    step: f64,
}

/// A slider goes in so many steps at least, a power of ten each.
const STEPS: f64 = 200.0;

/// The step of a slider over a range, and its ends on whole steps.
fn stepped(range: [f64; 2]) -> ([f64; 2], f64) {
    let digits = ((range[1] - range[0]) / STEPS).log10().floor() as i32;
    // Divided by a whole number a whole number comes as near to its decimals as it can.
    let (times, parts) = (10_f64.powi(digits.max(0)), 10_f64.powi(-digits.min(0)));
    let whole = |steps: f64| steps * times / parts;
    let ends = range.map(|end| whole((end / times * parts).round()));
    (ends, whole(1.0))
}

impl<'a> DimensionSummary<'a> {
    pub(crate) fn all(moving: &'a Moving) -> Vec<Self> {
        let mechanism = moving.mechanism();
        let summed = |dimension: Dimension| {
            let (kind, index, name, role) = match dimension {
                Dimension::Length(link) => (
                    "length",
                    link.index(),
                    mechanism.link_name(link),
                    moving.figure().role(link).name(),
                ),
                Dimension::X(point) => (
                    "x",
                    point.index(),
                    mechanism.point_name(point),
                    Role::Secondary.name(),
                ),
                Dimension::Y(point) => (
                    "y",
                    point.index(),
                    mechanism.point_name(point),
                    Role::Secondary.name(),
                ),
            };
            let ([min, max], step) = stepped(mechanism.range(dimension)?);
            Some(Self {
                field: dimension_field(dimension),
                kind,
                index,
                name,
                role,
                value: mechanism.value(dimension)?,
                min,
                max,
                step,
            })
        };
        mechanism
            .dimensions()
            .into_iter()
            .filter_map(summed)
            .collect()
    }
}
