//! The dyad RRR between a crank on the frame and the frame: a four-bar, whose closed form passes change points smoothly
//! without a previous pose.

use std::f64::consts::{FRAC_PI_2, PI};

use super::dyads::Triangle;
use super::{
    Angle, Arm, Cause, Complex, Enclosure, Orientation, Predictor, Sign, Singularity, Solvable,
    State, StepContext,
};
use crate::index::{BodyId, StepId};
use crate::{Assembly, FourBar, Unsolved, Vector};

/// Minimum of P and Q, relative to (l₂ + l₃)², with the links far from being in line.
const MIN_MARGIN: f64 = 1.0 / 64.0;
/// Minimum of l₂ and l₃ relative to l₂ + l₃, and of l₂ + l₃ relative to the distance from the origin, of long links.
const MIN_LENGTH: f64 = 1.0 / 64.0;

/// A four-bar within a mechanism.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FourBarStep {
    pub(crate) linkage: FourBar,
    /// The body of the crank, and φ₁, measured from the line AD, less its angle.
    pub(crate) crank: BodyId,
    pub(crate) angle_offset: f64,
    /// Coupler and rocker, and the offsets of the angles of their bodies from φ₂ and φ₃.
    pub(crate) arms: [Arm; 2],
    arm_offsets: [f64; 2],
    /// Minimum of P and Q to lay it as any dyad; infinite if it never may.
    min_margin: f64,
    /// The angles and turns of the bodies of coupler and rocker at φ₂ = φ₃ = π/2.
    across: [(f64, Vector); 2],
}

impl FourBarStep {
    /// The four-bar of a crank, with its hinge on the frame and on itself, and of the coupler and rocker that join it to
    /// the frame. None if its lengths are invalid.
    pub(crate) fn new(
        crank: BodyId,
        (a, hinge): (Vector, Vector),
        [coupler, rocker]: [Arm; 2],
    ) -> Option<Self> {
        let out = coupler.outer.local - hinge;
        let base = rocker.outer.local - a;
        let lengths = [out.norm(), coupler.length(), rocker.length(), base.norm()];
        // Maximum distance of B and D from the origin.
        let distance = (a.norm() + lengths[0]).max(rocker.outer.local.norm());
        let linkage = FourBar::new(lengths).ok()?;
        let [out, frame] = [out, base].map(|v| v.y.atan2(v.x));
        let arms = [coupler, rocker];
        let [l2, l3] = arms.each_ref().map(Arm::length);
        let sum = l2 + l3;
        let long = l2.min(l3) > MIN_LENGTH * sum && sum > MIN_LENGTH * distance;
        let plain = lengths[0] < lengths[3] && long && !linkage.changes();
        let arm_offsets = arms.each_ref().map(|arm| {
            let along = arm.to - arm.from;
            frame - along.y.atan2(along.x)
        });
        Some(Self {
            linkage,
            crank,
            angle_offset: out - frame,
            arms,
            arm_offsets,
            min_margin: if plain {
                MIN_MARGIN * sum * sum
            } else {
                f64::INFINITY
            },
            across: arm_offsets.map(|angle_offset| {
                let angle = FRAC_PI_2 + angle_offset;
                (angle, Vector::new(angle.cos(), angle.sin()))
            }),
        })
    }

    /// Lays the links as those of any dyad, which is as exact far from poses in line, and takes less than half the time.
    /// With a crank shorter than the frame φ₅ is within a quarter turn of AD, so φ₂ and φ₃ are within half a turn of ±π/2.
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

    /// Places each link by its own angle: rounding of the joints would turn a short link.
    fn set_angles<const N: usize>(&self, state: &mut State<N>, sign: Sign) -> Result<(), Cause> {
        let crank = state.angle(self.crank).value() + self.angle_offset;
        let pose = self.linkage.pose_along::<N>(sign.into(), crank);
        let pose = pose.map_err(|unsolved| match unsolved {
            Unsolved::NotAnAngle => Cause::Input,
            Unsolved::Apart { by, .. } | Unsolved::Inside { by, .. } => Cause::Apart { by },
            Unsolved::Undetermined { .. } => Cause::Undetermined,
            Unsolved::DeadPoint { .. } => Cause::DeadPoint,
        })?;
        let [coupler, rocker] = self.arm_offsets;
        let angles = [pose.coupler + coupler, pose.rocker + rocker];
        for (arm, angle) in self.arms.iter().zip(angles) {
            let at = state.place(arm.outer);
            state.put(arm.body, Complex::turn(angle), arm.from, at);
            state.bodies[arm.body].angle = Angle::Known(angle);
        }
        Ok(())
    }

    /// The side of the diagonal on which the joint of coupler and rocker is: 1 to the left, −1 to the right.
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
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let triangle = Triangle::of(state, &self.arms);
        let [p, q] = triangle.margins.map(|margin| margin.value());
        // For the kind of a dead point and the distance from one; the closed form needs no margins.
        state.margins[context.step] = triangle.margins;
        if p.min(q) > self.min_margin {
            self.lay(state, context.sign, &triangle);
            return Ok(());
        }
        self.set_angles(state, context.sign)
    }

    fn enclose(&self, _: StepId, from: &Predictor, cell: &mut Enclosure) -> bool {
        cell.enclose_arms(from, &self.arms)
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
