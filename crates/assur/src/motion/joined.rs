//! Union of two motions over separate arcs of the driver.

use std::sync::Arc;

use super::continuation::Knots;
use super::{DeadPoint, Motion};
use crate::mechanism::Quantity;
use crate::numeric::elimination::power_of_two;
use crate::position::Step;
use crate::sorting::sort_by;
use crate::tolerance;

/// Reason why two motions have no union.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unjoinable {
    /// The motions belong to different linkages, or the drawn pose of the second is not a pose of the union.
    OtherLinkage,
    /// A driver turns fully, or the inputs of the motions overlap.
    Overlap,
}

impl Motion {
    /// Union of this motion and another motion of the same linkage over other inputs. If a crank turns back, the
    /// linkage may also be assembled on an arc that this motion cannot reach; `other` starts from a drawing on such an
    /// arc. The arcs of `other` are shifted by whole turns to follow those of this motion.
    ///
    /// # Errors
    /// The motions belong to different linkages, overlap, or the drawn pose of `other` is not a pose of the union.
    pub fn joined(mut self, other: Self) -> Result<Self, Unjoinable> {
        if !self.mechanism.is_redrawn_as(&other.mechanism) {
            return Err(Unjoinable::OtherLinkage);
        }
        let joined = self.cycle.joined(&other.cycle);
        let (cycle, shift) = joined.ok_or(Unjoinable::Overlap)?;
        let mut knots = Knots::clone(&other.knots);
        knots.shift(shift);
        let both = self.mechanism.steps().enumerate();
        for ((step, own), other) in both.zip(other.mechanism.steps().iter()) {
            if let (Step::Group(own), Step::Group(other)) = (own, other) {
                knots.scale_margins(step, power_of_two(other.exponent() - own.exponent()));
            }
        }
        Arc::make_mut(&mut self.knots).join(knots);
        let dead_points = other.dead_points.iter().map(|dead| DeadPoint {
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
        // The drawn pose of the other motion must be a pose of the union.
        let input = other.drawn_input;
        let same = match (self.pose::<1>(input + shift), other.pose::<1>(input)) {
            (Ok(ours), Ok(theirs)) => {
                let size = tolerance::TRIPLE_ROOT * self.mechanism.size();
                let points = self.mechanism.point_ids();
                points
                    .flat_map(|point| [Quantity::X(point), Quantity::Y(point)])
                    .all(|coordinate| {
                        let [a, b] =
                            [&ours, &theirs].map(|pose| coordinate.of(&self.mechanism, pose));
                        (a.value() - b.value()).abs() <= size
                    })
            }
            _ => false,
        };
        same.then_some(self).ok_or(Unjoinable::OtherLinkage)
    }
}
