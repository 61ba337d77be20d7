//! Traced points of a specification: points on a link that join nothing.

use std::collections::BTreeSet;

use super::spec::{Defect, FRAME, LinkageSpec};
use crate::Vector;

/// A traced point: a point on a link that joins nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct TracerSpec {
    /// Name of the traced point; no other point, traced or not, has it.
    pub name: String,
    /// Link that carries the traced point, or the frame.
    pub link: String,
    /// Position of the traced point in the coordinates of its link. Their origin is the link's first point. The x-axis
    /// runs to the second point, in the direction of the link's angle; for a wheel with one point, in the wheel's zero
    /// direction. For the frame, the coordinates are those of the drawing.
    pub at: Vector,
}

impl LinkageSpec {
    /// Adds a traced point at (x, y) in the coordinates of a link.
    #[must_use]
    pub fn tracer(mut self, name: &str, link: &str, x: f64, y: f64) -> Self {
        self.tracers.push(TracerSpec {
            name: name.to_owned(),
            link: link.to_owned(),
            at: Vector::new(x, y),
        });
        self
    }
}

/// The defects of the traced points of a specification; `sound` is true for an admissible coordinate.
pub(super) fn defects(spec: &LinkageSpec, sound: impl Fn(f64) -> bool) -> Vec<Defect> {
    let names = spec.points.iter().map(|point| point.name.as_str());
    let mut names: BTreeSet<&str> = names.collect();
    let mut found = Vec::new();
    for TracerSpec { name, link, at } in &spec.tracers {
        if !names.insert(name) {
            found.push(Defect::Twice { name: name.clone() });
        }
        if link != FRAME && spec.link(link).is_none() {
            found.push(Defect::UnknownName { name: link.clone() });
        }
        if !sound(at.x) || !sound(at.y) {
            found.push(Defect::NotFinite { name: name.clone() });
        }
    }
    found
}
