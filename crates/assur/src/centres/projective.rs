//! Places of the plane with those at infinity, and lines through them, as triples: (X, Y, w) is at (X/w, Y/w), and
//! a x + b y + c = 0 is the line (a, b, c). The line through two places is their vector product, and so is the place
//! where two lines cross.

use crate::Vector;

/// A place, or a line; any multiple is the same.
pub(super) type Place = nalgebra::Vector3<f64>;

/// Farther away than this a place is at infinity.
const FARTHEST: f64 = 1e9;

/// A place in the plane.
pub(super) fn at(place: Vector) -> Place {
    Place::new(place.x, place.y, 1.0)
}

/// The place at infinity in a direction.
pub(super) fn towards(direction: Vector) -> Place {
    Place::new(direction.x, direction.y, 0.0)
}

/// Where a place is in the plane, or else the direction in which it is at infinity.
pub(super) fn affine(place: Place) -> Result<Vector, Vector> {
    let way = Vector::new(place.x, place.y);
    if way.norm() < FARTHEST * place.z.abs() {
        Ok(way / place.z)
    } else {
        Err(way.normalize())
    }
}
