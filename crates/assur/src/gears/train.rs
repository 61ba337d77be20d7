//! Epicyclic trains of two freedoms: sun 1, satellite 2, carrier 3, ring 4.
//!
//! One linear equation, the [`Differential`], relates the three coaxial shafts. The [`Train`] is the set of wheels that
//! realizes the equation, and the [`Layout`] gives their dimensions. Speeds are in radians per any unit of time.
//!
//! The numbering and the formulas are those of Mukhametzyanov et al., "Differential mechanism with magnetic couplings
//! of the links"; the equation is Willis's (any textbook of the theory of mechanisms).
//!
//! ```
//! use assur::gears::train::{Drive, Input, Shaft, Train};
//!
//! let train = Train::planar([20.0, 20.0, 60.0]).unwrap(); // z₁, z₂, z₄
//! let inputs = [
//!     Input { shaft: Shaft::Sun, drive: Drive::Given(10.0) },
//!     Input { shaft: Shaft::Ring, drive: Drive::Given(2.0) },
//! ];
//! let speeds = train.differential().solve(&inputs).unwrap();
//! assert_eq!(speeds.carrier, 4.0); // (10·20 + 2·60)/80
//! assert_eq!(train.spin(&speeds).along, -2.0); // ω₂
//! ```

mod conditions;
mod differential;
mod inputs;
mod layout;
mod mobility;
mod places;
mod ratios;
mod relations;
mod suggestions;
mod turning;
mod velocities;

pub use conditions::{Condition, ConditionKind, Coupling, Relation};
pub use differential::{Differential, Shaft, Shafts};
pub use inputs::{Drive, Input, InputError};
pub use layout::Layout;
pub use mobility::Counts;
pub use places::{Mounting, Place};
pub use ratios::{Identity, Ratio};
pub use suggestions::Suggestion;
pub use turning::{TimedInput, Turned, Turning};
pub use velocities::{PointVelocity, Spin, Velocities};

use super::TEETH;
use crate::Fault;

/// A wheel of a train.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Member {
    /// The sun, z₁.
    Sun,
    /// The wheel of the satellite in mesh with the sun, z₂.
    Satellite,
    /// The wheel of the satellite in mesh with the ring, z₂′: a second wheel if the satellite is stepped.
    Step,
    /// The ring, z₄.
    Ring,
}

/// Defects of the numbers that define a train.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TrainError {
    /// An invalid number of teeth, or of poles.
    Teeth {
        /// The wheel.
        member: Member,
        /// The fault.
        fault: Fault,
    },
    /// The ring of a train with parallel axes is not larger than the sun.
    RingNotLarger {
        /// Number of teeth of the sun, z₁.
        sun: u32,
        /// Number of teeth of the ring, z₄.
        ring: u32,
    },
    /// The satellite of a train with parallel axes is not smaller than the ring.
    SatelliteNotInside {
        /// Number of teeth of the satellite, z₂, or z₂′ if it is stepped.
        satellite: u32,
        /// Number of teeth of the ring, z₄.
        ring: u32,
    },
    /// The pitch cones of these bevel wheels cannot have a common apex: |z₄ − z₁| ≥ 2 z₂.
    NoCones {
        /// Number of teeth of the sun, z₁.
        sun: u32,
        /// Number of teeth of the satellite, z₂.
        satellite: u32,
        /// Number of teeth of the ring, z₄.
        ring: u32,
    },
    /// An invalid number of satellites.
    Satellites {
        /// The fault.
        fault: Fault,
    },
    /// An invalid module.
    Module {
        /// The fault.
        fault: Fault,
    },
    /// An invalid axis distance.
    AxisDistance {
        /// The fault.
        fault: Fault,
    },
}

/// Arrangement of the axes of a train.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Parallel axes, each satellite a single wheel.
    Planar,
    /// Parallel axes, each satellite two wheels on one shaft: z₂ meshes with the sun, z₂′ with the ring.
    Stepped,
    /// Intersecting axes: the "ring" is the second side wheel, which need not be larger than the sun.
    Bevel,
}

/// The wheels of an epicyclic train. Their numbers of teeth are always valid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Train {
    kind: Kind,
    sun: u32,
    satellite: u32,
    step: u32,
    ring: u32,
}

