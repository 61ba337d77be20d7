//! Willis's equation of the three coaxial shafts. It is solved in `inputs.rs`; ratios of speeds are in `ratios.rs`.

use super::{TrainError, planar_shafts};
use crate::Fault;

/// Maximum absolute value of a speed, an angle, a torque, or the ratio of two shafts' speeds.
pub(super) const GREATEST: f64 = 1e12;

/// A coaxial shaft of a train.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Shaft {
    /// Shaft of the sun, link 1.
    Sun,
    /// Shaft of the carrier, link 3.
    Carrier,
    /// Shaft of the ring, link 4.
    Ring,
}

impl Shaft {
    /// All shafts.
    pub const ALL: [Self; 3] = [Self::Sun, Self::Carrier, Self::Ring];

    /// Index of the shaft in the order sun, satellite, carrier, ring.
    pub fn index(self) -> usize {
        match self {
            Self::Sun => 0,
            Self::Carrier => 2,
            Self::Ring => 3,
        }
    }

    /// Number of the shaft's link in the source paper.
    pub fn number(self) -> u8 {
        match self {
            Self::Sun => 1,
            Self::Carrier => 3,
            Self::Ring => 4,
        }
    }
}

/// A value for each shaft: angle of rotation since assembly, speed, torque or power.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Shafts {
    /// Value of the sun.
    pub sun: f64,
    /// Value of the carrier.
    pub carrier: f64,
    /// Value of the ring.
    pub ring: f64,
}

impl Shafts {
    /// The value of a shaft.
    pub fn of(&self, shaft: Shaft) -> f64 {
        match shaft {
            Shaft::Sun => self.sun,
            Shaft::Carrier => self.carrier,
            Shaft::Ring => self.ring,
        }
    }

    /// Sum over the shafts.
    pub fn sum(&self) -> f64 {
        self.sun + self.ring + self.carrier
    }

    /// Power that each shaft takes in, with these values as torques; negative if the shaft gives off power. Without
    /// losses the powers sum to zero.
    pub fn powers(&self, speeds: &Self) -> Self {
        Self::from_each(|shaft| self.of(shaft) * speeds.of(shaft))
    }

    /// Angles or speeds relative to a given shaft, taken as fixed (Willis's inversion).
    pub fn relative_to(&self, shaft: Shaft) -> Self {
        let own = self.of(shaft);
        Self::from_each(|other| self.of(other) - own)
    }

    pub(super) fn from_each(value: impl Fn(Shaft) -> f64) -> Self {
        Self {
            sun: value(Shaft::Sun),
            carrier: value(Shaft::Carrier),
            ring: value(Shaft::Ring),
        }
    }
}

/// The equation of the shafts: a ω₁ + b ω₄ − (a + b) ω₃ = 0.
///
/// It is Willis's equation (ω₁ − ω₃)/(ω₄ − ω₃) = −b/a. With single-wheel satellites, planar or bevel, a = z₁ and b =
/// z₄; this is equation (7) of the source paper. With stepped satellites a = z₁z₂′ and b = z₂z₄, both divided by the
/// greatest common divisor of z₂ and z₂′. Ratios, torques and powers all follow from the weights a, −(a + b) and b.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Differential {
    sun: u32,
    ring: u32,
}

impl Differential {
    /// Makes the equation with the weights a and b. Both are within 1 … 10⁶, because numbers of teeth are limited.
    pub(super) fn of(sun: u32, ring: u32) -> Self {
        Self { sun, ring }
    }

    /// The differential of a planar train with z₁ and z₄ teeth. It does not depend on the satellites.
    ///
    /// # Errors
    /// Every reason at once: numbers that are not positive integers within [`TEETH`](crate::gears::TEETH); a ring not
    /// larger than the sun.
    pub fn planar(sun_and_ring: [f64; 2]) -> Result<Self, Vec<TrainError>> {
        planar_shafts(sun_and_ring).map(|[sun, ring]| Self::of(sun, ring))
    }

