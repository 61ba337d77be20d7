//! Extreme transmission and pressure angles of dyads over a motion.

use super::features::turning_points;
use super::{Motion, TooManyTurns};
use crate::mechanism::{LinkId, Pose, Quantity, RrpDyad, RrrDyad, half_turns};
use crate::{Jet, tolerance};

/// The extreme transmission or pressure angle of a dyad.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorstTransmission {
    /// Minimum transmission angle (0 at a dead point) or maximum pressure angle (π/2 at a dead point), in radians.
    pub angle: f64,
    /// Input at which this angle occurs.
    pub input: f64,
}

/// Transmission of a dyad over a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DyadTransmission {
    /// The transmission angle of an RRR dyad, or the pressure angle of an RRP dyad.
    pub quantity: Quantity,
    /// Links of the dyad; for an RRP dyad the rod, then the slider.
    pub links: [LinkId; 2],
    /// Minimum transmission angle or maximum pressure angle; None if the motion has too many turns to be searched.
    pub worst: Option<WorstTransmission>,
}

impl Motion {
    /// The minimum transmission angle of each RRR dyad and the maximum pressure angle of each RRP dyad, in the order of
    /// [`Mechanism::transmitting`](crate::mechanism::Mechanism::transmitting).
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

    /// Minimum transmission angle of an RRR dyad: at an extremum of the cosine of the angle between its links, at the
    /// end of an arc, or at a change point. None if no such input has a pose.
    ///
    /// # Errors
    /// The motion has too many turns to be searched, and no closed form.
    pub fn least_transmission(
        &self,
        dyad: &RrrDyad,
    ) -> Result<Option<WorstTransmission>, TooManyTurns> {
        let mechanism = self.mechanism();
        let by_angle = |a: &WorstTransmission, b: &WorstTransmission| a.angle.total_cmp(&b.angle);
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
            return Ok(found.min_by(by_angle));
        }
        // The cosine of the angle is linear in the square of the diagonal. This square is smooth: it is computed
        // without a root.
        let diagonal = self.telling(|pose: &Pose<3>| mechanism.diagonal(pose, dyad));
        let diagonal = |input: f64| diagonal(input).ok();
        let reach = mechanism.reach_of(dyad);
        let unit = reach * self.unit_within(reach);
        let found = self.extreme(Quantity::Transmission(*dyad), &diagonal, unit)?;
        Ok(found.min_by(by_angle))
    }

    /// Maximum pressure angle of an RRP dyad: at an extremum of its sine, at the end of an arc, or at a change point.
    /// None if no such input has a pose.
    ///
    /// # Errors
    /// The motion has too many turns to be searched.
    pub fn greatest_pressure(
        &self,
        dyad: &RrpDyad,
    ) -> Result<Option<WorstTransmission>, TooManyTurns> {
        let mechanism = self.mechanism();
        let rise = self.telling(|pose: &Pose<3>| mechanism.rise(pose, dyad));
        let rise = |input: f64| rise(input).ok();
        let unit = self.unit_within(mechanism.rod_of(dyad));
        let found = self.extreme(Quantity::Pressure(*dyad), &rise, unit)?;
        // The first of equal angles is taken.
        Ok(found.min_by(|a, b| b.angle.total_cmp(&a.angle)))
    }

    /// Acute angles at all inputs at which `angle` can be extreme: the extrema of `function` (a monotone function of
    /// the angle), the ends of arcs, the change points, and the drawn pose.
    fn extreme(
        &self,
        angle: Quantity,
        function: &dyn Fn(f64) -> Option<Jet<3>>,
        unit: f64,
    ) -> Result<impl Iterator<Item = WorstTransmission> + '_, TooManyTurns> {
        let extrema = turning_points(self, function, unit)?;
        // If joints coincide at an end, the angle is exact only next to the end.
        let ends = self.cycle().arcs().iter().flat_map(|[from, to]| {
            let offset = tolerance::NEGLIGIBLE * (to - from);
            [*from, from + offset, to - offset, *to]
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
