//! Arcs, dead points and periods of motions from the closed form of four-bars, without a search.

use crate::tolerance;
use std::f64::consts::{PI, TAU};

use crate::index::{BodyId, StepId};
use crate::mechanism::{Configuration, Layout, Mechanism};
use crate::position::{BodyPoint, DriveLaw, Mounting, Solvable, Step};
use crate::sorting::sort_by;
use crate::structure;
use crate::{Assembly, FourBar, Grashof, Unsolved, Vector};

/// Four-bar of the driven crank, the frame and an RRR dyad, in closed form.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DrivenFourBar<'a> {
    /// Step of the plan that solves the four-bar.
    pub(crate) step: StepId,
    pub(crate) linkage: &'a FourBar,
    /// Body of the rocker.
    pub(crate) rocker: BodyId,
    /// Offset of φ₁, the crank angle of the four-bar, from the input.
    pub(crate) angle_offset: f64,
}

/// Inputs within an arc at which the crank angle φ₁, the input plus the offset, is a multiple of π. At these inputs the
/// diagonal from the crank pin to the fixed hinge of the dyad is longest or shortest.
pub(crate) fn half_turns(angle_offset: f64, [from, to]: [f64; 2]) -> impl Iterator<Item = f64> {
    let first = ((from + angle_offset) / PI).ceil() as i32;
    let last = ((to + angle_offset) / PI).floor() as i32;
    (first..=last).map(move |half| f64::from(half) * PI - angle_offset)
}

impl DrivenFourBar<'_> {
    /// Arc that contains `input`, or otherwise the arc nearest to the input; None if the crank turns fully.
    pub(crate) fn arc(&self, input: f64) -> Option<[f64; 2]> {
        let cycle = self.linkage.cycle();
        let crank = input + self.angle_offset;
        let near = |[from, to]: &[f64; 2]| {
            let turns = crate::angle::whole_turns(crank - 0.5 * (from + to));
            let arc = [from + turns, to + turns];
            let off = (arc[0] - crank).max(crank - arc[1]).max(0.0);
            (off, arc.map(|end| end - self.angle_offset))
        };
        let arcs = cycle.arcs().iter().map(near);
        let nearest = arcs.reduce(|best, next| if next.0 < best.0 { next } else { best });
        nearest.map(|(_, arc)| arc).filter(|_| !cycle.is_full())
    }

    /// Number of turns of the crank after which the motion of the four-bar repeats.
    pub(crate) fn turns(&self) -> usize {
        let period = self.linkage.cycle().period().unwrap_or(TAU);
        (period / TAU).round() as usize
    }

    /// Input at which the crank pin of a kite lies on the fixed hinge of the rocker. Coupler and rocker then coincide
    /// and swing freely about this hinge. None if there is no such input.
    pub(crate) fn free_swing(&self) -> Option<f64> {
        let pose = self.linkage.pose::<1>(Assembly::First, 0.0);
        matches!(pose, Err(Unsolved::Undetermined { .. })).then_some(-self.angle_offset)
    }

    /// Inputs within an arc at which two motions meet, in ascending order; the end of the arc is excluded. Two motions
    /// meet at each change point and, in a kite, also at the input of the free swing.
    pub(crate) fn change_points(&self, [from, to]: [f64; 2]) -> Vec<f64> {
        let turns = self.turns();
        let period = TAU * turns as f64;
        let crossings = self.linkage.change_points().into_iter();
        let crossings = crossings.map(|point| point.crank - self.angle_offset);
        let swing = self.free_swing().into_iter();
        let swings = swing.flat_map(|input| (0..turns).map(move |turn| input + TAU * turn as f64));
        let mut found = Vec::new();
        for input in crossings.chain(swings) {
            let ahead = (input - from).rem_euclid(period);
            // Because of rounding, a change point at the start of the arc may lie just before the start.
            let ahead = if ahead > period * (1.0 - tolerance::NEGLIGIBLE) {
                0.0
            } else {
                ahead
            };
            let mut at = from + ahead;
            while at < to {
                found.push(at);
                at += period;
            }
        }
        sort_by(&mut found, f64::total_cmp);
        found
    }
}

