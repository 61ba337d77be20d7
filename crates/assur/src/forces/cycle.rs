//! The steady cycle: the motion under load that repeats with the cycle of the linkage.

use super::run::System;
use super::{Loading, Motor, NoRun};
use crate::motion::Motion;
use crate::numeric::gauss::Adaptive;
use crate::numeric::newton::{MAX_STEPS_FROM_DRAWING, is_exact, newton};

/// Error of a step, relative to the kinetic energy.
const ERROR: f64 = 1e-13;
/// Length of the first step, and the shortest one, as parts of the period.
const FIRST: f64 = 1e-3;
const SHORTEST: f64 = 1e-12;

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
    /// Least and greatest rate of the input at the ends of the steps of integration.
    pub rates: [f64; 2],
}

/// Reason why there is no steady cycle.
#[derive(Clone, Debug, PartialEq)]
pub enum NoCycle {
    /// Nothing to integrate.
    Run(NoRun),
    /// The input cannot turn fully.
    NotFull,
    /// From every rate that was tried the linkage stops, or its energy does not settle.
    NotFound,
}

/// What a period does to the energy: its value at the end, its derivative with respect to that at the start, the time.
struct Period {
    energy: f64,
    slope: f64,
    time: f64,
    rates: [f64; 2],
}

impl SteadyCycle {
    /// The steady cycle near a rate of the input, whose sign is that of the cycle.
    ///
    /// # Errors
    /// The reason why there is none.
    pub fn new(
        motion: &Motion,
        loading: &Loading,
        motor: &Motor,
        rate: f64,
    ) -> Result<Self, NoCycle> {
        let mut system = System::new(motion, loading, motor).map_err(NoCycle::Run)?;
        let period = motion.cycle().period().filter(|_| motion.cycle().is_full());
        let period = period.ok_or(NoCycle::NotFull)?;
        if !rate.is_finite() || rate == 0.0 {
            return Err(NoCycle::Run(NoRun::Rate));
        }
        let start = motion.drawn_input();
        let period = period * rate.signum();
        let reduced = system.reduced(start);
        let reduced = reduced.ok_or(NoCycle::Run(NoRun::NoInertia))?;
        let mut energy = reduced.kinetic(rate);
        let step = || {
            let one = over(&mut system, [start, period], energy)?;
            let change = (one.energy - energy) / (1.0 - one.slope);
            // A step never takes all of the energy.
            let next = (energy + change).max(0.25 * energy);
            let size = (next - energy).abs() / next;
            energy = next;
            Some(size)
        };
        newton(MAX_STEPS_FROM_DRAWING, step, is_exact).map_err(|_| NoCycle::NotFound)?;
        let found = over(&mut system, [start, period], energy).ok_or(NoCycle::NotFound)?;
        Ok(Self {
            system,
            start,
            period,
            energy,
            multiplier: found.slope,
            time: found.time,
            rates: found.rates,
        })
    }

    /// Rate of the input at an input; None if the input has no pose.
    pub fn rate(&mut self, input: f64) -> Option<f64> {
        let ahead = (input - self.start).rem_euclid(self.period.abs());
        let way = if self.period < 0.0 {
            ahead - self.period.abs()
        } else {
            ahead
        };
        let at = over(&mut self.system, [self.start, way], self.energy)?;
        let reduced = self.system.reduced(input)?;
        Some((2.0 * at.energy / reduced.inertia).sqrt().copysign(self.period))
    }

    /// Coefficient of non-uniformity δ = (ω_max − ω_min)/ω_m with the mean rate over time ω_m.
    pub fn non_uniformity(&self) -> f64 {
        let [least, most] = self.rates;
        (most - least) * self.time / self.period.abs()
    }
}

/// Integrates the energy over a way of the input; None if the linkage stops on it.
fn over(system: &mut System, [start, way]: [f64; 2], energy: f64) -> Option<Period> {
    let length = way.abs();
    let sense = way.signum();
    let mut done = 0.0;
    // The rates of the two coordinates are the energy and its derivative with respect to that at the start.
    let mut state = [energy, 1.0];
    let mut found = Period {
        energy,
        slope: 1.0,
        time: 0.0,
        rates: [f64::INFINITY, 0.0],
    };
    let mut steps = Adaptive::new(FIRST * system.unit * std::f64::consts::TAU);
    let least = SHORTEST * system.unit;
    while done < length {
        let from = start + sense * done;
        let most = length - done;
        let scale = state[0];
        let (halves, half) = steps.step(
            [most, least.min(most)],
            &state,
            |moment| {
                let [energy, slope] = moment.rates;
                let slopes = system.reduced(from + sense * moment.time).map(|reduced| {
                    let speed = (2.0 * energy / reduced.inertia).sqrt();
                    let rate = sense * speed;
                    let [motor, by_rate] = system.motor.torque(rate);
                    let by_rate = by_rate + reduced.linear + 2.0 * reduced.quadratic * speed;
                    let torque = reduced.torque(rate) + motor;
                    [sense * torque, by_rate * slope / (reduced.inertia * speed)]
                });
                slopes.unwrap_or([f64::NAN; 2])
            },
            |_, gained| (gained[0].abs() / scale).max(gained[1].abs()) / ERROR,
        )?;
        for (k, step) in halves.iter().enumerate() {
            for (moment, _, weight) in &step.stages {
                // The stages of each half are counted from its own start.
                let at = from + sense * (k as f64 * half + moment.time);
                let reduced = system.reduced(at)?;
                found.time += weight * (0.5 * reduced.inertia / moment.rates[0]).sqrt();
            }
            state = std::array::from_fn(|n| state[n] + step.gained[n]);
        }
        done = if most - 2.0 * half <= 4.0 * f64::EPSILON * length {
            length
        } else {
            done + 2.0 * half
        };
        let reduced = system.reduced(start + sense * done)?;
        let rate = (2.0 * state[0] / reduced.inertia).sqrt();
        let [low, high] = found.rates;
        found.rates = [low.min(rate), high.max(rate)];
    }
    [found.energy, found.slope] = state;
    (state[0] > 0.0).then_some(found)
}
