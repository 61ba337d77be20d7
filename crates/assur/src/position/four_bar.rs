//! The dyad RRR between a crank on the frame and the frame: a four-bar, whose
//! closed form passes_change_point change points smoothly and needs no history.

use std::f64::consts::{FRAC_PI_2, PI};

use super::dyads::Triangle;
use super::{
    Angle, Arm, Cause, Complex, Enclosure, Orientation, Predictor, Sign, Singularity, Solvable,
    State, StepContext,
};
use crate::index::{BodyId, StepId};
use crate::{Assembly, FourBar, Unsolved, Vector};

/// P and Q relative to (l₂ + l₃)² from which on links are far from being in line.
const CLEAR: f64 = 1.0 / 64.0;
/// The shortest of long links relative to both together, and both to their distance from the
/// origin.
const LONG: f64 = 1.0 / 64.0;

/// A four-bar within a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FourBarStep {
    pub(crate) linkage: FourBar,
    /// The body of the crank, and what its angle lacks to φ₁ from the line AD.
    pub(crate) crank: BodyId,
    pub(crate) angle_offset: f64,
    /// Coupler and rocker, and what the angles of their bodies lack to φ₂ and φ₃.
    pub(crate) arms: [Arm; 2],
    pub(crate) leads: [f64; 2],
    /// P and Q from which on it may be laid as any dyad; infinite where it never may.
    clear: f64,
    /// The angles of the bodies of coupler and rocker, and their turns, where φ₂ and φ₃ are
    /// a quarter turn.
    across: [(f64, Vector); 2],
}

impl FourBarStep {
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
        // B and D are never farther from the origin.
        let far = (a.norm() + lengths[0]).max(rocker.outer.local.norm());
        let linkage = FourBar::new(lengths).ok()?;
        let [out, frame] = [out, base].map(|v| v.y.atan2(v.x));
        let arms = [coupler, rocker];
        let [l2, l3] = arms.each_ref().map(Arm::length);
        let sum = l2 + l3;
        let long = l2.min(l3) > LONG * sum && sum > LONG * far;
        let plain = lengths[0] < lengths[3] && long && !linkage.changes();
        let leads = arms.each_ref().map(|arm| {
            let along = arm.to - arm.from;
            frame - along.y.atan2(along.x)
        });
        Some(Self {
            linkage,
            crank,
            angle_offset: out - frame,
            arms,
            leads,
            clear: if plain {
                CLEAR * sum * sum
            } else {
                f64::INFINITY
            },
            across: leads.map(|angle_offset| {
                let angle = FRAC_PI_2 + angle_offset;
                (angle, Vector::new(angle.cos(), angle.sin()))
            }),
        })
    }

    /// Lays the links as those of any dyad, which is as exact far from poses in which they
    /// are in line, and takes less than half the time. With a crank shorter than the frame
    /// φ₅ is within a quarter turn of AD, so φ₂ and φ₃ are within half a turn of where they
    /// stand across it.
    fn lay<const N: usize>(&self, state: &mut State<N>, sign: Sign, triangle: &Triangle<N>) {
        triangle.lay(state, &self.arms, triangle.root(sign.factor()));
        let plus = sign == Sign::Plus;
        for (arm, (angle, turn)) in self.arms.iter().zip(self.across) {
            let (angle, turn) = if plus {
                (angle, turn)
            } else {
                (angle - PI, -turn)
            };
            state.turned_near(arm.body, Orientation { angle, turn });
        }
    }

    /// Turns each link by its own angle: laid between the joints, a short link would be
    /// turned by their rounding.
    fn turn<const N: usize>(&self, state: &mut State<N>, sign: Sign) -> Result<(), Cause> {
        let crank = state.angle(self.crank).value() + self.angle_offset;
        let pose = self.linkage.pose_along::<N>(sign.into(), crank);
        let pose = pose.map_err(|unsolved| match unsolved {
            Unsolved::NotAnAngle => Cause::Input,
            Unsolved::Apart { by, .. } | Unsolved::Inside { by, .. } => Cause::Apart { by },
            Unsolved::Undetermined { .. } => Cause::Undetermined,
            Unsolved::DeadPoint { .. } => Cause::DeadPoint,
        })?;
        let angles = [pose.coupler + self.leads[0], pose.rocker + self.leads[1]];
        for (arm, angle) in self.arms.iter().zip(angles) {
            let at = state.place(arm.outer);
            state.put(arm.body, Complex::turn(angle), arm.from, at);
            state.bodies[arm.body].angle = Angle::Known(angle);
        }
        Ok(())
    }

    /// On which side of the diagonal the joint of coupler and rocker is, to the left
    /// (1) or to the right (−1), with the crank where it is.
    pub(crate) fn side(&self, sign: Sign, state: &State<1>) -> f64 {
        let crank = state.angle(self.crank).value() + self.angle_offset;
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

impl Solvable for FourBarStep {
    fn solve<const N: usize>(
        &self,
        state: &mut State<N>,
        given: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let triangle = Triangle::of(state, &self.arms);
        let [p, q] = triangle.margins.map(|margin| margin.value());
        // Told for the kind of a dead point, and where there is none how far off one is; the closed form passes_change_point by itself.
        state.margins[given.step] = triangle.margins;
        if p.min(q) > self.clear {
            self.lay(state, given.sign, &triangle);
            return Ok(());
        }
        self.turn(state, given.sign)
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        cell.pair(from, &self.arms)
    }

    fn bodies(&self) -> impl Iterator<Item = BodyId> {
        self.arms.each_ref().map(|arm| arm.body).into_iter()
    }

    fn depends_on(&self, body: BodyId) -> bool {
        self.arms.iter().any(|arm| arm.outer.body == body)
    }

    fn tracks_turns(&self) -> bool {
        false
    }

    fn has_sign(&self) -> bool {
        true
    }

    fn singularity(&self) -> Singularity {
        Singularity::InLine
    }
}
