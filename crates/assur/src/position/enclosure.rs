//! Enclosures of the motion between two poses, by bounds on all second derivatives over a step of the input. They
//! certify a step: within it no margin (quantity under a root) vanishes, no group has a singular pose and no point goes
//! to infinity. The poses at the ends of the step cannot show this.
//!
//! The pose of every body and its first derivative are known at the start of the step. For a point p, a bound b on the
//! second derivative over the step then encloses the path: after a change t of the input, the point is within t²b/2 of
//! p + t p′. In the order of solving, the bounds for each body follow from those for the bodies joined to it, and from
//! a lower bound on the sine of the angle between the links of its dyad. The same enclosures give this lower bound.
//! Groups of higher class are certified by L. V. Kantorovich's theorem (J. M. Ortega and W. C. Rheinboldt, *Iterative
//! Solution of Nonlinear Equations in Several Variables*, 1970, 12.6).

mod dyads;

use super::group::Work;
use super::{BodyPoint, Predictor, Step, conjugate, product};
use crate::Vector;
use crate::index::{BodyId, List, StepId};

/// A step of the input from a pose, with bounds of the motion.
#[derive(Clone, Debug)]
pub(crate) struct Enclosure {
    /// Change of the input over the step; `step_len` is its absolute value.
    pub(super) width: f64,
    pub(super) step_len: f64,
    bodies: List<BodyId, Bound>,
    /// For each group, bound on the distance of its solution from the tangent, in units of the unknowns.
    pub(super) deviations: List<StepId, f64>,
    /// Bound on the relative change of the Jacobian of any group.
    pub(super) jacobian_change: f64,
    pub(super) work: Work<2>,
    pub(super) bounds: Bounds,
}

/// Maximum relative change q of the Jacobian of a group. Kantorovich's theorem holds for q below 1. For q = ½ the ball
/// that contains the solution has a radius of twice the first correction.
pub(super) const MAX_JACOBIAN_CHANGE: f64 = 0.5;
/// Number of columns of an inverse Jacobian that are computed together.
pub(super) const BLOCK: usize = 4;

/// Buffers for the bounds of a group.
#[derive(Clone, Debug, Default)]
pub(super) struct Bounds {
    pub(super) inverse: Vec<f64>,
    pub(super) units: Vec<[f64; BLOCK]>,
    pub(super) columns: Vec<[f64; BLOCK]>,
    pub(super) inputs: Vec<f64>,
    pub(super) forms: Vec<f64>,
    pub(super) sums: Vec<[f64; 3]>,
}

/// Bounds of the motion of a body over the step.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Bound {
    /// Bound on the second derivative of the angle of the body.
    pub(crate) angular_acceleration: f64,
    /// Bound on the rotation of the body, found without `angular_acceleration`; infinite if no such bound was found.
    max_turn: f64,
    /// Two points on the body, with bounds on their second derivatives.
    pub(crate) places: [(Vector, f64); 2],
}

