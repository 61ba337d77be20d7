//! Arrows of forces, of velocities and of the magnetic field, as filled polygons.

use assur::{Point, perpendicular};

/// Half the width of an arrow's shaft, in units of the drawing.
const SHAFT: f64 = 0.32;
/// Length of an arrow's head and half its width, in units of the drawing.
const HEAD: [f64; 2] = [2.4, 1.1];

/// The outline of an arrow; none if the arrow is too short to be visible. The head takes up at most half the length.
pub(super) fn arrow(from: Point, to: Point, unit: f64) -> Option<Vec<Point>> {
    let length = (to - from).norm();
    if length.is_nan() || length < 0.3 * unit {
        return None;
    }
    let along = (to - from) / length;
    let across = perpendicular(along);
    // A short arrow is scaled down in width, too.
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