impl Layout {
    pub(super) fn closed_steps(
        &self,
        mounting: &Mounting,
    ) -> impl Iterator<Item = DrivenFourBar<'_>> {
        let angle_offset = |body: BodyId| {
            self.steps.iter().find_map(|step| match step {
                Step::Crank(crank) if crank.body == body => Some(crank.angle_offset),
                _ => None,
            })
        };
        let steps = self.steps.enumerate();
        steps.filter_map(move |(step, placing)| {
            let four_bar = placing.four_bar()?;
            Some(DrivenFourBar {
                step,
                linkage: &four_bar.linkage,
                rocker: four_bar.rocker,
                angle_offset: four_bar.offset(mounting) - angle_offset(four_bar.crank)?,
            })
        })
    }

    pub(super) fn whole_closed_form(&self, at: &Configuration) -> bool {
        let known = |step: &Step| match step {
            Step::Crank(_) => true,
            Step::Rrr(dyad) => dyad.four_bar.is_some(),
            Step::Epicyclic(train) => train
                .bodies()
                .all(|body| !self.carries(body) && self.returns(body, at)),
            _ => false,
        };
        let driver = |step: &&structure::Step| matches!(step, structure::Step::Driver { .. });
        let alone = self.structure.steps.iter().filter(driver).count() == 1;
        alone && self.closed_steps(&at.mounting).count() <= 1 && self.steps.iter().all(known)
    }

    /// True if a wheel looks the same at any angle, or if it returns to its initial angle together with the crank or
    /// rocker that turns it.
    fn returns(&self, wheel: BodyId, at: &Configuration) -> bool {
        let Some(link) = self.made_for[wheel].filter(|_| self.shows_its_angle(wheel)) else {
            return true;
        };
        let multiple = self.multiple_of(link, &at.mounting);
        let swings = |closed: DrivenFourBar<'_>| {
            let turns = matches!(
                closed.linkage.grashof(),
                Grashof::DoubleCrank | Grashof::ChangePoint
            );
            !turns && self.made_for[closed.rocker] == Some(multiple.of)
        };
        let is_whole = multiple.factor.fract() == 0.0 && multiple.of != link;
        is_whole || self.closed_steps(&at.mounting).any(swings)
    }
}

impl Mechanism {
    /// Steps solved by the closed form of a four-bar.
    pub(crate) fn closed_steps(&self) -> impl Iterator<Item = DrivenFourBar<'_>> {
        self.layout.closed_steps(self.mounting())
    }

    /// True if closed forms give the whole motion. The linkage then consists of one driven crank, at most one four-bar,
    /// and wheels that drive nothing and return to their angles together with the crank or rocker.
    pub(crate) fn whole_closed_form(&self) -> bool {
        self.layout.whole_closed_form(&self.drawn)
    }

    /// Inputs within an arc at which the pivot of the crank is in line with the two outer hinges of an RRR or RPR dyad.
    /// One of these hinges must be on the crank, and the other fixed. The distance between them is then minimum or
    /// maximum.
    pub(crate) fn in_line(&self, arc: [f64; 2]) -> Vec<f64> {
        let closed = self.closed_steps().map(|closed| closed.angle_offset);
        let guided = self.steps().iter().filter_map(|step| match step {
            Step::Rpr(dyad) => self.lead_of(dyad.sides.each_ref().map(|side| side.outer)),
            _ => None,
        });
        let leads = closed.chain(guided);
        leads
            .flat_map(|angle_offset| half_turns(angle_offset, arc))
            .collect()
    }

    /// Angle at the pivot of the first crank, from the fixed hinge to the hinge on the crank, less the input. None
    /// unless one of the `hinges` is fixed and the other is on this crank, which must be hinged to the frame.
    fn lead_of(&self, hinges: [BodyPoint; 2]) -> Option<f64> {
        let [fixed, driven] = match hinges.map(|hinge| hinge.body == BodyId::FRAME) {
            [true, false] => hinges,
            [false, true] => [hinges[1], hinges[0]],
            _ => return None,
        };
        let crank = self.steps().iter().find_map(|step| match step {
            Step::Crank(crank) if crank.body == driven.body => Some(crank),
            _ => None,
        })?;
        let is_first = crank.at.body == BodyId::FRAME && crank.law == DriveLaw::FIRST;
        let angle = |way: Vector| way.y.atan2(way.x);
        let base = angle(fixed.local - crank.at.local);
        is_first.then(|| angle(driven.local - crank.hinge) - crank.angle_offset - base)
    }

    /// True if two drawings show the same linkage: equal names and steps, equal range and rates of the drivers, and
    /// joints at equal positions on the bodies.
    pub(crate) fn is_redrawn_as(&self, other: &Self) -> bool {
        let within = tolerance::COINCIDENT * self.size();
        let near = |a: &Vector, b: &Vector| (a - b).norm() <= within;
        let kind = std::mem::discriminant::<Step>;
        self.points().eq(other.points())
            && self.links().eq(other.links())
            && self.layout.range == other.layout.range
            && self.rates().eq(other.rates())
            && self.bodies().len() == other.bodies().len()
            && self.bodies().all(|body| {
                let [a, b] = [self, other].map(|one| one.layout.bodies.of(body));
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.0 == b.0 && near(&a.1, &b.1))
            })
            && self.steps().len() == other.steps().len()
            && self
                .steps()
                .iter()
                .zip(other.steps().iter())
                .all(|(a, b)| kind(a) == kind(b) && a.bodies() == b.bodies())
    }
}