/// Position and first derivative of a point at the start of the step, with a bound on its second derivative.
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
    /// The first step of the plan that is not certified.
    pub(crate) fn certify(
        &mut self,
        steps: &List<StepId, Step>,
        from: &Predictor,
        width: f64,
    ) -> Result<(), StepId> {
        self.certify_beside(steps, from, width, (&[], from))
    }

    /// Certifies a step of the input to the pose `to`. On the way, the links of the plan's steps `passing` pass through
    /// a pose in line. Second derivatives of their bodies are estimated from the two end poses, because the equations
    /// do not bound them near poses in line.
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
                self.estimate(placing, from, to);
            } else if !placing.enclose(step, from, self) {
                return Err(step);
            }
        }
        Ok(())
    }

    /// Upper bound, from the groups, on the length of a certifiable step relative to the last step. The change of a
    /// Jacobian grows at least in proportion to the length.
    pub(crate) fn ease(&self) -> f64 {
        MAX_JACOBIAN_CHANGE / self.jacobian_change
    }

    /// Sets the bound on each second derivative to twice the greater of its values at the two ends of the step.
    fn estimate(&mut self, placing: &Step, from: &Predictor, to: &Predictor) {
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

    /// True if the solution of a group at the end of the step is within its enclosure. True for any other step of the
    /// plan.
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
        let max_turn = f64::INFINITY;
        self.bodies[body] = Bound {
            angular_acceleration,
            max_turn,
            places,
        };
    }

    pub(crate) fn angular_acceleration(&self, body: BodyId) -> f64 {
        self.bodies[body].angular_acceleration
    }

    /// First derivative of a body's angle at the start of the step.
    pub(crate) fn turn_rate(&self, from: &Predictor, body: BodyId) -> f64 {
        let turn = &from.bodies[body].turn;
        turn[0].perp(&turn[1])
    }

    /// Bound on the first derivative of a body's angle.
    pub(crate) fn max_turn_rate(&self, from: &Predictor, body: BodyId) -> f64 {
        self.turn_rate(from, body).abs() + self.step_len * self.angular_acceleration(body)
    }

    /// Bound on the rotation of a body over the step.
    pub(crate) fn turned(&self, from: &Predictor, body: BodyId) -> f64 {
        let turn = self.step_len * self.max_turn_rate(from, body);
        turn.min(self.bodies[body].max_turn)
    }

    /// Bound on the second derivative of a unit vector on a body.
    pub(crate) fn direction_acceleration(&self, from: &Predictor, body: BodyId) -> f64 {
        let centripetal = self.max_turn_rate(from, body).powi(2);
        Vector::new(self.angular_acceleration(body), centripetal).norm()
    }

    /// Position, first derivative and bound of a point on a body.
    pub(crate) fn point(&self, from: &Predictor, anchor: BodyPoint) -> PointBound {
        let position = from.place(anchor);
        let Bound { places, .. } = &self.bodies[anchor.body];
        let direction_acceleration = self.direction_acceleration(from, anchor.body);
        let accelerations = places.map(|(local, acceleration)| {
            acceleration + (anchor.local - local).norm() * direction_acceleration
        });
        PointBound {
            at: position[0],
            rate: position[1],
            acceleration: accelerations[0].min(accelerations[1]),
        }
    }

    /// Position, first derivative and bound of the body's point that coincides with `at` when the step starts.
    pub(crate) fn point_at(&self, from: &Predictor, body: BodyId, at: Vector) -> PointBound {
        let local = product(
            at - from.bodies[body].origin.value(),
            conjugate(from.bodies[body].turn.value()),
        );
        self.point(from, BodyPoint { body, local })
    }

    pub(crate) fn max_speed(&self, point: &PointBound) -> f64 {
        point.rate.norm() + self.step_len * point.acceleration
    }

    /// Lower and upper bound on the distance of a point from the origin over the step.
    pub(crate) fn distances(&self, point: &PointBound) -> [f64; 2] {
        let (at, rate) = (point.at, point.rate);
        let radius = 0.5 * self.step_len * self.step_len * point.acceleration;
        let end = at + rate * self.width;
        let most = at.norm().max(end.norm());
        // The point of the tangent that is nearest to the origin.
        let nearest = -at.dot(&rate) / rate.norm_squared() * self.width.signum();
        let least = if nearest.is_finite() {
            let nearest = nearest.clamp(0.0, self.step_len) * self.width.signum();
            (at + rate * nearest).norm()
        } else {
            at.norm()
        };
        [least - radius, most + radius]
    }

    /// Bound on a continuous speed v that begins at v₀ and satisfies v ≤ v₀ + h (a v² + c), with the step length h. The
    /// bound is the smaller root of v = v₀ + h (a v² + c), which v cannot pass. None if there is no real root.
    pub(crate) fn bounded_speed(&self, v0: f64, a: f64, c: f64) -> Option<f64> {
        let start = v0 + self.step_len * c;
        let rest = 1.0 - 4.0 * self.step_len * a * start;
        (rest >= 0.0).then(|| 2.0 * start / (1.0 + rest.sqrt()))
    }
}
