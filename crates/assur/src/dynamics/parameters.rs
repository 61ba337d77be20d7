//! What a differential is given by. Units: kg, m, N·m, radians, seconds.

use super::{Profile, Shaft};

/// Everything that its motion depends on, as a person gives it; anything may be wrong with it.
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
    /// Of the sun, z₁.
    pub sun: u32,
    /// Of a satellite, z₂.
    pub satellite: u32,
    /// Of the ring, z₄.
    pub ring: u32,
    /// How they are magnetised.
    pub poles: Poles,
}

/// Which poles of its plates a wheel shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Poles {
    /// The same of all plates, as in the paper: a period of the field for each plate.
    Alike,
    /// North and south in turn: a period for two plates.
    Alternating,
}

/// The satellites, all alike.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Satellites {
    /// k.
    pub count: u32,
    /// Moment of inertia of one about its own axis, kg·m².
    pub inertia: f64,
    /// Mass of one, kg: it goes round with the carrier.
    pub mass: f64,
    /// Radius of the circle of their centres, m.
    pub orbit: f64,
    /// Viscous damping of one in its bearing on the carrier, N·m·s.
    pub damping: f64,
    /// What one drives.
    pub load: Load,
}

/// A shaft with what is on it.
#[derive(Clone, Debug, PartialEq)]
pub struct Driven {
    /// Moment of inertia, kg·m².
    pub inertia: f64,
    /// Viscous damping in its bearing, N·m·s.
    pub damping: f64,
    /// What it drives.
    pub load: Load,
    /// What drives it.
    pub drive: Drive,
}

/// What drives a shaft from the ground.
#[derive(Clone, Debug, PartialEq)]
pub enum Drive {
    /// A torque over time, N·m, a load in the account of energies; zero leaves it free.
    Torque(Profile),
    /// A speed over time, rad/s; zero holds it.
    Speed(Profile),
    /// It turns at so many times the speed of another shaft, which is not tied itself.
    Tied {
        /// The other one.
        to: Shaft,
        /// Its speed relative to that of the other one.
        ratio: f64,
    },
}

/// The torque of a working member against its body: a sum of parts, each zero where there is no such part.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Load {
    /// Always in the negative sense, as of a weight on a rope, N·m; either sign.
    pub constant: f64,
    /// Against the motion at any speed, as of a brush or a scraper, N·m.
    pub friction: f64,
    /// The speed about which friction changes its sense, as tanh(ω/creep), rad/s: what is at rest under friction
    /// creeps. Of use where there is friction.
    pub creep: f64,
    /// Against the motion, with the square of its speed, as of a fan or a stirrer, N·m·s².
    pub fan: f64,
}

/// A magnetic mesh of one satellite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coupling {
    /// T: the greatest torque on the central wheel, N·m.
    pub peak: f64,
    /// Damping by eddy currents: torque on the central wheel relative to its slip speed, N·m·s.
    pub damping: f64,
}

impl Parameters {
    /// A shaft with what is on it.
    pub fn shaft(&self, shaft: Shaft) -> &Driven {
        match shaft {
            Shaft::Sun => &self.sun,
            Shaft::Carrier => &self.carrier,
            Shaft::Ring => &self.ring,
        }
    }

    /// The same, to be changed.
    pub fn shaft_mut(&mut self, shaft: Shaft) -> &mut Driven {
        match shaft {
            Shaft::Sun => &mut self.sun,
            Shaft::Carrier => &mut self.carrier,
            Shaft::Ring => &mut self.ring,
        }
    }
}

impl Drive {
    /// Nothing drives it.
    pub fn free() -> Self {
        Self::Torque(Profile::zero())
    }

    /// It is held.
    pub fn held() -> Self {
        Self::Speed(Profile::zero())
    }
}

impl Load {
    /// The torque on the body at a speed, N·m.
    pub fn torque(&self, speed: f64) -> f64 {
        let friction = if self.friction > 0.0 {
            self.friction * (speed / self.creep).tanh()
        } else {
            0.0
        };
        -(self.constant + friction + self.fan * speed * speed.abs())
    }

    /// How fast the torque against the body grows with its speed at most, about this speed, N·m·s.
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
    /// Periods of the field per turn of a wheel of so many plates.
    pub(super) fn periods(&self, plates: u32) -> u32 {
        match self.poles {
            Poles::Alike => plates,
            Poles::Alternating => plates / 2,
        }
    }
}
