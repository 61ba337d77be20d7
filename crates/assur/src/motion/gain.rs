//! Growth of angles over a full cycle: whole turns, multiplied by the gear ratio for driven wheels.

use super::Motion;
use crate::index::LinkId;
use crate::mechanism::{Pose, Quantity};

/// Poses just before the end and just after the start of a full cycle. A kite may have no pose at the end of the cycle,
/// so an angle just after the end is extrapolated from the first of these poses.
pub(super) struct Seam<'a> {
    motion: &'a Motion,
    period: f64,
    /// The two poses, and their distance from the end or the start; None if no distance tried has both poses.
    poses: Option<([Pose<3>; 2], f64)>,
}

impl Motion {
    pub(super) fn seam(&self, period: f64) -> Seam<'_> {
        let mut offsets = [1e-6, 1e-5, 1e-4].into_iter().map(|offset| offset * period);
        let poses = offsets.find_map(|offset| {
            let [before, after] = [period - offset, offset].map(|input| self.pose(input).ok());
            Some(([before?, after?], offset))
        });
        debug_assert!(poses.is_some(), "a full cycle has poses near its end");
        Seam {
            motion: self,
            period,
            poses,
        }
    }
}

impl Seam<'_> {
    /// Growth of a quantity over the cycle: 0 unless the quantity is an angle that counts whole turns.
    pub(super) fn gain(&self, quantity: Quantity) -> f64 {
        match quantity {
            Quantity::Angle(link) => self
                .motion
                .gain_in_closed_form(quantity, self.period)
                .unwrap_or_else(|| self.gain_of(link)),
            Quantity::Between([from, to]) => self.gain_of(to) - self.gain_of(from),
            Quantity::X(_)
            | Quantity::Y(_)
            | Quantity::Distance(_)
            | Quantity::Corner(_)
            | Quantity::Transmission(_)
            | Quantity::Pressure(_) => 0.0,
        }
    }

    fn gain_of(&self, link: LinkId) -> f64 {
        let mechanism = self.motion.mechanism();
        let multiple = mechanism.multiple_of(link);
        let Some((poses, offset)) = &self.poses else {
            return 0.0;
        };
        let [before, after] = poses
            .each_ref()
            .map(|pose| mechanism.angle(pose, multiple.of));
        let end = before.value() + before.derivative(1) * 2.0 * offset;
        multiple.factor * crate::angle::whole_turns(end - after.value())
    }
}