impl Train {
    /// Makes a planar train with z₁, z₂ and z₄ teeth, from numbers entered by a person.
    ///
    /// The [`Layout`] checks whether the wheels meet, and computes their positions.
    ///
    /// # Errors
    /// All numbers that are not positive integers within [`TEETH`]; if there are none, every way in which the ring is
    /// too small (not larger than the sun, not larger than the satellite).
    pub fn planar(teeth: [f64; 3]) -> Result<Self, Vec<TrainError>> {
        Self::whole(Kind::Planar, teeth)
    }

    /// Makes a planar train with stepped satellites, with z₁, z₂, z₂′ and z₄ teeth.
    ///
    /// # Errors
    /// Those of [`Train::planar`].
    pub fn stepped([sun, satellite, step, ring]: [f64; 4]) -> Result<Self, Vec<TrainError>> {
        let members = [
            (Member::Sun, sun),
            (Member::Satellite, satellite),
            (Member::Step, step),
            (Member::Ring, ring),
        ];
        let [sun, satellite, step, ring] = teeth(members)?;
        Self {
            kind: Kind::Stepped,
            sun,
            satellite,
            step,
            ring,
        }
        .checked()
    }

    /// Makes a bevel train with z₁, z₂ and z₄ teeth. In the differential of a car's axle, z₄ = z₁.
    ///
    /// # Errors
    /// All invalid numbers as in [`Train::planar`]; if there are none, wheels whose pitch cones have no common apex.
    pub fn bevel(teeth: [f64; 3]) -> Result<Self, Vec<TrainError>> {
        Self::whole(Kind::Bevel, teeth)
    }

    /// Makes a train with z₁, z₂ and z₄ teeth, in which each satellite is a single wheel.
    fn whole(kind: Kind, [sun, satellite, ring]: [f64; 3]) -> Result<Self, Vec<TrainError>> {
        let members = [
            (Member::Sun, sun),
            (Member::Satellite, satellite),
            (Member::Ring, ring),
        ];
        let [sun, satellite, ring] = teeth(members)?;
        Self {
            kind,
            sun,
            satellite,
            step: satellite,
            ring,
        }
        .checked()
    }

    /// Finds the planar train with z₁ and z₄ teeth whose gears are in contact; none if z₂ = (z₄ − z₁)/2 is invalid.
    ///
    /// # Errors
    /// Those of [`Train::planar`] for z₁ and z₄.
    pub fn in_contact(sun_and_ring: [f64; 2]) -> Result<Option<Self>, Vec<TrainError>> {
        let [sun, ring] = planar_shafts(sun_and_ring)?;
        let twice = ring - sun;
        let whole = twice % 2 == 0 && f64::from(twice / 2) >= TEETH.0;
        Ok(whole.then_some(Self {
            kind: Kind::Planar,
            sun,
            satellite: twice / 2,
            step: twice / 2,
            ring,
        }))
    }

    /// Arrangement of the axes.
    pub fn kind(&self) -> Kind {
        self.kind
    }

    /// Number of teeth (or poles) of a wheel; z₂′ is z₂ if the satellite is not stepped.
    pub fn teeth(&self, member: Member) -> u32 {
        match member {
            Member::Sun => self.sun,
            Member::Satellite => self.satellite,
            Member::Step => self.step,
            Member::Ring => self.ring,
        }
    }

    /// The equation of the three shafts.
    pub fn differential(&self) -> Differential {
        // The weights of sun and ring are in the ratio z₁ z₂′ : z₄ z₂; for a single-wheel satellite they are z₁ and z₄.
        let common = num_integer::gcd(self.satellite, self.step);
        Differential::of(
            self.sun * (self.step / common),
            self.ring * (self.satellite / common),
        )
    }

    /// The angle Σ between a satellite's axis and the central axis, radians; 0 in a planar train. In bevel trains the
    /// pitch cones of sun and ring touch that of the satellite on opposite sides, so cos Σ = (z₄ − z₁)/(2 z₂).
    pub fn inclination(&self) -> f64 {
        match self.kind {
            Kind::Planar | Kind::Stepped => 0.0,
            Kind::Bevel => self.cosine_of_inclination().acos(),
        }
    }

