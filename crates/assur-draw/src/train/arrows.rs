//! Arrows of forces and of the field as filled shapes, many to one record.

use assur::{Point, perpendicular};

/// Half the width of a shaft, and length and half the width of a head, in units.
const SHAFT: f64 = 0.32;
const HEAD: [f64; 2] = [2.4, 1.1];

/// The outline of an arrow; none if it is too short to be visible. Its head is at most half as
/// long.
pub(super) fn arrow(from: Point, to: Point, unit: f64) -> Option<Vec<Point>> {
    let length = (to - from).norm();
    if length.is_nan() || length < 0.3 * unit {
        return None;
    }
    let along = (to - from) / length;
    let across = perpendicular(along);
    // A small arrow is small in all.
    let size = (0.5 * length / (HEAD[0] * unit)).min(1.0) * unit;
    let neck = to - along * (HEAD[0] * size);
    let [shaft, head] = [SHAFT, HEAD[1]].map(|half| across * (half * size));
    Some(vec![
        from - shaft,
        neck - shaft,
        neck - head,
        to,
        neck + head,
        neck + shaft,
        from + shaft,
    ])
}
