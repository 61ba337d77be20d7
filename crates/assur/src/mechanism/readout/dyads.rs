//! RRR dyads of the plan, their transmission angles, and the four-bars that they close.

use crate::index::{LinkId, PointId};
use crate::mechanism::closed::DrivenFourBar;
use crate::mechanism::{LinkOrFrame, Mechanism, Pose};
use crate::position::{Arm, Step};
use crate::{FourBar, Grashof, Jet};

/// Assur group of two links and three hinges.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct RrrDyad {
    /// The two links of the dyad.
    pub links: [LinkId; 2],
    /// Point at which the two links are hinged to each other.
    pub inner: PointId,
    /// Hinges of the two links to links already solved, in the order of `links`.
    pub outer: [OuterJoint; 2],
}

/// A hinge of a dyad to a link already solved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OuterJoint {
    /// Point of the hinge.
    pub point: PointId,
    /// Link already solved, to which the dyad is hinged.
    pub on: LinkOrFrame,
}

/// Four-bar within a linkage: an RRR dyad whose outer links are hinged to each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourBarLoop {
    /// Base: the frame, or the outer link that is solved first.
    pub base: LinkOrFrame,
    /// The other outer link.
    pub crank: LinkId,
    /// Link of the dyad that is hinged to the crank.
    pub coupler: LinkId,
    /// Link of the dyad that is hinged to the base.
    pub rocker: LinkId,
    /// Hinges A, B, C, D: base and crank, crank and coupler, coupler and rocker, rocker and base.
    pub joints: [PointId; 4],
    /// Lengths of the four-bar.
    pub linkage: FourBar,
}

impl FourBarLoop {
    /// Grashof type of the four-bar.
    pub fn grashof(&self) -> Grashof {
        self.linkage.grashof()
    }
}

impl Mechanism {
    /// The RRR dyads in the order of solving; those within groups with redundant constraints come last.
    pub fn rrr_dyads(&self) -> Vec<RrrDyad> {
        let arms = self.arms();
        arms.filter_map(|arms| self.dyad_of(arms)).collect()
    }

    /// The arms of all RRR dyads; those within groups with redundant constraints come last.
    pub(in crate::mechanism) fn arms(&self) -> impl Iterator<Item = &[Arm; 2]> {
        let solved = self.steps().iter().filter_map(arms_of);
        let passive = self.layout.passive.iter();
        solved.chain(passive.flat_map(|passive| &passive.dyads))
    }

    /// Transmission angle of a dyad in a pose: the acute angle between the lines of its two links, radians.
    pub fn transmission_angle<const N: usize>(&self, pose: &Pose<N>, dyad: &RrrDyad) -> f64 {
        let at = |point: PointId| self.place(pose, point).place();
        let inner = at(dyad.inner);
        let [u, v] = dyad.outer.map(|outer| at(outer.point) - inner);
        u.perp(&v).abs().atan2(u.dot(&v).abs())
    }

    /// Squared distance between the outer joints of a dyad. By the law of cosines this square decreases linearly with
    /// the cosine of the angle between the links, so distance and angle have their extrema at the same inputs.
    pub(crate) fn diagonal<const N: usize>(&self, pose: &Pose<N>, dyad: &RrrDyad) -> Jet<N> {
        let [b, d] = dyad.outer.map(|outer| self.place(pose, outer.point));
        let (x, y) = (d.x - b.x, d.y - b.y);
        x.square() + y.square()
    }

    /// Maximum distance between the outer joints of a dyad: the sum of the lengths of its links.
    pub(crate) fn reach_of(&self, dyad: &RrrDyad) -> f64 {
        let links = dyad.links.iter().zip(&dyad.outer);
        let lengths =
            links.map(|(link, outer)| self.length_between(*link, [dyad.inner, outer.point]));
        lengths.sum()
    }

    pub(in crate::mechanism) fn length_between(&self, link: LinkId, points: [PointId; 2]) -> f64 {
        let body = self.body_of(Some(link));
        let [from, to] = points.map(|point| self.layout.bodies.local(body, point));
        debug_assert!(from.is_some() && to.is_some(), "points of the link");
        from.zip(to).map_or(0.0, |(from, to)| (to - from).norm())
    }

    /// The four-bars, in the order of their dyads in [`Self::rrr_dyads`].
    pub fn four_bars(&self) -> Vec<FourBarLoop> {
        let arms = self.arms();
        arms.filter_map(|arms| self.four_bar_of(arms)).collect()
    }

    /// Four-bar that contains a dyad and is solved in closed form; None if there is no such four-bar.
    pub(crate) fn closed_form_of(&self, dyad: &RrrDyad) -> Option<DrivenFourBar<'_>> {
        let mut closed = self.closed_steps();
        closed.find(|closed| {
            let arms = arms_of(&self.steps()[closed.step]);
            arms.and_then(|arms| self.dyad_of(arms)).as_ref() == Some(dyad)
        })
    }

    pub(in crate::mechanism) fn dyad_of(&self, arms: &[Arm; 2]) -> Option<RrrDyad> {
        let [first, second] = arms.each_ref().map(|arm| self.link_of(arm.body));
        Some(RrrDyad {
            links: [first?, second?],
            inner: arms[0].joints[1],
            outer: arms.each_ref().map(|arm| self.outer_joint(arm)),
        })
    }

    pub(in crate::mechanism) fn outer_joint(&self, arm: &Arm) -> OuterJoint {
        OuterJoint {
            point: arm.joints[0],
            on: self.link_of(arm.outer.body),
        }
    }

    fn four_bar_of(&self, arms: &[Arm; 2]) -> Option<FourBarLoop> {
        let dyad = self.dyad_of(arms)?;
        // The body solved first is the base; the frame is before all others.
        let first = self.placed_by(arms[0].outer.body) < self.placed_by(arms[1].outer.body);
        let [on_base, on_crank] = if first { [0, 1] } else { [1, 0] };
        let [base, crank] = [on_base, on_crank].map(|k| arms[k].outer);
        if base.body == crank.body {
            return None;
        }
        let a = self.shared_by([base.body, crank.body])?;
        let lengths = [
            (crank.local - self.layout.bodies.local(crank.body, a)?).norm(),
            arms[on_crank].length(),
            arms[on_base].length(),
            (base.local - self.layout.bodies.local(base.body, a)?).norm(),
        ];
        let turned = dyad.outer[on_crank].on?;
        Some(FourBarLoop {
            base: dyad.outer[on_base].on,
            crank: turned,
            coupler: dyad.links[on_crank],
            rocker: dyad.links[on_base],
            joints: [
                a,
                dyad.outer[on_crank].point,
                dyad.inner,
                dyad.outer[on_base].point,
            ],
            linkage: FourBar::new(lengths).ok()?,
        })
    }
}

/// The arms of a step that is an RRR dyad; None for any other step.
pub(crate) fn arms_of(step: &Step) -> Option<&[Arm; 2]> {
    match step {
        Step::Rrr(dyad) => Some(&dyad.arms),
        _ => None,
    }
}
