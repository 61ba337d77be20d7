//! What angles gain in a full cycle: whole turns, or of wheels their ratio times those of what drives them.

use std::f64::consts::TAU;

use super::Motion;
use crate::index::LinkId;
use crate::mechanism::{Pose, Quantity};

/// How far from the end of a cycle angles are taken, as a share of it. The end itself is the start again, where a deltoid
/// has no pose: the rate leads from just before it to just after.
const BESIDE: [f64; 3] = [1e-6, 1e-5, 1e-4];

/// The poses just before and just after the end of a full cycle.
pub(super) struct Seam<'a> {
    motion: &'a Motion,
    period: f64,
    /// The poses, and how far they are from the end; none where there are no such poses.
    beside: Option<([Pose<3>; 2], f64)>,
}

impl Motion {
    /// The end of a full cycle of this period.
    pub(super) fn seam(&self, period: f64) -> Seam<'_> {
        let mut beside = BESIDE.into_iter().map(|share| share * period);
        let beside = beside.find_map(|beside| {
            let [before, after] = [period - beside, beside].map(|input| self.pose(input).ok());
            Some(([before?, after?], beside))
        });
        debug_assert!(beside.is_some(), "a full cycle has poses beside its end");
        Seam {
            motion: self,
            period,
            beside,
        }
    }
}

impl Seam<'_> {
    /// What a quantity has gained when the cycle is over: 0 of what is no angle, or folded.
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
        let turned = mechanism.multiple_of(link);
        let Some((poses, beside)) = &self.beside else {
            return 0.0;
        };
        let [before, after] = poses
            .each_ref()
            .map(|pose| mechanism.angle(pose, turned.of));
        let end = before.value() + before.derivative(1) * 2.0 * beside;
        turned.factor * TAU * ((end - after.value()) / TAU).round()
    }
}
