//! The steady cycle: the motion under load that repeats with the cycle of the linkage.

use super::run::System;
use super::{Loading, Motor, NoRun};
use crate::motion::Motion;
use crate::numeric::gauss::Adaptive;
use crate::numeric::newton::{MAX_STEPS_FROM_DRAWING, is_exact, newton};

/// Error of a step before its extrapolation, relative to the kinetic energy.
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
        Some(
            (2.0 * at.energy / reduced.inertia)
                .sqrt()
                .copysign(self.period),
        )
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
    let speed = |energy: f64, inertia: f64| (2.0 * energy / inertia).sqrt();
    let first = speed(energy, system.reduced(start)?.inertia);
    let mut done = 0.0;
    // Energy as a part of that at the start, its derivative with respect to that at the start, and the time multiplied
    // by the rate at the start: all of the same size.
    let mut state = [1.0, 1.0, 0.0];
    let mut rates = [first; 2];
    let mut steps = Adaptive::<3>::new(FIRST * system.unit * std::f64::consts::TAU);
    let least = SHORTEST * system.unit;
    while done < length {
        let from = start + sense * done;
        let most = length - done;
        let [part, slope, _] = state;
        let advance = steps.step(
            [most, least.min(most)],
            &[part, slope, 0.0],
            |moment| {
                let [part, slope, _] = moment.rates;
                let slopes = system.reduced(from + sense * moment.time).map(|reduced| {
                    let speed = speed(part * energy, reduced.inertia);
                    let rate = sense * speed;
                    let [motor, by_rate] = system.motor.torque(rate);
                    let by_rate = by_rate + reduced.linear + 2.0 * reduced.quadratic * speed;
                    let torque = reduced.torque(rate) + motor;
                    let by_energy = by_rate / (reduced.inertia * speed);
                    [sense * torque / energy, by_energy * slope, first / speed]
                });
                slopes.unwrap_or([f64::NAN; 3])
            },
            |[_, off]| off.into_iter().map(f64::abs).fold(0.0, f64::max) / (ERROR * part),
        )?;
        for (value, gained) in state.iter_mut().zip(advance.gained) {
            *value += gained;
        }
        done = if most - advance.length <= 4.0 * f64::EPSILON * length {
            length
        } else {
            done + advance.length
        };
        let reduced = system.reduced(start + sense * done)?;
        let rate = speed(state[0] * energy, reduced.inertia);
        rates = [rates[0].min(rate), rates[1].max(rate)];
    }
    let [part, slope, time] = state;
    (part > 0.0).then_some(Period {
        energy: part * energy,
        slope,
        time: time / first,
        rates,
    })
}
