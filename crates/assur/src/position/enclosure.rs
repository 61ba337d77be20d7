//! What lies between two poses: bounds of all second derivatives over a step of the input. With them a step is
//! certified: that no margin vanishes in it, no group comes to a singular pose and no point goes through infinity is
//! shown, not seen at its ends.
//!
//! Of every body the pose and its first derivative are known where the step begins. A bound of the second derivative
//! over the step then encloses the body's way: p(t) is within t²p″/2 of p + t p′. Body by body, in the order in which
//! they are solved, the bound follows from those of what the body hangs on and from how near its joints come to being
//! in line, which the enclosures of the same bodies tell. (For groups of higher class: L. V. Kantorovich's theorem,
//! J. M. Ortega and W. C. Rheinboldt, *Iterative Solution of Nonlinear Equations in Several Variables*, 1970, 12.6.)

use std::f64::consts::PI;

use super::group::Work;
use super::{Arm, BodyPoint, Predictor, Step, Track, conjugate, product};
use crate::Vector;
use crate::index::{BodyId, List, StepId};

/// A step of the input from a pose, with what bounds the motion in it.
#[derive(Clone, Debug)]
pub(crate) struct Enclosure {
    /// How far the input goes, with its sense, and without.
    pub(super) width: f64,
    pub(super) step_len: f64,
    bodies: List<BodyId, Bound>,
    /// How far the solution of a group may be from where its tangent leads, in units of its unknowns.
    pub(super) deviations: List<StepId, f64>,
    /// By how much the Jacobian of any group changes at most, relative to itself.
    pub(super) jacobian_change: f64,
    pub(super) work: Work<2>,
    pub(super) bounds: Bounds,
}

/// The Jacobian of a group changes by no more than this, relative to itself.
pub(super) const REGULAR: f64 = 0.5;
/// A body that a bound lets turn farther, radians, may be shown to turn less.
const FAR: f64 = 0.5;
/// So many columns of an inverse are found at once.
pub(super) const AT_ONCE: usize = 4;

/// Room for what is summed up of a group.
#[derive(Clone, Debug, Default)]
pub(super) struct Bounds {
    pub(super) inverse: Vec<f64>,
    pub(super) units: Vec<[f64; AT_ONCE]>,
    pub(super) columns: Vec<[f64; AT_ONCE]>,
    pub(super) inputs: Vec<f64>,
    pub(super) forms: Vec<f64>,
    pub(super) sums: Vec<[f64; 3]>,
}

/// What bounds the motion of a body over the step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bound {
    /// The second derivative of its angle.
    pub(crate) angular_acceleration: f64,
    /// How far it turns at most, where that is known otherwise.
    turned: f64,
    /// That of two places on it.
    pub(crate) places: [(Vector, f64); 2],
}

/// Where a place is when the step begins, how it moves there, and what its second derivative is at most.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PointBound {
    pub(crate) at: Vector,
    pub(crate) rate: Vector,
    pub(crate) acceleration: f64,
}

impl PointBound {
    pub(crate) fn minus(&self, other: &Self) -> Self {
        Self {
            at: self.at - other.at,
            rate: self.rate - other.rate,
            acceleration: self.acceleration + other.acceleration,
        }
    }
}

impl Enclosure {
    pub(crate) fn new(bodies: usize, steps: usize) -> Self {
        Self {
            width: 0.0,
            step_len: 0.0,
            bodies: vec![Bound::default(); bodies].into(),
            deviations: vec![0.0; steps].into(),
            jacobian_change: 0.0,
            work: Work::default(),
            bounds: Bounds::default(),
        }
    }

    /// Certifies a step of the input from a pose.
    ///
    /// # Errors
    /// The first step of the plan of which it cannot be shown that nothing happens to it.
    pub(crate) fn certify(
        &mut self,
        steps: &List<StepId, Step>,
        from: &Predictor,
        width: f64,
    ) -> Result<(), StepId> {
        self.certify_beside(steps, from, width, (&[], from))
    }

