//! Curvature in the plane of a link at an instant: pole, pole tangent, inflection circle, return circle, Ball's point.

use crate::index::BodyId;
use crate::mechanism::{Mechanism, Pose};
use crate::tolerance;
use crate::{Point, Vector, perpendicular};

/// The inflection circle, the return circle and Ball's point of a body that turns relative to the frame, at an instant.
///
/// Let p be the position of the pole, θ the angle of the body, and r the vector from the pole to a point of the body,
/// all as complex numbers. The velocity of the point is θ′ i r, its acceleration (θ″ i − θ′²) r − θ′ i p′. Its path has
/// no curvature if the two are parallel: if r² = r·D with D = −i p′/θ′. These points are on a circle that passes
/// through the pole in the direction p′. For any other point, the centre of curvature is on the line through the pole
/// and the point (Euler, 1765; Savary, 1845).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circles {
    /// The instant centre of the body and the frame.
    pub pole: Point,
    /// Derivative of the pole's position with respect to the input, the same along both centrodes. Its direction is the
    /// pole tangent. Zero if the pole is at rest, as in a hinge to the frame.
    pub pole_velocity: Vector,
    /// Derivative θ′ of the body's angle with respect to the input.
    pub spin: f64,
    /// Vector from the pole to the inflection pole: the diameter of the inflection circle, the locus of points whose
    /// paths have no curvature. The opposite vector is the diameter of the return circle, the locus of centres of
    /// curvature for points at infinity.
    pub diameter: Vector,
    /// Ball's point: the point of the body whose path is straight to the third order. It is the intersection of the
    /// inflection circle and the curve of stationary curvature (Ball, 1871). None if the pole is at rest, or if all
    /// points of the inflection circle, or none of them, have such paths.
    pub ball: Option<Point>,
}

impl Circles {
    /// Finds the circles of a body in a pose with at least three derivatives. None if the body does not rotate.
    pub fn of<const N: usize>(mechanism: &Mechanism, pose: &Pose<N>, body: BodyId) -> Option<Self> {
        let angle = mechanism.body_angle(pose, body);
        let [w, e, f] = [1, 2, 3].map(|order| angle.derivative(order));
        let middle = mechanism.middle();
        let point = mechanism.fixed_to(pose, body, middle);
        let [v, a, j] = [1, 2, 3].map(|order| point.derivative(order));
        let size = mechanism.scale_of_places();
        let turns = w.abs() * size > tolerance::NEGLIGIBLE * (v.norm() + w.abs() * size);
        if !turns {
            return None;
        }
        // p = z + i z′/θ′ for any point z of the body; differentiated twice.
        let (w2, w3) = (w * w, w * w * w);
        let pole = middle + perpendicular(v) / w;
        let p1 = v + perpendicular(a / w - v * (e / w2));
        let p2 =
            a + perpendicular(j / w - a * (2.0 * e / w2) - v * (f / w2) + v * (2.0 * e * e / w3));
        let diameter = -perpendicular(p1) / w;
        let finite = [pole.coords, p1, diameter]
            .iter()
            .all(|v| v.norm().is_finite());
        finite.then(|| Self {
            pole,
            pole_velocity: p1,
            spin: w,
            diameter,
            ball: (diameter.norm() > tolerance::NEGLIGIBLE * size)
                .then(|| ball(pole, diameter, [p1 * (e / w), -p2, -perpendicular(p1) * w]))
                .flatten(),
        })
    }

    /// Centre and radius of the inflection circle.
    pub fn inflection(&self) -> (Point, f64) {
        (self.pole + self.diameter / 2.0, self.diameter.norm() / 2.0)
    }

    /// Centre of curvature for the body's point at a position A, by Euler and Savary. The line through the pole P and A
    /// meets the inflection circle again at W. The centre is on this line, at the distance PA²/AW from A in the
    /// direction from A to W. None if A is the pole or is on the inflection circle.
    pub fn centre_of_curvature(&self, of: Point) -> Option<Point> {
        let r = of - self.pole;
        let square = r.norm_squared();
        // With r = PA and D the diameter: PW = r (r·D)/r², and AW = r (r·D − r²)/r².
        let beyond = square / (r.dot(&self.diameter) - square);
        let centre = of + r * beyond;
        centre.coords.norm_squared().is_finite().then_some(centre)
    }
}

