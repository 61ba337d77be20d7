//! Stiffness of the equations of motion, which bounds the step.

use super::body::N;
use super::equations::{Equations, Following};
use super::run::{QUICKEST, TICK};
use super::{Body, Mesh};
use crate::Angle;

/// Rates of oscillation and damping of a body.
#[derive(Clone, Copy, Debug)]
struct Stiffness {
    /// Square of the natural frequency, (rad/s)².
    swings: f64,
    /// Rate of damping, 1/s.
    damping: f64,
}

impl Stiffness {
    fn sum(each: &[Self; N]) -> Self {
        Self {
            swings: each.iter().map(|each| each.swings).sum(),
            damping: each.iter().map(|each| each.damping).sum(),
        }
    }

    fn rate(&self) -> f64 {
        self.swings.sqrt().max(self.damping)
    }
}

impl Equations {
    /// Share of each body in the acceleration of the coordinate Σ nφ under a unit torque on this coordinate; `factors`
    /// are the numbers n. The share is n²/J if the body moves under torques, otherwise 0. Both n and the moment of
    /// inertia J include the contributions of the bodies that follow the body, referred to its axis.
    fn yielding(&self, factors: &[f64; N]) -> [f64; N] {
        let mut sums = *factors;
        for (body, follows) in self.following.iter().enumerate() {
            if let Following::Body { to, ratio } = follows {
                sums[*to] += ratio * factors[body];
            }
        }
        std::array::from_fn(|body| match self.following[body] {
            Following::Torques(_) => sums[body] * sums[body] / self.carried[body],
            _ => 0.0,
        })
    }

    /// Square of the natural frequency of the phase of a mesh, (rad/s)²: the energy amplitude of the mesh times the sum
    /// of n²/J over the bodies.
    pub(super) fn stiffness(&self, mesh: Mesh) -> f64 {
        let field = self.mesh(mesh);
        field.energy * self.yielding(&field.factors).iter().sum::<f64>()
    }

    /// Rates of each body at these speeds. Their sums over the bodies are the traces of the matrices of stiffness and
    /// of damping. A trace is at least the greatest eigenvalue, so the sums bound the rates of the coupled motion.
    fn stiffness_terms(&self, speeds: &[f64; N]) -> [Stiffness; N] {
        let mut squares = [0.0; N];
        let mut rates = [0.0; N];
        let mut damp = |damping: f64, factors: &[f64; N]| {
            for (rate, share) in rates.iter_mut().zip(self.yielding(factors)) {
                *rate += damping * share;
            }
        };
        for (body, speed) in speeds.iter().enumerate() {
            let mut factors = [0.0; N];
            factors[body] = 1.0;
            damp(self.count[body] * self.load[body].growth(*speed), &factors);
            if body == Body::Satellite.index() {
                factors[Body::Carrier.index()] = -1.0;
            }
            damp(self.damping[body], &factors);
        }
        for field in &self.meshes {
            damp(field.damping, &field.factors);
            for (square, share) in squares.iter_mut().zip(self.yielding(&field.factors)) {
                *square += field.energy * share;
            }
        }
        std::array::from_fn(|body| Stiffness {
            swings: squares[body],
            damping: rates[body],
        })
    }

    /// The fastest rate in a state, rad/s: of oscillation, of damping, or of a phase that slips.
    pub(super) fn rate(&self, angles: &[Angle; N], speeds: &[f64; N]) -> f64 {
        let own = Stiffness::sum(&self.stiffness_terms(speeds)).rate();
        let passing = Mesh::ALL.map(|mesh| {
            let field = self.mesh(mesh);
            let rate = field.phase(speeds);
            // Rate with which the phase passes the minimum of its potential, from the energy. It is the same in every
            // period of a slip.
            let height = field.potential(field.folded(angles).1) / field.energy;
            (rate * rate + 2.0 * self.stiffness(mesh) * height).sqrt()
        });
        passing.into_iter().fold(own, f64::max)
    }

    /// The body with the fastest rate, if the equations are too stiff to be integrated.
    pub(super) fn too_stiff(&self) -> Option<Body> {
        let each = self.stiffness_terms(&[0.0; N]);
        let bodies = Body::ALL.into_iter().zip(&each);
        (Stiffness::sum(&each).rate() * TICK > QUICKEST)
            .then(|| bodies.max_by(|a, b| a.1.rate().total_cmp(&b.1.rate())))
            .flatten()
            .map(|(body, _)| body)
    }
}