    /// The same where links of some steps pass through in line, to another pose beyond: in between their bodies are
    /// taken to move as smoothly as at both ends, which their equation there does not tell.
    pub(crate) fn certify_beside(
        &mut self,
        steps: &List<StepId, Step>,
        from: &Predictor,
        width: f64,
        (passing, to): (&[StepId], &Predictor),
    ) -> Result<(), StepId> {
        (self.width, self.step_len) = (width, width.abs());
        self.jacobian_change = 0.0;
        for (step, placing) in steps.enumerate() {
            if passing.contains(&step) {
                self.take_over(placing, from, to);
            } else if !placing.enclose(step, from, self) {
                return Err(step);
            }
        }
        Ok(())
    }

    /// How many times as long as the step that was certified last one may be at most, as far as groups tell: their
    /// Jacobians change at least in proportion.
    pub(crate) fn ease(&self) -> f64 {
        REGULAR / self.jacobian_change
    }

    /// Twice what the second derivatives are at both ends, whichever is more.
    fn take_over(&mut self, placing: &Step, from: &Predictor, to: &Predictor) {
        for body in placing.bodies() {
            let most = |of: &dyn Fn(&Predictor) -> f64| 2.0 * f64::max(of(from), of(to));
            let angular_acceleration = most(&|state| state.angle(body).derivative(2).abs());
            let acceleration = most(&|state| 2.0 * state.bodies[body].origin[2].norm());
            self.set(
                body,
                angular_acceleration,
                [(Vector::zeros(), acceleration); 2],
            );
        }
    }

    /// Whether a step of the plan came out at the end of the step where it was shown to be.
    pub(crate) fn holds(
        &self,
        step: StepId,
        placing: &Step,
        from: &Predictor,
        to: &Predictor,
    ) -> bool {
        match placing {
            Step::Group(group) => group.is_certified(from, to, self.width, self.deviations[step]),
            _ => true,
        }
    }

    pub(crate) fn set(
        &mut self,
        body: BodyId,
        angular_acceleration: f64,
        places: [(Vector, f64); 2],
    ) {
        let turned = f64::INFINITY;
        self.bodies[body] = Bound {
            angular_acceleration,
            turned,
            places,
        };
    }

    /// What the second derivative of a body's angle is at most.
    pub(crate) fn angular_acceleration(&self, body: BodyId) -> f64 {
        self.bodies[body].angular_acceleration
    }

    /// How fast a body turns when the step begins.
    pub(crate) fn turning(&self, from: &Predictor, body: BodyId) -> f64 {
        let turn = &from.bodies[body].turn;
        turn[0].perp(&turn[1])
    }

    /// How fast a body turns at most.
    pub(crate) fn max_turn_rate(&self, from: &Predictor, body: BodyId) -> f64 {
        self.turning(from, body).abs() + self.step_len * self.angular_acceleration(body)
    }

    /// How far a body turns at most.
    pub(crate) fn turned(&self, from: &Predictor, body: BodyId) -> f64 {
        let turned = self.step_len * self.max_turn_rate(from, body);
        turned.min(self.bodies[body].turned)
    }

    /// What the second derivative of a direction of a body is at most.
    pub(crate) fn direction_acceleration(&self, from: &Predictor, body: BodyId) -> f64 {
        Vector::new(
            self.angular_acceleration(body),
            self.max_turn_rate(from, body).powi(2),
        )
        .norm()
    }

    /// The way of a place on a body.
    pub(crate) fn place(&self, from: &Predictor, anchor: BodyPoint) -> PointBound {
        let place = from.place(anchor);
        let Bound { places, .. } = &self.bodies[anchor.body];
        let direction_acceleration = self.direction_acceleration(from, anchor.body);
        let accelerations = places.map(|(local, acceleration)| {
            acceleration + (anchor.local - local).norm() * direction_acceleration
        });
        PointBound {
            at: place[0],
            rate: place[1],
            acceleration: accelerations[0].min(accelerations[1]),
        }
    }

    /// The way of the place of a body that is at a point when the step begins.
    pub(crate) fn place_at(&self, from: &Predictor, body: BodyId, at: Vector) -> PointBound {
        let local = product(
            at - from.bodies[body].origin.value(),
            conjugate(from.bodies[body].turn.value()),
        );
        self.place(from, BodyPoint { body, local })
    }

