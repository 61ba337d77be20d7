//! The steady cycle: the motion under load that repeats with the cycle of the linkage.

use super::along::{Along, Reached};
use super::balance::{balanced, period};
use super::system::System;
use crate::forces::{Loading, Motor, NoRun};
use crate::motion::{Motion, TooManyTurns};
use crate::numeric::linear::solve;
use crate::numeric::newton::{MAX_STEPS_FROM_DRAWING, is_exact, newton};
use crate::numeric::roots::root;
use crate::tolerance;

/// Part of a change below which the changes of Newton's method no longer shrink: the rest is rounding.
const SETTLED: f64 = 0.1;

/// Steady cycle of a linkage whose crank turns fully. Over the input φ the kinetic energy E = ½Jφ̇² satisfies
/// dE/dφ = M(φ, φ̇); the cycle is a fixed point of one period, found by Newton's method.
#[derive(Clone, Debug)]
pub struct SteadyCycle {
    system: System,
    start: f64,
    /// Period of the input, with the sign of the rate.
    period: f64,
    /// Kinetic energy at the start.
    energy: f64,
    /// Factor by which a small excess of energy changes over a cycle.
    pub multiplier: f64,
    /// Duration of a cycle.
    pub time: f64,
    /// Rate of the input where its magnitude is least, and where it is greatest.
    pub rates: [f64; 2],
}

/// Point of a steady cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CyclePoint {
    /// Time since the start of the cycle, at the input of the drawing.
    pub time: f64,
    /// Input.
    pub input: f64,
    /// Rate of the input.
    pub rate: f64,
    /// Acceleration of the input.
    pub acceleration: f64,
    /// Kinetic energy.
    pub kinetic: f64,
}

/// Reason why there is no steady cycle.
#[derive(Clone, Debug, PartialEq)]
pub enum NoCycle {
    /// Nothing to integrate.
    Run(NoRun),
    /// The input cannot turn fully.
    NotFull,
    /// The motion repeats only after too many turns.
    TooManyTurns(TooManyTurns),
    /// At no rate does the motor do over a cycle the work that the loads take.
    Unbalanced,
    /// From the rate at which the works balance the linkage stops, or its energy does not settle.
    NotFound,
    /// In a pose of the cycle the linkage locks itself by friction.
    Locked,
}

impl SteadyCycle {
    /// The steady cycle with a motor near a rate of the input, whose sign is that of the cycle; at the rate zero, near
    /// the rates of the motor. Without a motor, a constant torque drives the cycle at the rate as its mean over time.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn new(
        motion: &Motion,
        loading: &Loading,
        motor: Option<&Motor>,
        rate: f64,
    ) -> Result<Self, NoCycle> {
        let (mut system, _, steady) = balanced(motion, loading, motor, rate)?;
        system.motor = steady.motor;
        let start = motion.drawn_input();
        let period = period(motion)?.copysign(steady.rate);
        let reduced = system.reduced(start);
        let reduced = reduced.ok_or(NoCycle::Run(NoRun::NoInertia))?;
        let mut energy = reduced.kinetic(steady.rate);
        let step = || {
            let one = over(&mut system, [start, period], energy)?;
            let off = energy - one.energy;
            let grows = one.energy_by[0] - 1.0;
            let [change, torque] = if steady.is_held {
                let late = period / steady.rate - one.time;
                solve([[grows, one.energy_by[1]], one.time_by], [off, late])?
            } else {
                [off / grows, 0.0]
            };
            if steady.is_held {
                system.motor = Motor::Constant(system.motor.torque(0.0)[0] + torque);
            }
            // A step never takes all of the energy.
            let next = (energy + change).max(0.25 * energy);
            let size = ((next - energy).abs() + (torque * period).abs()) / next;
            energy = next;
            Some(size)
        };
        let is_last = |change: f64, last: f64| {
            is_exact(change, last) || (change <= tolerance::COINCIDENT && change >= SETTLED * last)
        };
        let settled = newton(MAX_STEPS_FROM_DRAWING, step, is_last);
        settled.map_err(|_| system.no_cycle())?;
        let found = over(&mut system, [start, period], energy);
        let found = found.ok_or_else(|| system.no_cycle())?;
        let rates = extremes(&mut system, [start, period], energy);
        let rates = rates.ok_or_else(|| system.no_cycle())?;
        Ok(Self {
            system,
            start,
            period,
            energy,
            multiplier: found.energy_by[0],
            time: found.time,
            rates,
        })
    }

    /// Rate of the input at an input; None if the input has no pose.
    pub fn rate(&mut self, input: f64) -> Option<f64> {
        let sense = self.period.signum();
        let length = (sense * (input - self.start)).rem_euclid(self.period.abs());
        let mut along = Along::new(&mut self.system, self.start, sense, self.energy)?;
        along.go(&mut self.system, length)?;
        along.rates(&mut self.system).map(|[rate, _]| rate)
    }

    /// Points of the cycle at equal steps of the input; the last is the first a period later.
    pub fn points(&mut self, steps: usize) -> Vec<CyclePoint> {
        let Self { system, period, .. } = self;
        let along = Along::new(system, self.start, period.signum(), self.energy);
        let Some(mut along) = along else {
            return Vec::new();
        };
        let points = (0..=steps).map_while(|k| {
            along.go(system, period.abs() * k as f64 / steps.max(1) as f64)?;
            let [rate, acceleration] = along.rates(system)?;
            let Reached { time, energy, .. } = along.reached(system);
            Some(CyclePoint {
                time,
                input: along.input(),
                rate,
                acceleration,
                kinetic: energy,
            })
        });
        points.collect()
    }

    /// Mean rate of the input over time.
    pub fn mean(&self) -> f64 {
        self.period / self.time
    }

    /// The drive: the motor, or the constant torque that takes its place.
    pub fn motor(&self) -> &Motor {
        &self.system.motor
    }

    /// Coefficient of non-uniformity δ = (ω_max − ω_min)/ω_m with the mean rate over time ω_m.
    pub fn non_uniformity(&self) -> f64 {
        let [least, most] = self.rates;
        (most - least) / self.mean()
    }
}

/// Integrates the energy over a way of the input; None if the linkage stops on it.
fn over(system: &mut System, [start, way]: [f64; 2], energy: f64) -> Option<Reached> {
    let mut along = Along::new(system, start, way.signum(), energy)?;
    along.go(system, way.abs())?;
    Some(along.reached(system))
}

/// Rates of least and greatest magnitude over a way of the input.
fn extremes(system: &mut System, [start, way]: [f64; 2], energy: f64) -> Option<[f64; 2]> {
    let mut along = Along::new(system, start, way.signum(), energy)?;
    let [rate, mut acceleration] = along.rates(system)?;
    let mut found = [rate; 2];
    let mut note = |rate: f64| {
        if rate.abs() < found[0].abs() {
            found[0] = rate;
        }
        if rate.abs() > found[1].abs() {
            found[1] = rate;
        }
    };
    while along.done() < way.abs() {
        let (before, was) = (along, acceleration);
        along.step(system, way.abs())?;
        let [rate, now] = along.rates(system)?;
        note(rate);
        acceleration = now;
        // The rate is extreme where its acceleration vanishes.
        if was * now < 0.0 {
            let mut at = |length: f64| {
                let mut part = before;
                part.go(system, length)?;
                part.rates(system)
            };
            let ends = [[before.done(), was], [along.done(), now]];
            let extreme = root(ends, |length| {
                at(length).map(|[_, acceleration]| acceleration)
            });
            note(at(extreme?)?[0]);
        }
    }
    Some(found)
}
