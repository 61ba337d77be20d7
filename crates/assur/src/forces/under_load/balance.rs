//! The work of the loads over a cycle, by the rate, and the rate at which a drive does it.

use super::system::System;
use crate::forces::{Loading, Motor, NoCycle, NoRun};
use crate::motion::Motion;
use crate::numeric::gauss::{B, C};
use crate::numeric::roots::bisect;
use crate::tolerance;

/// Intervals of quadrature in a turn, so that the usual knots of tables, whole degrees, lie between intervals.
const INTERVALS: usize = 360;
/// Most intervals of a cycle of many turns.
const MOST: usize = 7200;
/// Most passes in which the rate and the friction at it are found in turn.
const PASSES: usize = 30;
/// Ratio of neighbouring rates among which the steady one is looked for, and the number of them in either direction.
const RATIO: f64 = 1.1;
const RATES: i32 = 150;

/// Work over the intervals of a cycle at a constant rate ω: w₀ + w₁ω + w₂ω|ω|, without that of the drive. The work of
/// friction, which depends on the rate by the inertia forces in the reactions, is that near a given rate.
#[derive(Clone, Debug)]
pub(super) struct Balance {
    /// Length of an interval. The first begins at the input 0.
    pub(super) step: f64,
    /// Coefficients w₀, w₁, w₂ of each interval.
    pub(super) works: Vec<[f64; 3]>,
}

/// A rate at which the works of a cycle balance.
#[derive(Clone, Debug)]
pub(super) struct Steady {
    pub(super) rate: f64,
    pub(super) motor: Motor,
    /// True if the rate is that asked for, and the motor a constant torque that keeps it.
    pub(super) is_held: bool,
}

/// A linkage under load as a system, the work of its loads over a cycle, and the rate near `rate` at which a motor does
/// this work; without a motor, a constant torque does it at that rate.
pub(super) fn balanced(
    motion: &Motion,
    loading: &Loading,
    motor: Option<&Motor>,
    rate: f64,
) -> Result<(System, Balance, Steady), NoCycle> {
    let system = System::new(motion, loading, motor.unwrap_or(&Motor::NONE));
    let mut system = system.map_err(NoCycle::Run)?;
    let mut guess = match motor {
        Some(motor) if rate == 0.0 => motor.fastest().copysign(motor.torque(0.0)[0]),
        _ => rate,
    };
    for _ in 0..PASSES {
        let balance = Balance::new(&mut system, guess)?;
        let steady = balance.steady(motor, rate)?;
        let change = (steady.rate - guess).abs();
        if !system.has_friction() || change <= tolerance::COINCIDENT * steady.rate.abs() {
            return Ok((system, balance, steady));
        }
        guess = steady.rate;
    }
    Err(NoCycle::Unbalanced)
}

/// Work over a part of the input from its coefficients.
pub(super) fn work([constant, linear, quadratic]: [f64; 3], rate: f64) -> f64 {
    constant + (linear + quadratic * rate.abs()) * rate
}

/// Period of a crank that turns fully.
pub(super) fn period(motion: &Motion) -> Result<f64, NoCycle> {
    motion.searchable().map_err(NoCycle::TooManyTurns)?;
    let cycle = motion.cycle();
    cycle
        .period()
        .filter(|_| cycle.is_full())
        .ok_or(NoCycle::NotFull)
}

impl Balance {
    fn new(system: &mut System, rate: f64) -> Result<Self, NoCycle> {
        let period = period(&system.motion)?;
        let turns = (period / std::f64::consts::TAU).round() as usize;
        let count = (INTERVALS * turns.max(1)).min(MOST);
        let step = period / count as f64;
        let works = (0..count).map(|k| interval(system, [k as f64 * step, step], rate));
        let works: Option<Vec<_>> = works.collect();
        let works = works.ok_or_else(|| system.no_cycle())?;
        Ok(Self { step, works })
    }

    fn period(&self) -> f64 {
        self.step * self.works.len() as f64
    }

    fn total(&self) -> [f64; 3] {
        let zero = [0.0; 3];
        let sum = self.works.iter().fold(zero, |sum, one| {
            std::array::from_fn(|part| sum[part] + one[part])
        });
        // Forces that depend on the pose alone may do no work over a cycle; what is left is rounding.
        let size: f64 = self.works.iter().map(|one| one[0].abs()).sum();
        let [constant, linear, quadratic] = sum;
        let is_none = constant.abs() <= tolerance::NEGLIGIBLE * size;
        [if is_none { 0.0 } else { constant }, linear, quadratic]
    }

    /// The rate at which a motor does the work that the loads take; the nearest to a rate, by their ratio, from which
    /// the motion returns to it. Without a motor, or if neither the motor's work nor that of the loads depends on the
    /// rate, it is the rate itself.
    pub(super) fn steady(&self, motor: Option<&Motor>, rate: f64) -> Result<Steady, NoCycle> {
        let is_rate = rate.abs() <= tolerance::FARTHEST && rate != 0.0;
        let (period, total) = (self.period(), self.total());
        let torque = -work(total, rate) / period;
        let held = || match is_rate {
            true => Ok(Steady {
                rate,
                motor: Motor::Constant(torque),
                is_held: true,
            }),
            false => Err(NoCycle::Run(NoRun::Rate)),
        };
        let Some(motor) = motor else {
            return held();
        };
        if let Motor::Constant(given) = motor
            && total[1..] == [0.0; 2]
        {
            let is_balanced = (given - torque).abs() <= tolerance::COINCIDENT * given.abs();
            return if is_balanced {
                held()
            } else {
                Err(NoCycle::Unbalanced)
            };
        }
        let sense = if is_rate {
            rate.signum()
        } else {
            motor.torque(0.0)[0].signum()
        };
        let guess = if is_rate { rate } else { motor.fastest() }.abs();
        let drives = |speed: f64| {
            let rate = sense * speed;
            sense * (work(total, rate) + period * motor.torque(rate)[0]) > 0.0
        };
        let speed = |k: i32| guess * RATIO.powi(k);
        let nearest = (0..RATES).flat_map(|k| [k, -1 - k]);
        let ends = nearest.map(|k| [speed(k), speed(k + 1)]);
        let mut ends = ends.filter(|[slow, fast]| drives(*slow) && !drives(*fast));
        let ends = ends.next().ok_or(NoCycle::Unbalanced)?;
        Ok(Steady {
            rate: sense * bisect(ends, drives),
            motor: motor.clone(),
            is_held: false,
        })
    }
}

/// Coefficients of the work over an interval, by Gauss's quadrature, with friction at a rate; None if an input has no pose
/// or the friction is not found.
pub(super) fn interval(
    system: &mut System,
    [from, length]: [f64; 2],
    rate: f64,
) -> Option<[f64; 3]> {
    let mut sum = [0.0; 3];
    for (c, b) in C.into_iter().zip(B) {
        let reduced = system.at_rate(from + c * length, rate)?;
        let torques = [
            reduced.conservative + reduced.load,
            reduced.linear,
            reduced.quadratic,
        ];
        for (sum, torque) in sum.iter_mut().zip(torques) {
            *sum += length * b * torque;
        }
    }
    Some(sum)
}