    fn cosine_of_inclination(&self) -> f64 {
        match self.kind {
            Kind::Planar | Kind::Stepped => 1.0,
            Kind::Bevel => {
                (f64::from(self.ring) - f64::from(self.sun)) / (2.0 * f64::from(self.satellite))
            }
        }
    }

    fn checked(self) -> Result<Self, Vec<TrainError>> {
        let Self {
            sun,
            satellite,
            step,
            ring,
            ..
        } = self;
        let mut reasons = Vec::new();
        match self.kind {
            Kind::Planar | Kind::Stepped => {
                if ring <= sun {
                    reasons.push(TrainError::RingNotLarger { sun, ring });
                }
                if ring <= step {
                    let satellite = step;
                    reasons.push(TrainError::SatelliteNotInside { satellite, ring });
                }
            }
            Kind::Bevel if ring.abs_diff(sun) >= 2 * satellite => {
                reasons.push(TrainError::NoCones {
                    sun,
                    satellite,
                    ring,
                });
            }
            Kind::Bevel => {}
        }
        if reasons.is_empty() {
            Ok(self)
        } else {
            Err(reasons)
        }
    }
}

/// Validates z₁ and z₄ of a planar train.
fn planar_shafts([sun, ring]: [f64; 2]) -> Result<[u32; 2], Vec<TrainError>> {
    let [sun, ring] = teeth([(Member::Sun, sun), (Member::Ring, ring)])?;
    if ring <= sun {
        return Err(vec![TrainError::RingNotLarger { sun, ring }]);
    }
    Ok([sun, ring])
}

fn teeth<const N: usize>(members: [(Member, f64); N]) -> Result<[u32; N], Vec<TrainError>> {
    let mut reasons = Vec::new();
    let teeth = members.map(|(member, value)| {
        let count = Fault::check_count(value, TEETH);
        count.unwrap_or_else(|fault| {
            reasons.push(TrainError::Teeth { member, fault });
            0
        })
    });
    if reasons.is_empty() {
        Ok(teeth)
    } else {
        Err(reasons)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// cos Σ = (z₄ − z₁)/(2 z₂): 0, ½ and −½; axes of a planar train are parallel.
    #[test]
    fn the_axis_of_a_bevel_satellite_leans_towards_the_smaller_wheel() {
        for (teeth, degrees) in [
            ([20.0, 15.0, 20.0], 90.0),
            ([20.0, 20.0, 40.0], 60.0),
            ([30.0, 10.0, 20.0], 120.0),
        ] {
            let train = Train::bevel(teeth).unwrap();
            let found = train.inclination().to_degrees();
            assert!((found - degrees).abs() < 1e-13, "{teeth:?}: {found}");
        }
        assert_eq!(
            Train::planar([20.0, 20.0, 60.0]).unwrap().inclination(),
            0.0
        );
    }

    /// z₁z₂′ : z₄z₂ = 20·20 : 70·30, divided by the common divisor 10 of z₂ and z₂′: 40 : 210.
    #[test]
    fn weights_of_a_stepped_train_have_no_common_divisor_of_the_satellite() {
        let train = Train::stepped([20.0, 30.0, 20.0, 70.0]).unwrap();
        let weights = Shaft::ALL.map(|shaft| train.differential().weight(shaft));
        assert_eq!(weights, [40, -250, 210]);
    }

    /// With the carrier held, a ring of 60 teeth turns three times slower than a sun of 20, in the opposite sense. The
    /// satellite turns at −z₁/z₂ = −1 times the speed of the sun.
    #[test]
    fn the_satellite_is_an_idler_if_the_carrier_is_held() {
        let train = Train::planar([20.0, 20.0, 60.0]).unwrap();
        let given = |shaft, value| Input {
            shaft,
            drive: Drive::Given(value),
        };
        let inputs = [given(Shaft::Sun, 6.0), given(Shaft::Carrier, 0.0)];
        let speeds = train.differential().solve(&inputs).unwrap();
        assert_eq!(speeds.ring, -2.0);
        assert_eq!(train.spin(&speeds).along, -6.0);
    }
}
