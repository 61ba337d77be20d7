//! Motion under load: the input over time, with an account of the energy.

use super::system::System;
use crate::angle::sum;
use crate::forces::{Defect, Loading, Motor, Unbalanced};
use crate::mechanism::Unsolved;
use crate::motion::{DeadPoint, Motion};
use crate::numeric::gauss::{Adaptive, Advance};
use crate::tolerance;

/// Error of a step before its extrapolation, relative to a radian of the input.
pub(super) const ERROR: f64 = 1e-13;

/// Distance from an end of the motion, in radians of the input, at which a run ends. There the reduced inertia, which is
/// inversely proportional to the distance from a dead point, has half of its digits.
const AT_END: f64 = tolerance::COINCIDENT;

/// Part of the greatest speed below which a linkage is at rest.
pub(super) const REST: f64 = 1e-4;

/// Most trials for a step that ends at a knot of a table.
pub(super) const TRIALS: usize = 6;

/// Shortest step, relative to the time in which the input moves by a radian: shorter steps would only be rounding.
const SHORTEST: f64 = 1e-12;

/// Motion of a linkage of one driver under its loads and a motor: J φ̈ + ½ J′ φ̇² = M, see [`crate::forces::Reduced`]. The torque
/// of dry friction depends on the reactions, and so on the acceleration; both are found together.
///
/// The input is integrated by Gauss collocation with extrapolation. Works are integrated along, so their sum with the
/// energies shows the error.
#[derive(Clone, Debug)]
pub struct Run {
    system: System,
    state: State,
    /// Steps of the input, of the work and of the lost energy.
    steps: Adaptive<3>,
    /// Kinetic and potential energy at the start.
    opening: f64,
    /// Greatest speed so far, see [`Self::rests`].
    fastest: f64,
}

#[derive(Clone, Copy, Debug)]
struct State {
    time: f64,
    /// Input, with its rounding error.
    input: (f64, f64),
    rate: f64,
    /// Rounding error of the rate.
    rest: f64,
    /// Work of the motor and the given loads, and the energy lost in resistances, dampers and friction.
    work: f64,
    lost: f64,
}

/// State of a run at a time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// Time since the start.
    pub time: f64,
    /// Input; the angle of a crank is not reduced to a turn.
    pub input: f64,
    /// Rate of the input.
    pub rate: f64,
    /// Acceleration of the input.
    pub acceleration: f64,
    /// Kinetic energy.
    pub kinetic: f64,
    /// Potential energy of gravity and springs.
    pub potential: f64,
    /// Work of the motor and of the given forces and torques since the start.
    pub work: f64,
    /// Energy lost in resistances, dampers and friction since the start.
    pub lost: f64,
}

/// Reason why there is no run.
#[derive(Clone, Debug, PartialEq)]
pub enum NoRun {
    /// A defect of the motor.
    Motor(Defect),
    /// More drivers than are integrated.
    SeveralDrivers,
    /// Dry friction in a linkage of several drivers.
    Friction,
    /// Not one actuator and one initial rate for each driver.
    Actuators {
        /// Number of drivers.
        drivers: usize,
    },
    /// The start has no pose.
    Start(Unsolved),
    /// The rate at the start is not finite or too large.
    Rate,
    /// Nothing that moves has a mass.
    NoInertia,
    /// The spring with this index joins two links of which one turns fully relative to the other: it would be wound up.
    Wound(usize),
}

/// Reason why a run ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Halt {
    /// The motion of the input ends: at a dead point, or at the end of the range of a slide.
    End {
        /// Time at which the end is reached.
        time: f64,
        /// The end; None if the motion has none near, but steps become too short.
        end: Option<DeadPoint>,
    },
    /// The linkage locks itself by friction: no acceleration satisfies the law of friction.
    Locked {
        /// Time at which it locks.
        time: f64,
    },
}