    /// How fast it goes at most.
    pub(crate) fn speed(&self, way: &PointBound) -> f64 {
        way.rate.norm() + self.step_len * way.acceleration
    }

    /// The least and the greatest distance from the origin.
    pub(crate) fn distances(&self, way: &PointBound) -> [f64; 2] {
        let PointBound {
            at,
            rate,
            acceleration,
        } = way;
        let room = 0.5 * self.step_len * self.step_len * acceleration;
        let end = at + rate * self.width;
        let most = at.norm().max(end.norm());
        // Where the straight way comes nearest.
        let nearest = -at.dot(rate) / rate.norm_squared() * self.width.signum();
        let least = if nearest.is_finite() {
            let nearest = nearest.clamp(0.0, self.step_len) * self.width.signum();
            (at + rate * nearest).norm()
        } else {
            at.norm()
        };
        [least - room, most + room]
    }

    /// A speed v that obeys v ≤ v₀ + h (a v² + c) all along, v₀ when the step begins: it is continuous and cannot come
    /// over the lesser root. None where there is no root.
    pub(crate) fn bounded_speed(&self, v0: f64, a: f64, c: f64) -> Option<f64> {
        let start = v0 + self.step_len * c;
        let rest = 1.0 - 4.0 * self.step_len * a * start;
        (rest >= 0.0).then(|| 2.0 * start / (1.0 + rest.sqrt()))
    }

    /// Two links hinged on each other and on solved points: whether they keep from being in line.
    ///
    /// With X from B to the joint C and e₂, e₃ along the links: e₂·X″ = −v₂²/l₂ and e₃·(X − d)″ = −v₃²/l₃, so that X″
    /// is no more than the sum of the right sides over the sine of the angle between the links.
    pub(crate) fn pair(&mut self, from: &Predictor, arms: &[Arm; 2]) -> bool {
        let [b, d] = arms.each_ref().map(|arm| self.place(from, arm.outer));
        let base = d.minus(&b);
        let [least, most] = self.distances(&base);
        let [l2, l3] = arms.each_ref().map(Arm::length);
        let (sum, difference) = (l2 + l3, (l2 - l3).abs());
        if !(most < sum && least > difference) {
            return false;
        }
        // 16 S² of the triangle, concave in r².
        let square = |r: f64| (sum - r) * (sum + r) * (r - difference) * (r + difference);
        let sine = square(least).min(square(most)).sqrt() / (2.0 * l2 * l3);
        let lengths = l2.recip() + l3.recip();
        let v0 = arms.each_ref().map(|arm| {
            let turning = self.turning(from, arm.body).abs();
            turning * arm.length()
        });
        let v0 = v0[0].max(v0[1]);
        let crude = self.speed(&base) / sine;
        let v = self.bounded_speed(v0, lengths / sine, base.acceleration / sine);
        let v = v.map_or(crude, |v| v.min(crude));
        let acceleration = (v * v * lengths + base.acceleration) / sine;
        if !acceleration.is_finite() {
            return false;
        }
        let joint = b.acceleration.min(d.acceleration) + acceleration;
        for (arm, outer) in arms.iter().zip([b, d]) {
            let places = [(arm.from, outer.acceleration), (arm.to, joint)];
            self.set(arm.body, acceleration / arm.length(), places);
        }
        // Where the base is short or the links are nearly in line the triangle tells better how far they turn.
        for (arm, other) in [(&arms[0], l3), (&arms[1], l2)] {
            if self.turned(from, arm.body) > FAR {
                let turned =
                    self.max_direction_turn(&base) + opened([arm.length(), other], [least, most]);
                self.bodies[arm.body].turned = turned;
            }
        }
        true
    }

    /// How far a direction turns at most that keeps from vanishing.
    fn max_direction_turn(&self, way: &PointBound) -> f64 {
        let end = way.at + way.rate * self.width;
        let straight = way.at.perp(&end).atan2(way.at.dot(&end)).abs();
        let [least, _] = self.distances(way);
        let room = 0.5 * self.step_len * self.step_len * way.acceleration;
        straight + (room / (least + room)).asin()
    }

