//! Curvature in the whole plane of a link at an instant: pole, pole tangent, inflection circle, return circle, Ball's
//! point.

use super::left;
use crate::index::BodyId;
use crate::mechanism::{Mechanism, Pose};
use crate::tolerance;
use crate::{Point, Vector};

/// The circles of a body that moves relative to the frame, at an instant at which it turns.
///
/// With r from the pole to a point of the body, θ its angle and p the position of the pole, the velocity is θ′ i r and
/// the acceleration (θ″ i − θ′²) r − θ′ i p′. They are parallel, so that the path has no curvature, if r² = r·D with
/// D = −i p′/θ′: on a circle through the pole that is tangent to p′ there. For any other point the centre of curvature
/// is on its ray from the pole, by Euler (1765) and Savary (1845).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Circles {
    /// The instant centre of the body and the frame.
    pub pole: Point,
    /// Derivative of the pole's position along both centrodes with respect to the input: the pole tangent; zero if the
    /// pole is at rest, such as a hinge.
    pub pole_velocity: Vector,
    /// θ′.
    pub spin: f64,
    /// From the pole to the inflection pole: the diameter of the inflection circle, the locus of points whose paths
    /// have no curvature. That of the return circle, the locus of centres of curvature for points at infinity, is the
    /// opposite.
    pub diameter: Vector,
    /// Ball's point: the point of the body whose path is straight to the third order, the intersection of the
    /// inflection circle and the curve of stationary curvature (Ball, 1871). None if the pole is at rest, or if every
    /// point of the circle, or none, is such a point.
    pub ball: Option<Point>,
}

impl Circles {
    /// The circles of a body in a pose with at least three derivatives. None without rotation: in a translation all
    /// points have congruent paths.
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
        // p = z + i z′/θ′ of any point z of the body, differentiated twice.
        let (w2, w3) = (w * w, w * w * w);
        let pole = middle + left(v) / w;
        let p1 = v + left(a / w - v * (e / w2));
        let p2 = a + left(j / w - a * (2.0 * e / w2) - v * (f / w2) + v * (2.0 * e * e / w3));
        let diameter = -left(p1) / w;
        let finite = [pole.coords, p1, diameter]
            .iter()
            .all(|v| v.norm().is_finite());
        finite.then(|| Self {
            pole,
            pole_velocity: p1,
            spin: w,
            diameter,
            ball: (diameter.norm() > tolerance::NEGLIGIBLE * size)
                .then(|| ball(pole, diameter, p1 * (e / w) - p2 - left(p1) * w))
                .flatten(),
        })
    }

    /// The inflection circle: its centre and radius.
    pub fn inflection(&self) -> (Point, f64) {
        (self.pole + self.diameter / 2.0, self.diameter.norm() / 2.0)
    }

    /// Centre of curvature for the body's point at a position, by Euler and Savary: on the ray from the pole through
    /// it, PA²/AW beyond it, with W the intersection of the ray and the inflection circle. None at the pole and on that
    /// circle.
    pub fn centre_of_curvature(&self, of: Point) -> Option<Point> {
        let r = of - self.pole;
        let square = r.norm_squared();
        // PW = r (r·D)/r², so that AW = r (r·D − r²)/r².
        let beyond = square / (r.dot(&self.diameter) - square);
        let centre = of + r * beyond;
        centre.coords.norm_squared().is_finite().then_some(centre)
    }
}

/// Ball's point: the intersection of its ray from the pole with the inflection circle.
fn ball(pole: Point, diameter: Vector, along: Vector) -> Option<Point> {
    let share = diameter.dot(&along) / along.norm_squared();
    let ball = pole + along * share;
    ball.coords.norm_squared().is_finite().then_some(ball)
}
