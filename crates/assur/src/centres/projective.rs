//! Points of the plane, including those at infinity, and lines, as triples of homogeneous coordinates: (X, Y, w) is at
//! (X/w, Y/w), and (a, b, c) is the line a x + b y + c = 0. The line through two points is their vector product, and so
//! is the intersection of two lines.

use crate::Vector;

/// A point or a line; multiples are equal.
pub(super) type Place = nalgebra::Vector3<f64>;

/// Distance beyond which a point is at infinity.
const FARTHEST: f64 = 1e9;

/// A point in the plane.
pub(super) fn at(place: Vector) -> Place {
    Place::new(place.x, place.y, 1.0)
}

/// The point at infinity in a direction.
pub(super) fn towards(direction: Vector) -> Place {
    Place::new(direction.x, direction.y, 0.0)
}

/// Position of a point in the plane, or its direction if it is at infinity.
pub(super) fn affine(place: Place) -> Result<Vector, Vector> {
    let way = Vector::new(place.x, place.y);
    if way.norm() < FARTHEST * place.z.abs() {
        Ok(way / place.z)
    } else {
        Err(way.normalize())
    }
}
