//! Points of the plane, including those at infinity, and lines, as triples of homogeneous coordinates. As a point,
//! (X, Y, w) is at (X/w, Y/w); as a line, (a, b, c) is a x + b y + c = 0. The line through two points is the vector
//! product of their triples, and so is the intersection of two lines.

use crate::Vector;
use crate::tolerance;

/// A point or a line; multiples of a triple are equivalent.
pub(super) type Place = nalgebra::Vector3<f64>;

/// Triple of a point in the plane.
pub(super) fn at(place: Vector) -> Place {
    Place::new(place.x, place.y, 1.0)
}

/// Triple of the point at infinity in a direction.
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

#[cfg(test)]
mod tests {
    use super::*;

    /// The line through (0, 3) and (4, 0) is 3x + 4y − 12 = 0. It meets x = 4 in (4, 0), and y = x in (12/7, 12/7).
    #[test]
    fn two_points_give_a_line_and_two_lines_a_point() {
        let line = at(Vector::new(0.0, 3.0)).cross(&at(Vector::new(4.0, 0.0)));
        assert_eq!(line, Place::new(3.0, 4.0, -12.0));
        for (other, expected) in [
            ([1.0, 0.0, -4.0], [4.0, 0.0]),
            ([0.0, 1.0, 0.0], [4.0, 0.0]),
            ([1.0, -1.0, 0.0], [12.0 / 7.0, 12.0 / 7.0]),
        ] {
            let point = affine(line.cross(&Place::from(other))).unwrap();
            assert!((point - Vector::from(expected)).norm() < 1e-15, "{point}");
        }
    }

    /// 3x + 4y = 0 and 3x + 4y = 5 have the direction (4, −3).
    #[test]
    fn parallels_meet_at_infinity_along_themselves() {
        let lines = [Place::new(3.0, 4.0, 0.0), Place::new(3.0, 4.0, -5.0)];
        let direction = affine(lines[0].cross(&lines[1])).unwrap_err();
        assert!(direction.perp(&Vector::new(0.8, -0.6)).abs() < 1e-15);
        assert!((direction.norm() - 1.0).abs() < 1e-15);
    }

    /// The line from (1, 1) towards (1, 0) at infinity is y = 1.
    #[test]
    fn a_line_towards_infinity_has_its_direction() {
        let line = at(Vector::new(1.0, 1.0)).cross(&towards(Vector::new(1.0, 0.0)));
        let crossing = affine(line.cross(&Place::new(1.0, 0.0, -7.0))).unwrap();
        assert_eq!(crossing, Vector::new(7.0, 1.0));
    }

    /// The three points (0, 1), (2, 2) and (4, 3) are on one line, so their determinant is zero. If the third point is
    /// (4, 4), the determinant is 2.
    #[test]
    fn the_determinant_of_points_on_a_line_is_zero() {
        let [a, b] = [[0.0, 1.0], [2.0, 2.0]].map(|place| at(Vector::from(place)));
        for (y, determinant) in [(3.0, 0.0), (4.0, 2.0)] {
            assert_eq!(a.cross(&b).dot(&at(Vector::new(4.0, y))), determinant);
        }
    }
}
