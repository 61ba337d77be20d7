//! Points and vectors of the plane. They are distinct types of nalgebra, so adding two points does not compile.

use crate::Jet;

/// A position in the plane.
pub type Point = nalgebra::Point2<f64>;

/// A displacement in the plane.
pub type Vector = nalgebra::Vector2<f64>;

/// Rotates a vector through a quarter turn to the left.
pub fn perpendicular(vector: Vector) -> Vector {
    Vector::new(-vector.y, vector.x)
}

/// The point of a segment that is nearest to a given point. The segment may have length 0.
pub fn nearest(place: Point, from: Point, to: Point) -> Point {
    let along = to - from;
    let square = along.norm_squared();
    if square > 0.0 {
        from + along * ((place - from).dot(&along) / square).clamp(0.0, 1.0)
    } else {
        from
    }
}

/// A moving point: both coordinates with their derivatives with respect to the input.
///
/// ```
/// use assur::{Jet, JetPoint, Point, Vector};
/// // The end of an arm of length 2 that turns about (1, 0).
/// let end = JetPoint::fixed(Point::new(1.0, 0.0)).offset(Jet::<2>::linear(0.0, 1.0), 2.0, 0.0);
/// assert_eq!(end.place(), Point::new(3.0, 0.0));
/// assert_eq!(end.derivative(1), Vector::new(0.0, 2.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct JetPoint<const N: usize> {
    /// Abscissa, in the unit of the lengths.
    pub x: Jet<N>,
    /// Ordinate, in the unit of the lengths.
    pub y: Jet<N>,
}

impl<const N: usize> JetPoint<N> {
    /// A fixed point.
    pub fn fixed(place: Point) -> Self {
        Self {
            x: Jet::constant(place.x),
            y: Jet::constant(place.y),
        }
    }

    /// The position.
    pub fn place(&self) -> Point {
        Point::new(self.x.value(), self.y.value())
    }

    /// The `order`-th derivative with respect to the input: the analogue of velocity for order 1, of acceleration for
    /// order 2. Zero if `order` is `N` or more.
    pub fn derivative(&self, order: usize) -> Vector {
        Vector::new(self.x.derivative(order), self.y.derivative(order))
    }

    /// The point at the distance `along` from this point in the direction `angle`, and `across` to the left.
    pub fn offset(&self, angle: Jet<N>, along: f64, across: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self {
            x: self.x + cos * along - sin * across,
            y: self.y + sin * along + cos * across,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The segment has the length 5. The feet of the perpendiculars from (4, 3) and from (−2.8, 4.6) are 24/5 and 2
    /// from the start of the segment.
    #[test]
    fn nearest_point_of_a_segment_is_the_foot_or_an_end() {
        let (from, to) = (Point::origin(), Point::new(3.0, 4.0));
        for (place, expected) in [
            ([4.0, 3.0], [2.88, 3.84]),
            ([-2.8, 4.6], [1.2, 1.6]),
            ([4.0, -3.0], [0.0, 0.0]),
            ([-1.0, -1.0], [0.0, 0.0]),
            ([6.0, 8.0], [3.0, 4.0]),
        ] {
            let found = nearest(place.into(), from, to);
            let off = (found - Point::from(expected)).norm();
            assert!(off < 1e-15, "{place:?}: {found}");
        }
        assert_eq!(nearest(to, from, from), from);
    }

    #[test]
    fn derivatives_of_a_turning_arm_are_quarter_turns() {
        let end =
            JetPoint::fixed(Point::new(1.0, 2.0)).offset(Jet::<5>::linear(0.0, 1.0), 3.0, 4.0);
        assert_eq!(end.place(), Point::new(4.0, 6.0));
        for (order, expected) in [
            [-4.0, 3.0],
            [-3.0, -4.0],
            [4.0, -3.0],
            [3.0, 4.0],
            [0.0, 0.0],
        ]
        .into_iter()
        .enumerate()
        {
            let found = end.derivative(order + 1);
            assert!(
                (found - Vector::from(expected)).norm() < 1e-14,
                "{order}: {found}"
            );
        }
    }

    /// A point at radius 5 on a link that turns at twice the rate of the input: velocity 2·5, acceleration 2²·5.
    #[test]
    fn centripetal_acceleration_is_the_square_of_the_speed_times_the_radius() {
        let end = JetPoint::fixed(Point::origin()).offset(Jet::<3>::linear(0.0, 2.0), 5.0, 0.0);
        assert_eq!(end.derivative(1), Vector::new(0.0, 10.0));
        assert_eq!(end.derivative(2), Vector::new(-20.0, 0.0));
    }

    #[test]
    fn two_quarter_turns_reverse_a_vector() {
        let v = Vector::new(3.0, 4.0);
        assert_eq!(perpendicular(v), Vector::new(-4.0, 3.0));
        assert_eq!(perpendicular(perpendicular(v)), -v);
        assert_eq!(v.perp(&perpendicular(v)), 25.0);
    }
}
