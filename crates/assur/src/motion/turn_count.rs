//! Range of a motion that turns back or could not be followed further, and the whole turns of its inputs.

use std::f64::consts::TAU;

use super::DeadPoint;
use crate::Cycle;
use crate::mechanism::Mechanism;

/// Range of the input between two ends, and the angle of whole turns that was subtracted from the inputs.
///
/// Usually inputs are shifted and wrapped by whole periods, so that the range begins within half a period of 0. If the
/// motion could not be followed beyond an end, this is done only if the period is one turn and the range is at most a
/// turn: then the crank angle alone determines the pose. Otherwise inputs keep the turns of the drawn input.
pub(super) fn range_between(mechanism: &mut Mechanism, ends: [DeadPoint; 2]) -> (Cycle, f64) {
    let [first, last] = ends.map(|end| end.input);
    let given_up = ends.iter().any(|end| end.kind.is_given_up());
    let period = mechanism
        .period_of_arcs()
        .filter(|period| !given_up || *period == TAU && last - first <= TAU);
    let turned = period.map_or(0.0, |period| period * (first / period + 0.5).floor());
    let drawn_input = mechanism.drawn_input() - turned;
    let turned = if turned == 0.0 || mechanism.rebase_turns(drawn_input) {
        turned
    } else {
        0.0
    };
    let arc = [first - turned, last - turned];
    let range = if mechanism.turns() && period.is_none() {
        Cycle::swinging_by_turns(arc)
    } else {
        Cycle::swinging(arc, period)
    };
    (range, turned)
}