    /// Weight of a shaft in the equation: a, −(a + b), b.
    pub fn weight(&self, shaft: Shaft) -> i64 {
        let (sun, ring) = (i64::from(self.sun), i64::from(self.ring));
        match shaft {
            Shaft::Sun => sun,
            Shaft::Carrier => -(sun + ring),
            Shaft::Ring => ring,
        }
    }

    /// The sum a + b. Satellites can be mounted at equal angles if their number divides this sum.
    pub fn pitches(&self) -> u32 {
        self.sun + self.ring
    }

    /// External torques on the shafts in steady motion without losses, from the torque on one shaft:
    /// T₁ : T₄ : T₃ = a : b : −(a + b).
    ///
    /// The torques balance, and so do their powers at all speeds that the train allows. By the principle of virtual
    /// work the torques are proportional to the weights.
    ///
    /// # Errors
    /// The torque is not finite, or is out of range.
    pub fn torques(&self, known: Shaft, torque: f64) -> Result<Shafts, Fault> {
        Fault::check_size(torque, GREATEST)?;
        Ok(self.balanced(known, torque))
    }

    /// Torques of all shafts, relative to the torque on one of them.
    pub fn torques_relative_to(&self, known: Shaft) -> Shafts {
        self.balanced(known, 1.0)
    }

    fn balanced(&self, known: Shaft, torque: f64) -> Shafts {
        let unit = torque / self.weight(known) as f64;
        Shafts::from_each(|shaft| {
            // The known torque is returned as given, not rounded.
            if shaft == known {
                torque
            } else {
                unit * self.weight(shaft) as f64
            }
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sun_of_20_ring_of_40() {
        let differential = Differential::planar([20.0, 40.0]).unwrap();
        let weights = [Shaft::Sun, Shaft::Ring, Shaft::Carrier];
        let weights = weights.map(|shaft| differential.weight(shaft));
        assert_eq!(weights, [20, 40, -60]);
        let torques = differential.torques(Shaft::Sun, 5.0).unwrap();
        assert_eq!(
            [torques.sun, torques.ring, torques.carrier],
            [5.0, 10.0, -15.0]
        );
        let (sun, ring) = (9.0, 3.0);
        let carrier = (sun + 2.0 * ring) / 3.0;
        let speeds = Shafts { sun, carrier, ring };
        assert_eq!((torques.sum(), torques.powers(&speeds).sum()), (0.0, 0.0));
        // Willis: (9 − 5)/(3 − 5) = −40/20.
        let relative = speeds.relative_to(Shaft::Carrier);
        assert_eq!((relative.sun, relative.ring), (4.0, -2.0));
        assert!(Differential::planar([40.0, 20.0]).is_err());
    }

    #[test]
    fn equal_side_wheels_share_the_torque() {
        let axle = Differential::of(16, 16);
        let torques = axle.torques(Shaft::Carrier, 10.0).unwrap();
        assert_eq!((torques.sun, torques.ring), (-5.0, -5.0));
        let speeds = Shafts {
            sun: 8.0,
            carrier: 10.0,
            ring: 12.0,
        };
        let powers = torques.powers(&speeds);
        assert_eq!(
            (powers.sun, powers.carrier, powers.ring),
            (-40.0, 100.0, -60.0)
        );
    }

    #[test]
    fn torques_are_in_the_ratio_of_the_weights() {
        let differential = Differential::of(20, 40);
        for (known, [sun, carrier, ring]) in [
            (Shaft::Sun, [1.0, -3.0, 2.0]),
            (Shaft::Carrier, [-1.0 / 3.0, 1.0, -2.0 / 3.0]),
            (Shaft::Ring, [0.5, -1.5, 1.0]),
        ] {
            let found = differential.torques_relative_to(known);
            for (found, expected) in [
                (found.sun, sun),
                (found.carrier, carrier),
                (found.ring, ring),
            ] {
                assert!((found - expected).abs() < 1e-15, "{known:?}: {found}");
            }
        }
        assert_eq!(
            differential.torques(Shaft::Sun, f64::NAN),
            Err(Fault::NotFinite)
        );
        assert_eq!(differential.pitches(), 60);
    }
}
