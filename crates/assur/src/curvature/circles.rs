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
                .then(|| ball(pole, diameter, p1 * (e / w) - p2 - perpendicular(p1) * w))
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

/// Ball's point: the intersection of the inflection circle with the line through the pole in the direction `along`.
fn ball(pole: Point, diameter: Vector, along: Vector) -> Option<Point> {
    let share = diameter.dot(&along) / along.norm_squared();
    let ball = pole + along * share;
    ball.coords.norm_squared().is_finite().then_some(ball)
}
