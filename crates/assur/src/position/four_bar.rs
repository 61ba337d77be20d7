//! The dyad RRR between a crank on the frame and the frame: a four-bar, whose
//! closed form passes change points smoothly and needs no history.

use super::{Angle, Arm, Complex, Obstacle, State};
use crate::{Assembly, FourBar, Jet, Unsolved};

/// A four-bar within a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Closed {
    pub(crate) linkage: FourBar,
    /// The body of the crank, and what its angle lacks to φ₁ from the line AD.
    pub(crate) crank: usize,
    pub(crate) lead: f64,
    /// Coupler and rocker, and what the angles of their bodies lack to φ₂ and φ₃.
    pub(crate) arms: [Arm; 2],
    pub(crate) leads: [f64; 2],
}

impl Closed {
    pub(crate) fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        sign: f64,
        step: usize,
    ) -> Result<(), Obstacle> {
        let crank = state.angle(self.crank);
        let assembly = if sign > 0.0 {
            Assembly::First
        } else {
            Assembly::Second
        };
        let pose = self
            .linkage
            .pose::<N>(assembly, crank.value() + self.lead)
            .map_err(|unsolved| match unsolved {
                Unsolved::NotAnAngle => Obstacle::Input,
                Unsolved::Apart { by, .. } | Unsolved::Inside { by, .. } => Obstacle::Apart { by },
                Unsolved::Undetermined { .. } => Obstacle::Undetermined,
                Unsolved::DeadPoint { .. } => Obstacle::DeadPoint,
            })?;
        let [coupler, rocker] = &self.arms;
        let [b, d] = [coupler, rocker].map(|arm| state.place(arm.outer));
        // Told for the kind of a dead point only; the closed form passes by itself.
        let [l2, l3] = [coupler.length(), rocker.length()];
        let square = (d - b).norm_squared().value();
        let margins = [(l2 + l3).powi(2) - square, square - (l2 - l3).powi(2)];
        state.margins[step] = margins.map(Jet::constant);
        // Each stands by its own angle: laid between the joints, a short link would be
        // turned by their rounding.
        let angles = [pose.coupler + self.leads[0], pose.rocker + self.leads[1]];
        for ((arm, at), angle) in self.arms.iter().zip([b, d]).zip(angles) {
            let turn = Complex::turn(angle);
            state.turn[arm.body] = turn;
            state.origin[arm.body] = at - turn.by(arm.from);
            state.angle[arm.body] = Angle::Known(angle);
        }
        Ok(())
    }
}
