//! The motion of a four-bar and the wheels on it: the closed form tells it all, and
//! nothing has to be followed.

use std::f64::consts::{PI, TAU};

use super::knots::Knots;
use super::trace::{DeadPoint, DeadPointKind, Motion};
use crate::Cycle;
use crate::mechanism::{ClosedStep, Mechanism};

impl Motion {
    /// The motion from an assembly, where the closed form of a four-bar is all there
    /// is: of a crank that cannot turn fully, over the arc that is drawn.
    pub(super) fn in_closed_form(mechanism: &Mechanism, assembly: usize) -> Option<Self> {
        if !(mechanism.turns() && mechanism.whole_closed_form()) {
            return None;
        }
        let closed = mechanism.closed_steps().next();
        let arc = closed.and_then(|closed| closed.arc(mechanism.home()));
        let (signs, stands) = mechanism.drawn_in(assembly);
        let (cycle, dead_points, turned) = match (arc, closed) {
            (Some(arc), Some(closed)) => {
                // The arc is told by whole turns so that it begins within [−π, π).
                let turned = TAU * ((arc[0] + PI) / TAU).floor();
                let arc = arc.map(|end| end - turned);
                let ends = arc.map(|end| dead_point(&closed, arc, end));
                (Cycle::swinging(arc, Some(TAU)), ends.to_vec(), turned)
            }
            _ => {
                let turns = closed.map_or(1, |closed| closed.turns());
                (Cycle::turning(turns), Vec::new(), 0.0)
            }
        };
        let home = cycle.wrap(mechanism.home() - turned);
        let knots = Knots::alone(home, signs, stands);
        Some(Self::of(mechanism, cycle, knots, dead_points, home))
    }
}

/// The dead point of a four-bar at an end of an arc: towards φ₁ = 0 the diagonal is
/// shortest, so coupler and rocker are folded there, and stretched towards π.
pub(super) fn dead_point(closed: &ClosedStep<'_>, [from, to]: [f64; 2], input: f64) -> DeadPoint {
    let open = |input: f64| -(input + closed.lead).cos();
    let kind = if open(input) < open(0.5 * (from + to)) {
        DeadPointKind::Folded
    } else {
        DeadPointKind::Stretched
    };
    let step = closed.step;
    DeadPoint { input, kind, step }
}
