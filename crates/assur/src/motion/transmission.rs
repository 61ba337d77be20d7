//! Where dyads transmit worst over a motion.

use super::features::turning_points;
use super::{Motion, TooManyTurns};
use crate::Jet;
use crate::mechanism::{LinkId, Pose, Quantity, RrpDyad, RrrDyad, half_turns};

/// What is beside an end of an arc, as a share of it.
const BESIDE: f64 = 1e-12;

/// Where a dyad transmits worst.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstTransmission {
    /// The least transmission angle, 0 at a dead point; the greatest pressure angle, 90° there. Radians.
    pub angle: f64,
    /// The input.
    pub input: f64,
}

/// How well a dyad transmits over a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DyadTransmission {
    /// The transmission angle of a dyad RRR, or the pressure angle of a dyad RRP.
    pub quantity: Quantity,
    /// The links of the dyad; of a dyad RRP the rod, then the slider.
    pub links: [LinkId; 2],
    /// The least transmission angle, or the greatest pressure angle; none over a motion of too many turns to be searched.
    pub worst: Option<WorstTransmission>,
}

impl Motion {
    /// Of each dyad RRR the least transmission angle and of each dyad RRP the greatest pressure angle, in the order in
    /// which the dyads are solved.
    pub fn transmissions(&self) -> Vec<DyadTransmission> {
        let transmitting = self.mechanism().transmitting().into_iter();
        let worst = transmitting.filter_map(|quantity| {
            let (links, worst) = match &quantity {
                Quantity::Transmission(dyad) => (dyad.links, self.least_transmission(dyad)),
                Quantity::Pressure(dyad) => ([dyad.rod, dyad.slider], self.greatest_pressure(dyad)),
                _ => return None,
            };
            let worst = match worst {
                Ok(worst) => Some(worst?),
                Err(TooManyTurns { .. }) => None,
            };
            Some(DyadTransmission {
                quantity,
                links,
                worst,
            })
        });
        worst.collect()
    }

    /// The least transmission angle of a dyad: at an extremum of the cosine between
    /// its links, at the end of an arc, or where links pass through in line. None
    /// where there is no pose at all.
    ///
    /// # Errors
    /// A motion of too many turns is not searched for extrema, unless a closed form tells them.
    pub fn least_transmission(
        &self,
        dyad: &RrrDyad,
    ) -> Result<Option<WorstTransmission>, TooManyTurns> {
        let mechanism = self.mechanism();
        let lesser = |least: WorstTransmission, next: WorstTransmission| {
            if next.angle < least.angle {
                next
            } else {
                least
            }
        };
        if let Some(closed) = mechanism.closed_form_of(dyad) {
            let arcs = self.cycle().arcs().iter();
            let inputs = arcs.flat_map(|arc| {
                arc.iter()
                    .copied()
                    .chain(half_turns(closed.angle_offset, *arc))
            });
            let found = inputs.filter_map(|input| {
                let angle = closed
                    .linkage
                    .transmission_angle(input + closed.angle_offset);
                let angle = angle.ok()?;
                Some(WorstTransmission { angle, input })
            });
            return Ok(found.reduce(lesser));
        }
        // The cosine is linear in the squared diagonal, which needs no root.
        let diagonal = self.telling(|pose: &Pose<3>| mechanism.diagonal(pose, dyad));
        let diagonal = |input: f64| diagonal(input).ok();
        let reach = mechanism.reach_of(dyad);
        let unit = reach * self.unit_within(reach);
        let found = self.extreme(Quantity::Transmission(*dyad), &diagonal, unit)?;
        Ok(found.reduce(lesser))
    }

    /// The greatest pressure angle of a dyad: at an extremum of its sine, at the end of an arc, or where it passes a
    /// dead point. None where there is no pose at all.
    ///
    /// # Errors
    /// A motion of too many turns is not searched for extrema.
    pub fn greatest_pressure(
        &self,
        dyad: &RrpDyad,
    ) -> Result<Option<WorstTransmission>, TooManyTurns> {
        let mechanism = self.mechanism();
        let rise = self.telling(|pose: &Pose<3>| mechanism.rise(pose, dyad));
        let rise = |input: f64| rise(input).ok();
        let unit = self.unit_within(mechanism.rod_of(dyad));
        let found = self.extreme(Quantity::Pressure(*dyad), &rise, unit)?;
        Ok(found.reduce(|greatest, next| {
            if next.angle > greatest.angle {
                next
            } else {
                greatest
            }
        }))
    }

    /// An acute angle wherever it can be extreme: where what it is told by is, and at the ends, change points and in the
    /// drawn pose.
    fn extreme(
        &self,
        angle: Quantity,
        told_by: &dyn Fn(f64) -> Option<Jet<3>>,
        unit: f64,
    ) -> Result<impl Iterator<Item = WorstTransmission> + '_, TooManyTurns> {
        let extrema = turning_points(self, told_by, unit)?;
        // Where joints fall into one at an end, there are digits only beside it.
        let ends = self.cycle().arcs().iter().flat_map(|[from, to]| {
            let beside = BESIDE * (to - from);
            [*from, from + beside, to - beside, *to]
        });
        let inputs = extrema.into_iter().map(|extremum| extremum.input);
        let inputs = inputs
            .chain(ends)
            .chain(self.change_points().iter().copied());
        let angle = self.telling(move |pose: &Pose<1>| angle.of(self.mechanism(), pose).value());
        Ok(inputs.chain([self.drawn_input()]).filter_map(move |input| {
            let angle = angle(input).ok()?;
            Some(WorstTransmission { angle, input })
        }))
    }
}
