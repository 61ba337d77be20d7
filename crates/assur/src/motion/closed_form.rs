//! Motions in closed form, without continuation: of a four-bar and its wheels, or of cranks and wheels alone.

use std::f64::consts::{PI, TAU};

use super::continuation::Knots;
use super::{DeadPoint, DeadPointKind, Motion};
use crate::mechanism::{DrivenFourBar, Mechanism, Quantity};
use crate::sorting::sort_by;
use crate::{Assembly, Cycle};

impl Motion {
    /// Motion in closed form. For a four-bar and its wheels it extends over the arc with the drawn pose if the crank
    /// cannot turn fully. For cranks and wheels alone it repeats after `turns_of_wheels` turns.
    pub(super) fn in_closed_form(mut mechanism: Mechanism, turns_of_wheels: usize) -> Self {
        let arc = mechanism.closed_steps().next();
        let arc = arc.and_then(|closed| closed.arc(mechanism.drawn_input()));
        // The arc is shifted by whole turns to begin within [−π, π).
        let turned = arc.map_or(0.0, |[from, _]| TAU * ((from + PI) / TAU).floor());
        let drawn_input = mechanism.drawn_input();
        let turned = if turned != 0.0 && mechanism.rebase_turns(drawn_input - turned) {
            turned
        } else {
            0.0
        };
        let closed = mechanism.closed_steps().next();
        let (cycle, dead_points) = match (arc, closed) {
            (Some(arc), Some(closed)) => {
                let arc = arc.map(|end| end - turned);
                let ends = arc.map(|end| dead_point(&closed, arc, end));
                (Cycle::swinging(arc, Some(TAU)), ends.to_vec())
            }
            _ => {
                let turns = closed.map_or(turns_of_wheels, |closed| closed.turns());
                (Cycle::turning(turns), Vec::new())
            }
        };
        let drawn_input = cycle.wrap(drawn_input - turned);
        let (signs, orientations) = mechanism.as_drawn();
        let knots = Knots::single(drawn_input, signs, orientations);
        Self::of(mechanism, cycle, knots, dead_points, drawn_input)
    }
}

/// The rocker of a four-bar in closed form, or a link that turns at a constant ratio to the rocker.
struct Rocker<'a> {
    closed: DrivenFourBar<'a>,
    assembly: Assembly,
    ratio: f64,
}

impl Motion {
    /// Inputs of the extrema of the angle of a four-bar's rocker or of a wheel it drives; None for other quantities.
    pub(super) fn limits_in_closed_form(&self, quantity: Quantity) -> Option<Vec<f64>> {
        let Rocker {
            closed, assembly, ..
        } = self.rocker(quantity)?;
        let limits = closed.linkage.limits(assembly).into_iter();
        let mut inputs: Vec<f64> = limits
            .map(|limit| self.cycle.wrap(limit.crank - closed.angle_offset))
            .filter(|input| self.cycle.contains(*input))
            .collect();
        sort_by(&mut inputs, f64::total_cmp);
        Some(inputs)
    }

    /// Change in the angle of a rocker, or of a wheel driven by it, over a full cycle; None for other quantities.
    pub(super) fn gain_in_closed_form(&self, quantity: Quantity, period: f64) -> Option<f64> {
        let rocker = self.rocker(quantity)?;
        // At a crank angle of 1 rad every kite is determinate.
        let at = |crank: f64| {
            let pose = rocker.closed.linkage.pose::<1>(rocker.assembly, crank);
            Some(pose.ok()?.rocker.value())
        };
        let turns = ((at(period + 1.0)? - at(1.0)?) / TAU).round();
        Some(rocker.ratio * TAU * turns)
    }

    /// Rocker to whose angle a quantity has a constant ratio; None for other quantities.
    fn rocker(&self, quantity: Quantity) -> Option<Rocker<'_>> {
        let mechanism = &self.mechanism;
        let closed = mechanism.closed_steps().next()?;
        let Quantity::Angle(link) = quantity else {
            return None;
        };
        let turned = mechanism.multiple_of(link);
        if !mechanism.whole_closed_form() || mechanism.link_of(closed.rocker) != Some(turned.of) {
            return None;
        }
        let mut guess = Vec::new();
        let (signs, _) = self.knots.near(self.drawn_input, &mut guess);
        Some(Rocker {
            closed,
            assembly: signs[closed.step].into(),
            ratio: turned.factor,
        })
    }
}

/// The dead point of a four-bar at an end of an arc. The diagonal from the crank pin to the rocker pivot grows with the
/// crank angle φ₁ from 0 to π. If it is shorter at this end than mid-arc, coupler and rocker are folded.
pub(super) fn dead_point(
    closed: &DrivenFourBar<'_>,
    [from, to]: [f64; 2],
    input: f64,
) -> DeadPoint {
    let open = |input: f64| -(input + closed.angle_offset).cos();
    let kind = if open(input) < open(0.5 * (from + to)) {
        DeadPointKind::Folded
    } else {
        DeadPointKind::Stretched
    };
    let step = closed.step;
    DeadPoint { input, kind, step }
}
