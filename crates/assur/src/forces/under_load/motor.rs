//! The motor of a driver: its torque by its speed.

use crate::forces::{Defect, Part};
use crate::tolerance::{self, FARTHEST};

/// Torque of the motor on the driven link by the rate ω of its coordinate; a force if a slide is driven.
#[derive(Clone, Debug, PartialEq)]
pub enum Motor {
    /// The same at every rate; zero for a linkage without a motor.
    Constant(f64),
    /// Linear, M₀(1 − ω/ω₀), as of a shunt motor.
    Linear {
        /// Torque M₀ at rest.
        stall: f64,
        /// Rate ω₀ without load.
        no_load: f64,
    },
    /// Kloss's formula of an induction motor, 2 M_k/(s/s_k + s_k/s), with the slip s = 1 − ω/ω_s.
    Kloss {
        /// Pull-out torque M_k.
        pull_out: f64,
        /// Slip s_k at the pull-out torque; greater than zero.
        slip: f64,
        /// Synchronous rate ω_s.
        synchronous: f64,
    },
    /// Linear between knots, each a rate and a torque, with increasing rates; constant beyond the table.
    Table(Vec<[f64; 2]>),
}

impl Motor {
    /// No motor.
    pub const NONE: Self = Self::Constant(0.0);

    /// Checks the numbers of the motor.
    ///
    /// # Errors
    /// A number is not finite or out of range, a rate or a slip is zero, or a table is out of order.
    pub fn check(&self) -> Result<(), Defect> {
        let sound = |value: &f64| value.is_finite() && value.abs() <= FARTHEST;
        let is_valid = match self {
            Self::Constant(torque) => sound(torque),
            Self::Linear { stall, no_load } => {
                [stall, no_load].into_iter().all(sound) && *no_load != 0.0
            }
            Self::Kloss {
                pull_out,
                slip,
                synchronous,
            } => {
                let numbers = [pull_out, slip, synchronous];
                numbers.into_iter().all(sound) && *slip > 0.0 && *synchronous != 0.0
            }
            Self::Table(knots) => {
                let ordered = knots.windows(2).all(|pair| pair[0][0] < pair[1][0]);
                !knots.is_empty() && ordered && knots.iter().flatten().all(sound)
            }
        };
        let (part, index) = (Part::Motor, 0);
        is_valid
            .then_some(())
            .ok_or(Defect::NoNumber { part, index })
    }

    /// A rate by which rates of this motor can be measured: without load, synchronous, or the last of the table.
    pub(super) fn fastest(&self) -> f64 {
        match self {
            Self::Constant(_) => 1.0,
            Self::Linear { no_load: rate, .. }
            | Self::Kloss {
                synchronous: rate, ..
            } => *rate,
            Self::Table(knots) => {
                let rates = knots.iter().map(|[rate, _]| rate.abs());
                rates.fold(0.0, f64::max).max(tolerance::NEAR)
            }
        }
    }

    /// Part of a change of the rate up to the first knot of the table that it passes.
    pub(super) fn part_to_knot(&self, rate: f64, change: f64) -> Option<f64> {
        let Self::Table(knots) = self else {
            return None;
        };
        let near = tolerance::NEGLIGIBLE * rate.abs().max(change.abs()) / change.abs();
        let parts = knots.iter().map(|[knot, _]| (knot - rate) / change);
        parts
            .filter(|part| *part > near && *part < 1.0 - near)
            .min_by(f64::total_cmp)
    }

    /// Torque at a rate, and its derivative with respect to the rate.
    pub fn torque(&self, rate: f64) -> [f64; 2] {
        match self {
            Self::Constant(torque) => [*torque, 0.0],
            Self::Linear { stall, no_load } => [stall * (1.0 - rate / no_load), -stall / no_load],
            Self::Kloss {
                pull_out,
                slip,
                synchronous,
            } => {
                let s = 1.0 - rate / synchronous;
                let sum = s * s + slip * slip;
                let by_slip = 2.0 * pull_out * slip * (slip * slip - s * s) / (sum * sum);
                [2.0 * pull_out * slip * s / sum, -by_slip / synchronous]
            }
            Self::Table(knots) => {
                let later = knots.partition_point(|[at, _]| *at <= rate);
                match (later.checked_sub(1), knots.get(later)) {
                    (Some(before), Some([to, last])) => {
                        let [from, first] = knots[before];
                        let slope = (last - first) / (to - from);
                        [first + slope * (rate - from), slope]
                    }
                    (Some(last), None) => [knots[last][1], 0.0],
                    (None, first) => [first.map_or(0.0, |[_, torque]| *torque), 0.0],
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Kloss: at rest with s_k = 0.5 the torque is 2M/(2 + 0.5), at the slip s_k it is M, at synchronism 0.
    #[test]
    fn torques_by_hand() {
        let kloss = Motor::Kloss {
            pull_out: 10.0,
            slip: 0.5,
            synchronous: 100.0,
        };
        for (rate, torque) in [(0.0, 8.0), (50.0, 10.0), (100.0, 0.0)] {
            assert!((kloss.torque(rate)[0] - torque).abs() < 1e-14);
        }
        assert!(kloss.torque(50.0)[1].abs() < 1e-15);
        let linear = Motor::Linear {
            stall: 4.0,
            no_load: 20.0,
        };
        assert_eq!(linear.torque(5.0), [3.0, -0.2]);
        let table = Motor::Table(vec![[0.0, 1.0], [2.0, 5.0]]);
        assert_eq!(
            [-1.0, 1.0, 3.0].map(|rate| table.torque(rate)[0]),
            [1.0, 3.0, 5.0]
        );
    }

    #[test]
    fn a_motor_that_is_no_number() {
        let refused = Defect::NoNumber {
            part: Part::Motor,
            index: 0,
        };
        for motor in [
            Motor::Constant(f64::NAN),
            Motor::Linear {
                stall: 1.0,
                no_load: 0.0,
            },
            Motor::Table(vec![[1.0, 1.0], [1.0, 2.0]]),
        ] {
            assert_eq!(motor.check(), Err(refused.clone()));
        }
    }
}