/// Ball's point: the intersection of the inflection circle with a line through the pole. The direction of the line is
/// the sum of `terms`. None if the sum is only rounding error: the paths of all points of the circle are then straight
/// to the third order.
fn ball(pole: Point, diameter: Vector, terms: [Vector; 3]) -> Option<Point> {
    let along: Vector = terms.iter().sum();
    let size: f64 = terms.iter().map(Vector::norm).sum();
    if along.norm() <= tolerance::NEGLIGIBLE * size {
        return None;
    }
    let share = diameter.dot(&along) / along.norm_squared();
    let ball = pole + along * share;
    ball.coords.norm_squared().is_finite().then_some(ball)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;
    use crate::curvature::Curvature;
    use crate::linkage::samples::slider_crank;
    use crate::motion::Motion;

    /// A wheel of radius 1 that rolls on the x-axis: the pole is the point of contact, the inflection pole the centre
    /// of the wheel. A point of the rim draws a cycloid, whose radius of curvature is twice the distance from the
    /// contact.
    #[test]
    fn a_cycloid_bends_about_twice_the_distance_from_the_contact() {
        let rolling = Circles {
            pole: Point::origin(),
            pole_velocity: Vector::x(),
            spin: -1.0,
            diameter: Vector::y(),
            ball: None,
        };
        for (of, centre) in [([0.0, 2.0], [0.0, -2.0]), ([1.0, 1.0], [-1.0, -1.0])] {
            let found = rolling.centre_of_curvature(of.into()).unwrap();
            assert!((found - Point::from(centre)).norm() < 1e-15, "{found}");
        }
        // The centre of the wheel and the point of contact have no circle of curvature.
        for of in [[0.0, 1.0], [0.0, 0.0]] {
            assert_eq!(rolling.centre_of_curvature(of.into()), None);
        }
        assert_eq!(rolling.inflection(), (Point::new(0.0, 0.5), 0.5));
    }

    /// At a dead centre of a slider-crank, the paths of all points of the inflection circle are straight to the third
    /// order, whatever the lengths.
    #[test]
    fn a_slider_crank_in_a_dead_centre_has_no_ball_point() {
        for (crank, rod) in [(1.0, 3.0), (-1.0, 3.0), (2.0, 7.0), (-2.0, 7.0), (3.0, 5.0)] {
            let slider_crank = slider_crank([[crank, 0.0], [crank + rod, 0.0]]);
            let motion = Motion::new(Mechanism::new(&slider_crank).unwrap());
            let mechanism = motion.mechanism();
            let pose = motion
                .pose::<4>(if crank > 0.0 { 0.0 } else { PI })
                .unwrap();
            let rod = mechanism.body_of(mechanism.link("rod"));
            let circles = Circles::of(mechanism, &pose, rod).unwrap();
            assert_eq!(circles.ball, None, "crank {crank}");
        }
    }

    /// A slider-crank with crank 3 and rod 5, stretched out. The pole of the rod is the slider at (8, 0), and θ′ =
    /// −3/5. The pole moves at 8 across the slide, so the diameter is 8/(−3/5) along the slide. The paths of all points
    /// of the inflection circle are straight to the third order.
    #[test]
    fn circles_of_a_stretched_slider_crank() {
        let slider_crank = slider_crank([[3.0, 0.0], [8.0, 0.0]]);
        let mechanism = Mechanism::new(&slider_crank).unwrap();
        let motion = Motion::new(mechanism);
        let mechanism = motion.mechanism();
        let pose = motion.pose::<4>(0.0).unwrap();
        let body = |name: &str| mechanism.body_of(mechanism.link(name));
        let rod = Circles::of(mechanism, &pose, body("rod")).unwrap();
        assert!((rod.spin + 0.6).abs() < 1e-14);
        for (found, expected) in [
            (rod.pole.coords, [8.0, 0.0]),
            (rod.pole_velocity, [0.0, 8.0]),
            (rod.diameter, [-40.0 / 3.0, 0.0]),
            // The crank's end moves around the crank's pivot.
            (
                rod.centre_of_curvature(Point::new(3.0, 0.0))
                    .unwrap()
                    .coords,
                [0.0, 0.0],
            ),
            // At x = 5.5, halfway along the rod: PA² = 6.25 and AW = −65/6, so the centre is 15/26 to the left.
            (
                rod.centre_of_curvature(Point::new(5.5, 0.0))
                    .unwrap()
                    .coords,
                [5.5 - 15.0 / 26.0, 0.0],
            ),
        ] {
            assert!(
                (found - Vector::from(expected)).norm() < 1e-12,
                "{found}, not {expected:?}"
            );
        }
        let (centre, radius) = rod.inflection();
        for along in [Vector::y(), -Vector::x(), Vector::new(0.6, 0.8)] {
            let point = mechanism.fixed_to(&pose, body("rod"), centre + along * radius);
            let path = Curvature::of(&point, mechanism.size()).unwrap();
            assert!(
                path.curvature.abs() < 1e-14 && path.rate.abs() < 1e-14,
                "{path:?}"
            );
        }
        assert_eq!(Circles::of(mechanism, &pose, body("slider")), None);
    }

    #[test]
    fn about_a_hinge_all_centres_of_curvature_are_the_hinge() {
        let hinge = Circles {
            pole: Point::new(1.0, 2.0),
            pole_velocity: Vector::zeros(),
            spin: 1.0,
            diameter: Vector::zeros(),
            ball: None,
        };
        for of in [[4.0, 6.0], [1.0, -3.0]] {
            assert_eq!(hinge.centre_of_curvature(of.into()), Some(hinge.pole));
        }
        assert_eq!(hinge.inflection(), (hinge.pole, 0.0));
    }
}
