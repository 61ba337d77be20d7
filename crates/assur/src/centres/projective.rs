//! Points of the plane, including those at infinity, and lines, as triples of homogeneous coordinates. As a point,
//! (X, Y, w) is at (X/w, Y/w); as a line, (a, b, c) is a x + b y + c = 0. The line through two points is the vector
//! product of their triples, and so is the intersection of two lines.

use crate::Vector;
use crate::tolerance;

/// A point or a line; multiples of a triple are equivalent.
pub(super) type Place = nalgebra::Vector3<f64>;

/// A point in the plane.
pub(super) fn at(place: Vector) -> Place {
    Place::new(place.x, place.y, 1.0)
}

/// The point at infinity in a direction.
pub(super) fn towards(direction: Vector) -> Place {
    Place::new(direction.x, direction.y, 0.0)
}

/// Position of a point in the plane, or its direction if the point is at infinity.
pub(super) fn affine(place: Place) -> Result<Vector, Vector> {
    let way = Vector::new(place.x, place.y);
    if tolerance::COINCIDENT * way.norm() < place.z.abs() {
        Ok(way / place.z)
    } else {
        Err(way.normalize())
    }
}
