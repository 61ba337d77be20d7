//! Four-bar of a crank on the frame, an RRR dyad, and the frame. Its closed form passes change points smoothly without
//! a previous pose, and is exact next to change points.

use std::f64::consts::{FRAC_PI_2, PI};

use super::dyads::Triangle;
use super::{Angle, Arm, CLOSE, Cause, Complex, Mounting, Orientation, Sign, State, StepContext};
use crate::index::BodyId;
use crate::{Assembly, FourBar, Unsolved, Vector};

/// Minimum of the margins P = (l₂ + l₃)² − r² and Q = r² − (l₂ − l₃)², relative to (l₂ + l₃)²; r is the diagonal. Above
/// this minimum the links are far from in line, and roots lose at most two digits.
const MIN_MARGIN: f64 = 1.0 / 64.0;

/// A four-bar whose crank is the driver.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CrankFourBar {
    pub(crate) linkage: FourBar,
    pub(crate) crank: BodyId,
    /// Drawn φ₁, measured from the frame's line AD, minus the angle of the crank's body.
    angle_offset: f64,
    pub(crate) coupler: BodyId,
    pub(crate) rocker: BodyId,
    /// Angle of the coupler's body minus φ₂, and angle of the rocker's body minus φ₃.
    arm_offsets: [f64; 2],
    /// Level of the margins P and Q above which the links are placed as in any dyad. Infinite if they are never placed
    /// in this way.
    min_margin: f64,
    /// Angles of the bodies of coupler and rocker at φ₂ = φ₃ = π/2, each with the unit vector in its direction.
    across: [(f64, Vector); 2],
}

impl CrankFourBar {
    /// Four-bar of a crank and of the two arms that join it to the frame, coupler and rocker. The crank's hinge on the
    /// frame is given in the coordinates of the frame and of the crank. None if the lengths are invalid.
    pub(crate) fn new(
        crank: BodyId,
        (a, hinge): (Vector, Vector),
        arms: &[Arm; 2],
    ) -> Option<Self> {
        let [coupler, rocker] = arms;
        let out = coupler.outer.local - hinge;
        let base = rocker.outer.local - a;
        let lengths = [out.norm(), coupler.length(), rocker.length(), base.norm()];
        // Maximum distance of the crank pin B and the pivot D of the rocker from the origin.
        let distance = (a.norm() + lengths[0]).max(rocker.outer.local.norm());
        let linkage = FourBar::new(lengths).ok()?;
        let [out, frame] = [out, base].map(|v| v.y.atan2(v.x));
        let [l2, l3] = arms.each_ref().map(Arm::length);
        let sum = l2 + l3;
        let long = l2.min(l3) > CLOSE * sum && sum > CLOSE * distance;
        let plain = lengths[0] < lengths[3] && long && !linkage.changes();
        let arm_offsets = arms.each_ref().map(|arm| {
            let along = arm.to - arm.from;
            frame - along.y.atan2(along.x)
        });
        Some(Self {
            linkage,
            crank,
            angle_offset: out - frame,
            coupler: coupler.body,
            rocker: rocker.body,
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

    /// Places the links. Far from poses in line, placement as in any dyad is as exact and takes less than half as long.
    #[inline(always)]
    pub(super) fn place<const N: usize>(
        &self,
        arms: &[Arm; 2],
        state: &mut State<N>,
        context: &StepContext<'_, N>,
        triangle: &Triangle<N>,
    ) -> Result<(), Cause> {
        let [p, q] = triangle.margins.map(|margin| margin.value());
        if p.min(q) <= self.min_margin {
            return self.set_angles(arms, state, context);
        }
        triangle.lay(state, arms, triangle.root(context.sign.factor()));
        self.turn_near(arms, state, context.sign);
        Ok(())
    }

    /// Sets the angles of the two links after they were placed like the links of any dyad. The whole turns of each
    /// angle follow from a constant angle, from which it differs by at most half a turn.
    ///
    /// If the crank is shorter than the frame, the direction φ₅ of the diagonal is within a quarter turn of AD. So φ₂
    /// and φ₃ are within half a turn of π/2 or, for the sign minus, of −π/2.
    fn turn_near<const N: usize>(&self, arms: &[Arm; 2], state: &mut State<N>, sign: Sign) {
        let plus = sign == Sign::Plus;
        for (arm, (angle, turn)) in arms.iter().zip(self.across) {
            let (angle, turn) = if plus {
                (angle, turn)
            } else {
                (angle - PI, -turn)
            };
            state.turned_near(arm.body, Orientation { angle, turn });
        }
    }

    /// Places each link by its own angle, because rounding errors of the joints would rotate a short link.
    fn set_angles<const N: usize>(
        &self,
        arms: &[Arm; 2],
        state: &mut State<N>,
        context: &StepContext<'_, N>,
    ) -> Result<(), Cause> {
        let crank = state.angle(self.crank).value() + self.offset(context.mounting);
        let pose = self.linkage.pose_along::<N>(context.sign.into(), crank);
        let pose = pose.map_err(|unsolved| match unsolved {
            Unsolved::NotAnAngle => Cause::Input,
            Unsolved::Apart { by, .. } | Unsolved::Inside { by, .. } => Cause::Apart { by },
            Unsolved::Undetermined { .. } => Cause::Undetermined,
            Unsolved::DeadPoint { .. } => Cause::DeadPoint,
        })?;
        let [coupler, rocker] = self.arm_offsets;
        let angles = [pose.coupler + coupler, pose.rocker + rocker];
        for (arm, angle) in arms.iter().zip(angles) {
            let at = state.place(arm.outer);
            state.put(arm.body, Complex::turn(angle), arm.from, at);
            state.bodies[arm.body].angle = Angle::Known(angle);
        }
        Ok(())
    }

    /// Offset of φ₁ from the angle of the crank's body.
    pub(crate) fn offset(&self, mounting: &Mounting) -> f64 {
        self.angle_offset + mounting.shifts[self.coupler]
    }

    /// Side of the diagonal on which the joint of coupler and rocker lies: 1 for the left, −1 for the right.
    pub(crate) fn side(&self, sign: Sign, mounting: &Mounting, state: &State<1>) -> f64 {
        let crank = state.angle(self.crank).value() + self.offset(mounting);
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
