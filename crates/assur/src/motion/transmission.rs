//! The least transmission angle of a dyad over a motion.

use super::Motion;
use super::features::turning_points;
use crate::mechanism::RrrDyad;

/// Where a dyad transmits worst.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LeastTransmission {
    /// The transmission angle, radians; 0 at a dead point.
    pub angle: f64,
    /// The input.
    pub input: f64,
}

impl Motion {
    /// The least transmission angle of a dyad: at an extremum of the cosine between
    /// its links, at the end of an arc, or where links pass through in line. None
    /// where there is no pose at all.
    pub fn least_transmission(&self, dyad: &RrrDyad) -> Option<LeastTransmission> {
        let mechanism = self.mechanism();
        let lesser = |least: LeastTransmission, next: LeastTransmission| {
            if next.angle < least.angle {
                next
            } else {
                least
            }
        };
        let ends = self.cycle().arcs().iter().flatten().copied();
        if let Some(closed) = mechanism.closed_form_of(dyad) {
            let arcs = self.cycle().arcs().iter();
            let inputs = ends.chain(arcs.flat_map(|arc| closed.half_turns(*arc)));
            let found = inputs.filter_map(|input| {
                let angle = closed.linkage.transmission_angle(input + closed.lead);
                let angle = angle.ok()?;
                Some(LeastTransmission { angle, input })
            });
            return found.reduce(lesser);
        }
        // The cosine is linear in the squared diagonal, which needs no root.
        let diagonal = |input: f64| {
            let pose = self.pose::<3>(input).ok()?;
            Some(mechanism.diagonal(&pose, dyad))
        };
        let unit = mechanism.size() * mechanism.size();
        let extrema = turning_points(self.cycle(), &diagonal, unit);
        let inputs = extrema.iter().map(|extremum| extremum.crank).chain(ends);
        let inputs = inputs.chain(self.change_points().iter().copied());
        let found = inputs.chain([self.home()]).filter_map(|input| {
            let pose = self.pose::<1>(input).ok()?;
            let angle = mechanism.transmission_angle(&pose, dyad);
            Some(LeastTransmission { angle, input })
        });
        found.reduce(lesser)
    }
}
