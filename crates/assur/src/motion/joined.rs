//! Motions over arcs of the driver that nothing joins, in one.

use std::sync::Arc;

use super::Motion;
use super::continuation::Knots;
use crate::mechanism::Quantity;
use crate::position::{Step, power_of_two};
use crate::sorting::sort_by;

/// Why two motions are not those of one linkage over different inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unjoinable {
    /// They are of two linkages.
    OtherLinkage,
    /// A driver turns fully, or both move over the same inputs.
    Overlap,
}

impl Motion {
    /// This motion with that of another drawing of the same linkage, over inputs
    /// that this one does not come to: a crank that has to turn back may be mounted
    /// on another arc. The other's arcs are told by whole turns so that they come
    /// after these.
    ///
    /// # Errors
    /// Why they are not two motions of one linkage over different inputs.
    pub fn joined(mut self, other: Self) -> Result<Self, Unjoinable> {
        if !self.mechanism.is_redrawn_as(&other.mechanism) {
            return Err(Unjoinable::OtherLinkage);
        }
        let joined = self.cycle.joined(&other.cycle);
        let (cycle, shift) = joined.ok_or(Unjoinable::Overlap)?;
        let theirs = other.drawn_input;
        let mut knots = Knots::clone(&other.knots);
        knots.shift(shift);
        let both = self.mechanism.steps().enumerate();
        for ((step, own), other) in both.zip(other.mechanism.steps().iter()) {
            if let (Step::Group(own), Step::Group(other)) = (own, other) {
                knots.scale_margins(step, power_of_two(other.exponent() - own.exponent()));
            }
        }
        Arc::make_mut(&mut self.knots).join(knots);
        let dead_points = other.dead_points.iter().map(|dead| super::DeadPoint {
            input: dead.input + shift,
            ..*dead
        });
        self.dead_points.extend(dead_points);
        sort_by(&mut self.dead_points, |a, b| a.input.total_cmp(&b.input));
        let change_points = other.change_points.iter().map(|input| input + shift);
        self.change_points.extend(change_points);
        sort_by(&mut self.change_points, f64::total_cmp);
        self.cycle = cycle;
        self.end_in_poses();
        // What is told of the other linkage must be so of this one.
        let same = match (self.pose::<1>(theirs + shift), other.pose::<1>(theirs)) {
            (Ok(ours), Ok(theirs)) => {
                let size = 1e-6 * self.mechanism.size();
                let points = self.mechanism.point_ids();
                points
                    .flat_map(|point| [Quantity::X(point), Quantity::Y(point)])
                    .all(|place| {
                        let [a, b] = [&ours, &theirs].map(|pose| place.of(&self.mechanism, pose));
                        (a.value() - b.value()).abs() <= size
                    })
            }
            _ => false,
        };
        same.then_some(self).ok_or(Unjoinable::OtherLinkage)
    }
}
