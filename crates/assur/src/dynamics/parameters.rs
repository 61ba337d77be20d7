//! Parameters of a differential. Units: kg, m, N·m, radians, seconds.

use super::{Profile, Shaft};

/// All parameters of the motion of a differential, as entered by a person and not yet checked.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// Magnet plates of the wheels.
    pub plates: Plates,
    /// The satellites.
    pub satellites: Satellites,
    /// The sun.
    pub sun: Driven,
    /// The carrier.
    pub carrier: Driven,
    /// The ring.
    pub ring: Driven,
    /// The mesh of the sun with one satellite.
    pub sun_mesh: Coupling,
    /// The mesh of the ring with one satellite.
    pub ring_mesh: Coupling,
}

/// Numbers of magnet plates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Plates {
    /// Plates of the sun, z₁.
    pub sun: u32,
    /// Plates of a satellite, z₂.
    pub satellite: u32,
    /// Plates of the ring, z₄.
    pub ring: u32,
    /// Magnetization of the plates.
    pub poles: Poles,
}

/// Polarity of the outward faces of a wheel's plates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Poles {
    /// Like poles, as in the paper: one period of the field per plate.
    Alike,
    /// North and south poles in turn: one period per pair of plates.
    Alternating,
}

/// The satellites, all alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Satellites {
    /// Number of satellites, k.
    pub count: u32,
    /// Moment of inertia of one satellite about its own axis, kg·m².
    pub inertia: f64,
    /// Mass of one satellite, kg. The centre of the satellite moves with the carrier.
    pub mass: f64,
    /// Radius of the circle of the satellites' centres, m.
    pub orbit: f64,
    /// Viscous damping of one satellite in its bearing on the carrier, N·m·s.
    pub damping: f64,
    /// Load on one satellite.
    pub load: Load,
}

/// A shaft with its inertia, load and drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Driven {
    /// Moment of inertia, kg·m².
    pub inertia: f64,
    /// Viscous damping in the bearing of the shaft, N·m·s.
    pub damping: f64,
    /// Load on the shaft.
    pub load: Load,
    /// Prescribed torque or motion of the shaft.
    pub drive: Drive,
}

/// Drive of a shaft from the ground.
#[derive(Clone, Debug, PartialEq)]
pub enum Drive {
    /// A torque over time, N·m, which counts as a load in the energy balance. Zero leaves the shaft free.
    Torque(Profile),
    /// A speed over time, rad/s; zero holds the shaft.
    Speed(Profile),
    /// A speed in a fixed ratio to the speed of another shaft, whose own drive must not be of this kind.
    Tied {
        /// The other shaft.
        to: Shaft,
        /// Ratio of the shaft's speed to the speed of the other shaft.
        ratio: f64,
    },
}

/// Torque of a load, such as mixing blades, on its body: the sum of three terms, zero by default.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// Constant torque, as from a weight on a rope, N·m. If positive, it acts in the negative sense of rotation.
    pub constant: f64,
    /// Coulomb friction torque, as from a brush or a scraper, N·m; smoothed near rest by `creep`.
    pub friction: f64,
    /// Creep speed, rad/s. Friction is proportional to tanh(ω/creep) at the speed ω of the body. A body held by
    /// friction therefore creeps. Used only with friction.
    pub creep: f64,
    /// Coefficient of a fan's torque, N·m·s². The torque opposes the motion, in proportion to the square of the speed.
    pub fan: f64,
}

/// The magnetic mesh of a central wheel with one satellite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coupling {
    /// Maximum torque T on the central wheel, N·m.
    pub peak: f64,
    /// Damping by eddy currents: torque on the central wheel per slip speed, N·m·s.
    pub damping: f64,
}

impl Parameters {
    /// Inertia, load and drive of a shaft.
    pub fn shaft(&self, shaft: Shaft) -> &Driven {
        match shaft {
            Shaft::Sun => &self.sun,
            Shaft::Carrier => &self.carrier,
            Shaft::Ring => &self.ring,
        }
    }

    /// Inertia, load and drive of a shaft, as a mutable reference.
    pub fn shaft_mut(&mut self, shaft: Shaft) -> &mut Driven {
        match shaft {
            Shaft::Sun => &mut self.sun,
            Shaft::Carrier => &mut self.carrier,
            Shaft::Ring => &mut self.ring,
        }
    }
}

impl Drive {
    /// Drive of a free shaft: zero torque.
    pub fn free() -> Self {
        Self::Torque(Profile::zero())
    }

    /// Drive of a held shaft: zero speed.
    pub fn held() -> Self {
        Self::Speed(Profile::zero())
    }
}

impl Load {
    /// Torque of the load on the body at this speed of the body, N·m.
    pub fn torque(&self, speed: f64) -> f64 {
        let friction = if self.friction > 0.0 {
            self.friction * (speed / self.creep).tanh()
        } else {
            0.0
        };
        -(self.constant + friction + self.fan * speed * speed.abs())
    }

    /// Upper bound, near this speed, of the derivative of the resisting torque with respect to the speed, N·m·s.
    pub(super) fn growth(&self, speed: f64) -> f64 {
        let friction = if self.friction > 0.0 {
            self.friction / self.creep
        } else {
            0.0
        };
        friction + 2.0 * self.fan * speed.abs()
    }
}

impl Plates {
    /// Number of periods of the magnetic field around a wheel with this number of plates.
    pub(super) fn periods(&self, plates: u32) -> u32 {
        match self.poles {
            Poles::Alike => plates,
            Poles::Alternating => plates / 2,
        }
    }
}