    /// What the second derivative of the point is at most where two lines cross, each by a body that it is fixed to
    /// and turns with; none where they may become parallel.
    ///
    /// With the places Q₁, Q₂ of the bodies that are at the crossing when the step begins and the ways σ along the
    /// lines from there: n·C″ = n·Q″ + 2σ′ω + σε for each.
    pub(crate) fn crossing(
        &self,
        from: &Predictor,
        at: Vector,
        lines: [(BodyId, Vector); 2],
    ) -> Option<f64> {
        let bodies = lines.map(|(body, _)| body);
        let [q1, q2] = bodies.map(|body| self.place_at(from, body, at));
        let [u, v] = lines.map(|(body, heading)| product(from.bodies[body].turn.value(), heading));
        let turning = bodies.map(|body| self.turning(from, body));
        let spins = bodies.map(|body| self.angular_acceleration(body));
        let apart = u.perp(&v).abs().atan2(u.dot(&v).abs());
        let turned = (turning[0] - turning[1]).abs() + self.step_len * (spins[0] + spins[1]);
        // What turns together stays apart.
        let turned = if bodies[0] == bodies[1] { 0.0 } else { turned };
        let least = apart - self.step_len * turned;
        if least <= 0.0 {
            return None;
        }
        let sine = least.sin();
        let paces = bodies.map(|body| self.max_turn_rate(from, body));
        let way = q2.minus(&q1);
        let speed = self.speed(&way);
        let slid = self.step_len * speed / sine;
        let along = (speed + slid * (paces[0] + paces[1])) / sine + speed;
        let each = |k: usize| 2.0 * along * paces[k] + (slid + self.step_len * speed) * spins[k];
        let acceleration = q1.acceleration + (each(0) + each(1) + way.acceleration) / sine;
        acceleration.is_finite().then_some(acceleration)
    }

    /// A body that slides along a line, by what bounds the second derivative of its point.
    pub(crate) fn slid(&mut self, track: &Track, acceleration: f64) {
        let angular_acceleration = self.angular_acceleration(track.line.body);
        self.set(
            track.body,
            angular_acceleration,
            [(track.point, acceleration); 2],
        );
    }
}

/// How far the angle of a triangle between the base and a side changes at most while the base is between two lengths;
/// of the two sides the one at the angle is the first.
fn opened([side, other]: [f64; 2], base: [f64; 2]) -> f64 {
    let [sum, difference] = [side + other, side - other];
    let angle = |r: f64| {
        let cosine = (r * r + sum * difference) / (2.0 * r * side);
        cosine.clamp(-1.0, 1.0).acos()
    };
    let [least, most] = base;
    // The angle is widest where the other side is square to the base.
    let widest = (sum * difference).max(0.0).sqrt().max(least).min(most);
    let angles = [least, widest, most].map(angle);
    let range = angles.into_iter().fold([PI, 0.0], |[low, high], angle| {
        [angle.min(low), angle.max(high)]
    });
    range[1] - range[0]
}

#[cfg(test)]
mod tests {
    use super::opened;

    /// Between all lengths that the base may have the angle changes by as much, and by no more.
    #[test]
    fn angles_of_triangles() {
        for [side, other] in [[2.0, 3.0], [3.0, 2.0], [1.0, 1.0], [5.0, 0.1]] {
            let [short, long] = [f64::abs(side - other), side + other];
            for (from, to) in [(0.001, 1.0), (0.1, 0.3), (0.4, 0.41), (0.7, 0.99)] {
                let base = [from, to].map(|part| short + part * (long - short));
                let angle = |k: u32| {
                    let r = base[0] + f64::from(k) / 1e4 * (base[1] - base[0]);
                    let cosine = (r * r + side * side - other * other) / (2.0 * r * side);
                    cosine.clamp(-1.0, 1.0).acos()
                };
                let angles = (0..=10_000).map(angle);
                let [low, high] = angles.fold([9.0, 0.0], |[low, high], angle: f64| {
                    [angle.min(low), angle.max(high)]
                });
                let found = opened([side, other], base);
                let off = found - (high - low);
                assert!(
                    (-1e-12..1e-3).contains(&off),
                    "{side} {other} {base:?}: {off:e}"
                );
            }
        }
    }
}
