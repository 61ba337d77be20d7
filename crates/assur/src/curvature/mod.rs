//! Curvature of paths: the centre of curvature and its motion, the circles that give this centre for all points of a
//! link at once, and the centrodes. All are computed from derivatives of the pose with respect to the input: the
//! curvature from the first two, its rate from the first three. None depends on the speed of the input.
//!
//! See Dijksman, *Motion Geometry of Mechanisms*, and Hall, *Kinematics and Linkage Design*, ch. 5.

mod along;
mod centrodes;
mod circle;
mod circles;
mod evolute;

pub use centrodes::{Centrodes, Rolling};
pub use circle::{CircleOfCurvature, NoCircle};
pub use circles::Circles;
pub use evolute::Evolute;

use crate::tolerance;
use crate::{JetPoint, Point, Vector, perpendicular};

/// Curvature of a path at a point.
///
/// ```
/// use assur::{Jet, JetPoint, Point, curvature::Curvature};
/// let end = JetPoint::fixed(Point::new(1.0, 0.0)).offset(Jet::<4>::linear(0.0, 1.0), 2.0, 0.0);
/// let curvature = Curvature::of(&end, 1.0).unwrap();
/// assert_eq!(curvature.radius(), Some(2.0));
/// assert_eq!(curvature.centre, Some(Point::new(1.0, 0.0)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curvature {
    /// Position of the point.
    pub at: Point,
    /// Direction of the point's motion, a unit vector.
    pub tangent: Vector,
    /// κ = 1/R, positive if the path bends to the left. Its unit is the inverse of the unit of length.
    pub curvature: f64,
    /// dκ/ds along the path. If it is zero (stationary curvature), the circle of curvature has four-point contact.
    pub rate: f64,
    /// The centre of curvature; none if the path is straight.
    pub centre: Option<Point>,
}

impl Curvature {
    /// Finds the curvature for a point with at least three derivatives, in a drawing of the size `size`. None if the
    /// point is at rest: permanently, or for an instant at a cusp of its path.
    pub fn of<const N: usize>(point: &JetPoint<N>, size: f64) -> Option<Self> {
        let [v, a, j] = [1, 2, 3].map(|order| point.derivative(order));
        let speed = v.norm();
        let moves = speed > tolerance::NEGLIGIBLE * size;
        if !moves {
            return None;
        }
        let tangent = v / speed;
        let curvature = v.perp(&a) / speed.powi(3);
        // The derivative of κ = (v × a)/|v|³, divided by the derivative |v| of the arc length.
        let rate =
            (v.perp(&j) / speed.powi(3) - 3.0 * curvature * v.dot(&a) / speed.powi(2)) / speed;
        if !(curvature.is_finite() && rate.is_finite()) {
            return None;
        }
        let at = point.place();
        let bends = curvature.abs() * size > tolerance::COINCIDENT;
        let centre = bends.then(|| at + perpendicular(tangent) / curvature);
        Some(Self {
            at,
            tangent,
            curvature,
            rate,
            centre,
        })
    }

    /// R = 1/κ, positive if the path bends to the left; none if the path is straight.
    pub fn radius(&self) -> Option<f64> {
        self.centre.map(|_| self.curvature.recip())
    }

    /// dR/ds along the path; none if the path is straight.
    pub fn radius_rate(&self) -> Option<f64> {
        self.centre.map(|_| -self.rate / self.curvature.powi(2))
    }

    /// Derivative of the centre's position with respect to the arc length of the path. It is normal to the path, and
    /// zero if the curvature is stationary. None if the path is straight.
    pub fn evolute(&self) -> Option<Vector> {
        self.radius_rate()
            .map(|rate| perpendicular(self.tangent) * rate)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Jet;

    fn point(x: [f64; 4], y: [f64; 4]) -> JetPoint<4> {
        let [x, y] = [x, y].map(Jet::of_derivatives);
        JetPoint { x, y }
    }

    /// A circle of radius 2, and the parabola y = x²/2 at x = 0 and at x = 1, where κ = 2^(−3/2) and dκ/ds = −3/8.
    #[test]
    fn circle_and_parabola() {
        let eighth = 8_f64.sqrt().recip();
        for (x, y, curvature, rate, centre) in [
            (
                [2.0, 0.0, -2.0, 0.0],
                [0.0, 2.0, 0.0, -2.0],
                0.5,
                0.0,
                [0.0, 0.0],
            ),
            (
                [0.0, 1.0, 0.0, 0.0],
                [0.0, 0.0, 1.0, 0.0],
                1.0,
                0.0,
                [0.0, 1.0],
            ),
            (
                [1.0, 1.0, 0.0, 0.0],
                [0.5, 1.0, 1.0, 0.0],
                eighth,
                -0.375,
                [-1.0, 2.5],
            ),
        ] {
            let found = Curvature::of(&point(x, y), 1.0).unwrap();
            assert!((found.curvature - curvature).abs() < 1e-15, "{found:?}");
            assert!((found.rate - rate).abs() < 1e-15, "{found:?}");
            assert!((found.centre.unwrap() - Point::from(centre)).norm() < 2e-15);
        }
    }

    #[test]
    fn straight_and_at_rest() {
        let straight = point([0.0, 1.0, 0.0, 0.0], [0.0; 4]);
        assert_eq!(Curvature::of(&straight, 1.0).unwrap().radius(), None);
        assert_eq!(
            Curvature::of(&point([1.0, 0.0, 1.0, 0.0], [0.0; 4]), 1.0),
            None
        );
    }

    /// The evolute of y = x²/2 is (−x³, 1 + 3x²/2). At x = 1 the derivative of the evolute is (−3, 3), and the
    /// derivative of the arc length of the parabola is √2.
    #[test]
    fn the_evolute_of_a_parabola_is_a_semicubical_parabola() {
        let found = Curvature::of(&point([1.0, 1.0, 0.0, 0.0], [0.5, 1.0, 1.0, 0.0]), 1.0).unwrap();
        assert!((found.radius().unwrap() - 8_f64.sqrt()).abs() < 1e-14);
        assert!((found.radius_rate().unwrap() - 3.0).abs() < 1e-14);
        let expected = Vector::new(-3.0, 3.0) / 2_f64.sqrt();
        assert!(
            (found.evolute().unwrap() - expected).norm() < 1e-14,
            "{found:?}"
        );
    }
}
