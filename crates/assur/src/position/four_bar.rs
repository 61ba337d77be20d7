//! The dyad RRR between a crank on the frame and the frame: a four-bar, whose
//! closed form passes change points smoothly and needs no history.

use super::{Angle, Arm, Cause, Complex, Given, Sign, Solvable, State};
use crate::index::BodyId;
use crate::{Assembly, FourBar, Jet, Unsolved, Vector};

/// A four-bar within a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Closed {
    pub(crate) linkage: FourBar,
    /// The body of the crank, and what its angle lacks to φ₁ from the line AD.
    pub(crate) crank: BodyId,
    pub(crate) lead: f64,
    /// Coupler and rocker, and what the angles of their bodies lack to φ₂ and φ₃.
    pub(crate) arms: [Arm; 2],
    pub(crate) leads: [f64; 2],
}

impl Closed {
    /// The four-bar of a crank, hinged at a place of the frame and on itself, and of
    /// the coupler and rocker that join it to the frame.
    pub(crate) fn new(
        crank: BodyId,
        (a, hinge): (Vector, Vector),
        [coupler, rocker]: [Arm; 2],
    ) -> Option<Self> {
        let out = coupler.outer.local - hinge;
        let base = rocker.outer.local - a;
        let lengths = [out.norm(), coupler.length(), rocker.length(), base.norm()];
        let linkage = FourBar::new(lengths).ok()?;
        let [out, frame] = [out, base].map(|v| v.y.atan2(v.x));
        let arms = [coupler, rocker];
        let leads = arms.each_ref().map(|arm| {
            let along = arm.to - arm.from;
            frame - along.y.atan2(along.x)
        });
        Some(Self {
            linkage,
            crank,
            lead: out - frame,
            arms,
            leads,
        })
    }

    /// On which side of the diagonal the joint of coupler and rocker is, to the left
    /// (1) or to the right (−1), with the crank where it is.
    pub(crate) fn side(&self, sign: Sign, state: &State<1>) -> f64 {
        let crank = state.angle(self.crank).value() + self.lead;
        self.linkage.side(sign.into(), crank)
    }
}

impl From<Sign> for Assembly {
    fn from(sign: Sign) -> Self {
        match sign {
            Sign::Plus => Self::First,
            Sign::Minus => Self::Second,
        }
    }
}

impl Solvable for Closed {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &Given<'_, N>,
    ) -> Result<(), Cause> {
        let crank = state.angle(self.crank);
        let pose = self
            .linkage
            .pose::<N>(given.sign.into(), crank.value() + self.lead)
            .map_err(|unsolved| match unsolved {
                Unsolved::NotAnAngle => Cause::Input,
                Unsolved::Apart { by, .. } | Unsolved::Inside { by, .. } => Cause::Apart { by },
                Unsolved::Undetermined { .. } => Cause::Undetermined,
                Unsolved::DeadPoint { .. } => Cause::DeadPoint,
            })?;
        let [coupler, rocker] = &self.arms;
        let [b, d] = [coupler, rocker].map(|arm| state.place(arm.outer));
        // Told for the kind of a dead point only; the closed form passes by itself.
        let [l2, l3] = [coupler.length(), rocker.length()];
        let square = (d - b).norm_squared().value();
        let margins = [(l2 + l3).powi(2) - square, square - (l2 - l3).powi(2)];
        state.margins[given.step] = margins.map(Jet::constant);
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

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.arms.each_ref().map(|arm| arm.body).into_iter()
    }

    fn rests_on(&self, body: BodyId) -> bool {
        self.arms.iter().any(|arm| arm.outer.body == body)
    }

    fn winds(&self) -> bool {
        false
    }

    fn has_sign(&self) -> bool {
        true
    }

    fn stretches_and_folds(&self) -> bool {
        true
    }
}
