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
    /// the coupler and rocker that join it to the frame; none unless it comes near a
    /// change point.
    pub(crate) fn near_change_point(
        crank: BodyId,
        (a, hinge): (Vector, Vector),
        [coupler, rocker]: [Arm; 2],
    ) -> Option<Self> {
        let out = coupler.outer.local - hinge;
        let base = rocker.outer.local - a;
        let lengths = [out.norm(), coupler.length(), rocker.length(), base.norm()];
        let linkage = FourBar::new(lengths).ok()?;
        if !linkage.nears_change_point() {
            return None;
        }
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
}

impl Solvable for Closed {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &Given<'_, N>,
    ) -> Result<(), Cause> {
        let crank = state.angle(self.crank);
        let assembly = match given.sign {
            Sign::Plus => Assembly::First,
            Sign::Minus => Assembly::Second,
        };
        let pose = self
            .linkage
            .pose::<N>(assembly, crank.value() + self.lead)
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
        let angle = pose.coupler + self.leads[0];
        let turn = Complex::turn(angle);
        state.turn[coupler.body] = turn;
        state.origin[coupler.body] = b - turn.by(coupler.from);
        state.angle[coupler.body] = Angle::Known(angle);
        // The rocker ends where the coupler does: no second sine and cosine.
        state.lay(rocker, d, b + turn.by(coupler.to - coupler.from) - d);
        state.angle[rocker.body] = Angle::Known(pose.rocker + self.leads[1]);
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