impl Run {
    /// Run of a motion from an input at a rate, at time zero.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn new(
        motion: &Motion,
        loading: &Loading,
        motor: &Motor,
        [input, rate]: [f64; 2],
    ) -> Result<Self, NoRun> {
        let mut system = System::new(motion, loading, motor)?;
        if !(-tolerance::FARTHEST..=tolerance::FARTHEST).contains(&rate) {
            return Err(NoRun::Rate);
        }
        system.place(input).map_err(NoRun::Start)?;
        let reduced = system.reduced(input).ok_or(NoRun::NoInertia)?;
        let acceleration = system.acceleration(input, rate);
        // A first guess: the time in which the input moves by a hundredth of its unit.
        let speed = rate.abs() / system.unit + (acceleration.abs() / system.unit).sqrt();
        let length = if speed > 0.0 { 0.01 / speed } else { 0.01 };
        Ok(Self {
            opening: reduced.kinetic(rate) + reduced.potential,
            system,
            state: State {
                time: 0.0,
                input: (input, 0.0),
                rate,
                rest: 0.0,
                work: 0.0,
                lost: 0.0,
            },
            steps: Adaptive::new(length),
            fastest: 0.0,
        })
    }

    /// The motion.
    pub fn motion(&self) -> &Motion {
        &self.system.motion
    }

    /// True if nothing moves, or moves any more: the speed, and that which the acceleration would give within a radian,
    /// are a small part of the greatest so far.
    pub fn rests(&mut self) -> bool {
        let now = self.reading();
        let speed = now.rate.abs() + (now.acceleration.abs() * self.system.unit).sqrt();
        self.fastest = self.fastest.max(speed);
        speed <= REST * self.fastest
    }

    /// The state at the current time.
    pub fn reading(&mut self) -> Reading {
        let State {
            time,
            input: (input, _),
            rate,
            work,
            lost,
            ..
        } = self.state;
        let acceleration = self.system.acceleration(input, rate);
        // Steps are taken only between inputs that have a pose.
        let reduced = self.system.reduced(input).unwrap_or_default();
        Reading {
            time,
            input,
            rate,
            acceleration,
            kinetic: reduced.kinetic(rate),
            potential: reduced.potential,
            work,
            lost,
        }
    }

    /// Excess of the energy over what the account says, in units of energy: the error of the integration.
    pub fn imbalance(&mut self) -> f64 {
        let now = self.reading();
        now.kinetic + now.potential - self.opening - now.work + now.lost
    }

    /// Advances to a time.
    ///
    /// # Errors
    /// The run ends before. It stays at its last moment.
    pub fn advance(&mut self, time: f64) -> Result<(), Halt> {
        while self.state.time < time {
            self.step(time - self.state.time)
                .ok_or_else(|| self.halt())?;
            // The last step ends at the time itself, not within rounding of it.
            if time - self.state.time <= 4.0 * f64::EPSILON * time.abs() {
                self.state.time = time;
            }
            if self
                .nearest_end()
                .is_some_and(|(_, ahead)| ahead <= AT_END * self.system.unit)
            {
                return Err(self.halt());
            }
        }
        Ok(())
    }

    /// End of the motion nearest ahead, with its distance.
    fn nearest_end(&self) -> Option<(DeadPoint, f64)> {
        let at = self.system.motion.cycle().wrap(self.state.input.0);
        let sense = self.state.rate.signum();
        let ends = self.system.motion.dead_points().iter();
        let ahead = ends.map(|end| (*end, (end.input - at) * sense));
        ahead
            .filter(|(_, ahead)| *ahead >= -tolerance::CONVERGED * self.system.unit)
            .min_by(|(_, a), (_, b)| a.total_cmp(b))
    }

    /// The end of the run. Near a dead point the square of the rate is proportional to the distance, so the time left is
    /// twice the distance divided by the rate.
    fn halt(&self) -> Halt {
        let State { time, rate, .. } = self.state;
        let near = self.nearest_end();
        let near = near.filter(|(_, ahead)| *ahead <= tolerance::NEAR * self.system.unit);
        if near.is_none() && self.system.unbalanced == Some(Unbalanced::Locked) {
            return Halt::Locked { time };
        }
        let left = near.map_or(0.0, |(end, ahead)| {
            let times = if end.kind.is_dead_point() { 2.0 } else { 1.0 };
            times * ahead.max(0.0) / rate.abs().max(f64::MIN_POSITIVE)
        });
        Halt::End {
            time: time + if left.is_finite() { left } else { 0.0 },
            end: near.map(|(end, _)| end),
        }
    }

    /// Makes a step of at most a given length; None if none can be made.
    fn step(&mut self, most: f64) -> Option<()> {
        let Self {
            system,
            state,
            steps,
            ..
        } = self;
        system.unbalanced = None;
        let unit = system.unit;
        let (input, rest) = state.input;
        let Some(sense) = system.sense(input, state.rate) else {
            // Friction holds the linkage, unless it is not found.
            let is_lost = matches!(
                system.unbalanced,
                Some(Unbalanced::Unsettled | Unbalanced::Singular { .. })
            );
            state.time += most;
            return (!is_lost).then_some(());
        };
        system.take_contacts([input, state.rate], sense);
        let here = system.torques([input, state.rate])?;
        // Rate at which the input moves by its unit, also from rest.
        let scale = state.rate.abs() + (here.acceleration().abs() * unit).sqrt();
        let (least, momentum) = if scale > 0.0 {
            (SHORTEST * unit / scale, here.reduced.inertia * scale)
        } else {
            (0.0, here.reduced.inertia)
        };
        let to_knot = system.way_to_knot(input, sense);
        let before = *steps;
        // Powers are divided by a momentum, so that they are of the size of the acceleration.
        let mut trial = |system: &mut System, most: f64| {
            *steps = before;
            steps.step(
                [most, least.min(most)],
                &[state.rate, 0.0, 0.0],
                |moment| {
                    let at = [input + (rest + moment.moved[0]), moment.rates[0]];
                    system.torques(at).map_or([f64::NAN; 3], |torques| {
                        let [work, lost] = torques.powers();
                        [torques.acceleration(), work / momentum, lost / momentum]
                    })
                },
                |[moved, gained]| {
                    let rate = if scale > 0.0 {
                        gained[0].abs() / scale
                    } else {
                        0.0
                    };
                    (moved[0].abs() / unit).max(rate) / ERROR
                },
            )
        };
        let mut advance = trial(system, most)?;
        // A step beyond a knot would not see it if no stage is behind it: it ends at the knot.
        for _ in 0..TRIALS {
            let (moved, gained) = (advance.moved[0].abs(), advance.gained[0]);
            let of_motor = system.motor.part_to_knot(state.rate, gained);
            let mut part = of_motor.unwrap_or(1.0);
            if moved > to_knot + tolerance::NEGLIGIBLE * unit {
                part = part.min(to_knot / moved);
            }
            if part == 1.0 {
                break;
            }
            advance = trial(system, advance.length * part)?;
        }
        let has_friction = system.has_friction();
        let margin = |system: &mut System, advance: &Advance<3>| {
            let rate = state.rate + advance.gained[0];
            let torques = system.torques([input + (rest + advance.moved[0]), rate])?;
            let stops = if has_friction {
                rate * sense / scale
            } else {
                f64::INFINITY
            };
            Some(torques.margin().min(stops))
        };
        let lengths = [least, tolerance::NEAR * unit / scale];
        advance = system.ended(advance, lengths, trial, margin)?;
        let [rate, work, lost] = advance.gained;
        state.input = sum(input, rest + advance.moved[0]);
        state.rate = add(&mut state.rest, state.rate, rate);
        if has_friction && state.rate * sense <= tolerance::NEGLIGIBLE * scale {
            (state.rate, state.rest) = (0.0, 0.0);
        }
        state.work += momentum * work;
        state.lost += momentum * lost;
        state.time += advance.length;
        Some(())
    }
}

/// A sum whose rounding error goes into `rest`.
pub(super) fn add(rest: &mut f64, to: f64, more: f64) -> f64 {
    let (total, lost) = sum(to, *rest + more);
    *rest = lost;
    total
}
