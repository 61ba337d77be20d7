//! The energy of a linkage under load along its input.

use super::system::System;
use crate::numeric::gauss::{Adaptive, Advance};
use crate::tolerance;

/// Error of a step before its extrapolation, relative to the kinetic energy.
const ERROR: f64 = 1e-13;
/// Length of the first step, and the shortest one, as parts of the period.
const FIRST: f64 = 1e-3;
const SHORTEST: f64 = 1e-12;

/// Kinetic energy E and time along a way of the input, with their derivatives with respect to the energy at the start
/// and to a constant torque: dE/dφ = M(φ, φ̇), dt/dφ = 1/φ̇.
#[derive(Clone, Copy, Debug)]
pub(super) struct Along {
    start: f64,
    sense: f64,
    /// Speed and energy at the start.
    speed: f64,
    energy: f64,
    /// Length of the way so far.
    done: f64,
    /// E, its derivatives by the energy and by the torque, the time and its derivatives. All are divided by what they are
    /// of at the start, so that they are of the same size.
    state: [f64; 6],
    steps: Adaptive<6>,
}

/// Energy and time at the end of a way, with their derivatives by the energy at the start and by a constant torque.
#[derive(Clone, Copy, Debug)]
pub(super) struct Reached {
    pub(super) energy: f64,
    pub(super) energy_by: [f64; 2],
    pub(super) time: f64,
    pub(super) time_by: [f64; 2],
}

/// Speed of the input at a kinetic energy.
fn speed(energy: f64, inertia: f64) -> f64 {
    (2.0 * energy / inertia).sqrt()
}

impl Along {
    /// A way from an input in a sense (1 or −1) with a kinetic energy; None if nothing moves with the input there.
    pub(super) fn new(system: &mut System, start: f64, sense: f64, energy: f64) -> Option<Self> {
        Some(Self {
            start,
            sense,
            speed: speed(energy, system.reduced(start)?.inertia),
            energy,
            done: 0.0,
            state: [1.0, 1.0, 0.0, 0.0, 0.0, 0.0],
            steps: Adaptive::new(FIRST * system.unit * std::f64::consts::TAU),
        })
    }

    pub(super) fn done(&self) -> f64 {
        self.done
    }

    /// Input so far.
    pub(super) fn input(&self) -> f64 {
        self.start + self.sense * self.done
    }

    /// Rate and acceleration so far.
    pub(super) fn rates(&self, system: &mut System) -> Option<[f64; 2]> {
        let reduced = system.reduced(self.input())?;
        let rate = self.sense * speed(self.state[0] * self.energy, reduced.inertia);
        Some([rate, system.acceleration(self.input(), rate)])
    }

    pub(super) fn reached(&self, system: &System) -> Reached {
        let [
            energy,
            by_energy,
            by_torque,
            time,
            time_by_energy,
            time_by_torque,
        ] = self.state;
        let slow = 1.0 / (self.energy * self.speed);
        Reached {
            energy: energy * self.energy,
            energy_by: [by_energy, by_torque * system.unit],
            time: time / self.speed,
            time_by: [time_by_energy * slow, time_by_torque * slow * system.unit],
        }
    }

    /// Goes on to a length of the way; None if the linkage stops on it.
    pub(super) fn go(&mut self, system: &mut System, length: f64) -> Option<()> {
        while self.done < length {
            self.step(system, length)?;
        }
        Some(())
    }

    /// A step, at most to a length of the way; None if the linkage stops on it.
    pub(super) fn step(&mut self, system: &mut System, length: f64) -> Option<()> {
        let Self {
            sense,
            speed: first,
            energy,
            ..
        } = *self;
        let from = self.input();
        let left = length - self.done;
        let most = left.min(system.way_to_knot(from, sense));
        let least = SHORTEST * system.unit;
        let unit = system.unit;
        let (part, before) = (self.state[0], self.steps);
        let rate = self.sense * speed(part * energy, system.reduced(from)?.inertia);
        system.take_contacts([from, rate], sense);
        let mut trial = |system: &mut System, most: f64| {
            self.steps = before;
            self.steps.step(
                [most, least.min(most)],
                &self.state,
                |moment| {
                    let [part, by_energy, by_torque, ..] = moment.rates;
                    let input = from + sense * moment.time;
                    let slopes = system.reduced(input).and_then(|reduced| {
                        let speed = speed(part * energy, reduced.inertia);
                        let torques = system.torques_in(reduced, [input, sense * speed], true)?;
                        let friction = torques.friction;
                        // The friction depends also on the torque of the drive.
                        let by_drive = 1.0 + friction.by_drive;
                        let by_rate = torques.motor[1] * by_drive
                            + friction.by_rate
                            + reduced.linear
                            + 2.0 * reduced.quadratic * speed;
                        let grows = by_rate / (reduced.inertia * speed);
                        let slow = first / speed;
                        Some([
                            sense * torques.torque() / energy,
                            grows * by_energy,
                            grows * by_torque + by_drive * sense / unit,
                            slow,
                            -slow * by_energy / (2.0 * part),
                            -slow * by_torque / (2.0 * part),
                        ])
                    });
                    slopes.unwrap_or([f64::NAN; 6])
                },
                |[_, off]| off.into_iter().map(f64::abs).fold(0.0, f64::max) / (ERROR * part),
            )
        };
        let advance = trial(system, most)?;
        let margin = |system: &mut System, advance: &Advance<6>| {
            let input = from + sense * advance.length;
            let reduced = system.reduced(input)?;
            let rate = sense * speed((part + advance.gained[0]) * energy, reduced.inertia);
            let torques = system.torques_in(reduced, [input, rate], false)?;
            Some(torques.margin())
        };
        let advance = system.ended(advance, [least, tolerance::NEAR * unit], trial, margin)?;
        for (value, gained) in self.state.iter_mut().zip(advance.gained) {
            *value += gained;
        }
        self.done = if left - advance.length <= 4.0 * f64::EPSILON * length {
            length
        } else {
            self.done + advance.length
        };
        (self.state[0] > 0.0).then_some(())
    }
}
