//! Motion of a train over time without slip.

use std::f64::consts::TAU;

use super::{Drive, Input, InputError, Kind, Member, Shaft, Shafts, Train};
use crate::{Angle, Fault};

/// Seconds per minute.
const MINUTE: f64 = 60.0;

/// An input over time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TimedInput {
    /// The shaft and its speed, in revolutions per minute.
    pub input: Input,
    /// Time in which the speed rises linearly from rest, seconds; 0 for an instantaneous start. Ignored if the shaft
    /// turns at a multiple of another shaft's speed.
    pub rise: f64,
}

/// State of a train at a time. All arrays are in the order sun, satellite, carrier, ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turned {
    /// Angles since time 0.
    pub angles: [Angle; 4],
    /// Speeds, rad/s.
    pub speeds: [f64; 4],
    /// Accelerations, rad/s².
    pub accelerations: [f64; 4],
    /// True for bevel wheels: the satellite's values are relative to the carrier, about the satellite's own axis.
    pub spins: bool,
}

impl Turned {
    /// State relative to a given shaft, taken as fixed (Willis's inversion).
    pub fn seen_from(&self, shaft: Shaft) -> Self {
        let own = shaft.index();
        let fixed = |body: usize| body == 1 && self.spins;
        let less = |values: &[f64; 4]| {
            std::array::from_fn(|body| match fixed(body) {
                true => values[body],
                false => values[body] - values[own],
            })
        };
        Self {
            angles: std::array::from_fn(|body| match fixed(body) {
                true => self.angles[body],
                false => self.angles[body] - self.angles[own],
            }),
            speeds: less(&self.speeds),
            accelerations: less(&self.accelerations),
            spins: self.spins,
        }
    }
}

/// A train with two inputs given over time. Angles are computed from the time and not from previous angles, so they are
/// exact at any time. Wheels stay in mesh however long they turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Turning {
    train: Train,
    /// The two driven shafts, each with its law of motion.
    driven: [(Shaft, Motor); 2],
    /// Shaft without an input.
    free: Shaft,
}

/// Motion of a driven shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Motor {
    Speed {
        rpm: f64,
        rise: f64,
    },
    /// Multiple of the motion of the other driven shaft.
    Other(f64),
    Rest,
}

/// A number of turns, as whole turns and a fraction.
#[derive(Clone, Copy)]
struct Turns {
    whole: i64,
    part: f64,
}

impl Turns {
    const NONE: Self = Self {
        whole: 0,
        part: 0.0,
    };

    /// Turns made at a speed, in revolutions per minute, within a time. Whole turns are split off the exact product.
    fn of(rpm: f64, seconds: f64) -> Self {
        let product = rpm * seconds;
        let low = rpm.mul_add(seconds, -product);
        let rest = product % MINUTE;
        Self {
            whole: ((product - rest) / MINUTE).round() as i64,
            part: (rest + low) / MINUTE,
        }
    }

    /// The exact product of a number of turns and a factor.
    fn product(turns: f64, factor: f64) -> Self {
        let product = turns * factor;
        let low = turns.mul_add(factor, -product);
        let whole = product.round();
        Self {
            whole: whole as i64,
            part: (product - whole) + low,
        }
    }

    fn times(self, factor: f64) -> Self {
        let [whole, part] = [self.whole as f64, self.part].map(|of| Self::product(of, factor));
        Self::combined([(1, whole), (1, part)], 1)
    }

    /// Linear combination (Σ nᵢ turnsᵢ)/divisor, with integer arithmetic for whole turns.
    fn combined<const N: usize>(terms: [(i64, Self); N], divisor: i64) -> Self {
        let (mut whole, mut part) = (0, 0.0);
        for (n, turns) in terms {
            let parts = Self::product(turns.part, n as f64);
            whole += n * turns.whole + parts.whole;
            part += parts.part;
        }
        Self {
            whole: whole.div_euclid(divisor),
            part: (whole.rem_euclid(divisor) as f64 + part) / divisor as f64,
        }
    }

    fn angle(self) -> Angle {
        Angle::of_turns(self.whole, self.part)
    }
}

impl Turning {
    /// Maximum time, seconds.
    pub const MAX_TIME: f64 = 1e6;

    /// Maximum speed of a shaft, revolutions per minute, also for motion under load.
    pub const FASTEST: f64 = 1e5;

    /// Maximum rise time, seconds.
    pub const MAX_RISE: f64 = 1e4;

    /// Minimum positive rise time, seconds; it keeps accelerations finite.
    pub const MIN_RISE: f64 = 1e-6;

    /// Makes the motion of a train with these inputs.
    ///
    /// # Errors
    /// Every invalid rise time; errors of [`Differential::solve`](super::Differential::solve); two inputs of one
    /// shaft; given speeds above [`Self::FASTEST`] or, if there are none, resulting speeds above this limit.
    pub fn new(train: Train, inputs: &[TimedInput]) -> Result<Self, Vec<InputError>> {
        let rises: Vec<InputError> = inputs.iter().filter_map(rise_fault).collect();
        let asked: Vec<Input> = inputs.iter().map(|timed| timed.input).collect();
        let solved = train.differential().solve(&asked);
        let speeds = match solved {
            Ok(speeds) if rises.is_empty() => speeds,
            Ok(_) => return Err(rises),
            Err(errors) => return Err(rises.into_iter().chain(errors).collect()),
        };
        let driven = |shaft: &Shaft| asked.iter().any(|input| input.shaft == *shaft);
        let free: Vec<Shaft> = Shaft::ALL.into_iter().filter(|one| !driven(one)).collect();
        let ([free], [one, other]) = (&free[..], inputs) else {
            // If two shafts have no input, both inputs drive the third shaft.
            let shaft = asked[0].shaft;
            return Err(vec![InputError::Twice { shaft }]);
        };
        let too_fast = |given: bool| -> Vec<InputError> {
            let is_given = |shaft: Shaft| {
                let mut inputs = asked.iter();
                inputs.any(|one| one.shaft == shaft && matches!(one.drive, Drive::Given(_)))
            };
            let shafts = Shaft::ALL.into_iter().filter(|one| is_given(*one) == given);
            let errors = shafts.filter_map(|shaft| {
                let speed = speeds.of(shaft);
                let fault = Fault::check_size(speed, Self::FASTEST).err()?;
                Some(if given {
                    InputError::Number { shaft, fault }
                } else {
                    InputError::TooFast { shaft, speed }
                })
            });
            errors.collect()
        };
        for given in [true, false] {
            let errors = too_fast(given);
            if !errors.is_empty() {
                return Err(errors);
            }
        }
        let motor =
            |one: &TimedInput, other: &TimedInput| match (one.input.drive, other.input.drive) {
                (Drive::Given(rpm), _) => Motor::Speed {
                    rpm,
                    rise: one.rise,
                },
                (Drive::Tied { .. }, Drive::Tied { .. }) => Motor::Rest,
                (Drive::Tied { to, factor }, Drive::Given(_)) if to == other.input.shaft => {
                    Motor::Other(factor)
                }
                (Drive::Tied { factor, .. }, Drive::Given(_)) => {
                    // This shaft turns through `factor` times the angle of the free shaft. By the equation of the
                    // three shafts, its angle is then a multiple of the other driven shaft's angle.
                    let weight = |shaft| train.differential().weight(shaft) as f64;
                    let [this, other] = [one, other].map(|input| weight(input.input.shaft));
                    Motor::Other(-factor * other / factor.mul_add(this, weight(*free)))
                }
            };
        Ok(Self {
            driven: [(one, other), (other, one)]
                .map(|(one, other)| (one.input.shaft, motor(one, other))),
            free: *free,
            train,
        })
    }

    /// The train.
    pub fn train(&self) -> &Train {
        &self.train
    }

    /// The shaft that is not driven.
    pub fn free(&self) -> Shaft {
        self.free
    }

    /// The state at a time from 0 to [`Self::MAX_TIME`], seconds.
    pub fn at(&self, time: f64) -> Turned {
        // NaN becomes 0.
        let time = time.clamp(0.0, Self::MAX_TIME).max(0.0);
        let angles = self.turns(|rpm, rise| Turns::of(rpm, run(time, rise)));
        let [speeds, accelerations] = [speed, acceleration].map(|rate| {
            let rates = self.rates(|rpm, rise| rpm * TAU / MINUTE * rate(time, rise));
            let [sun, carrier] = [rates.sun, rates.carrier];
            let spin = self.train.spin(&rates);
            let satellite = match self.train.kind() {
                Kind::Planar | Kind::Stepped => spin.along,
                Kind::Bevel => spin.relative,
            };
            [sun, satellite, carrier, rates.ring]
        });
        Turned {
            angles: angles.map(Turns::angle),
            speeds,
            accelerations,
            spins: self.train.kind() == Kind::Bevel,
        }
    }

    /// Speeds after all rise times, revolutions per minute.
    pub fn last_speeds(&self) -> Shafts {
        self.rates(|rpm, _| rpm)
    }

    fn turns(&self, turned: impl Fn(f64, f64) -> Turns) -> [Turns; 4] {
        let [one, other] = [0, 1].map(|this| match self.motor(this) {
            (Motor::Speed { rpm, rise }, factor) => turned(rpm, rise).times(factor),
            _ => Turns::NONE,
        });
        let free = self.free;
        let weight = |shaft| self.train.differential().weight(shaft);
        let [(first, _), (second, _)] = self.driven;
        let sign = -weight(free).signum();
        let third = Turns::combined(
            [(sign * weight(first), one), (sign * weight(second), other)],
            weight(free).abs(),
        );
        let of = |shaft| match shaft {
            _ if shaft == first => one,
            _ if shaft == second => other,
            _ => third,
        };
        let [sun, carrier, ring] = Shaft::ALL.map(of);
        let teeth = |member| i64::from(self.train.teeth(member));
        let [own, suns] = [teeth(Member::Satellite), teeth(Member::Sun)];
        let absolute = if self.train.kind() == Kind::Bevel {
            0
        } else {
            own
        };
        let satellite = Turns::combined([(suns + absolute, carrier), (-suns, sun)], own);
        [sun, satellite, carrier, ring]
    }

    fn rates(&self, rate: impl Fn(f64, f64) -> f64) -> Shafts {
        let [one, other] = [0, 1].map(|this| match self.motor(this) {
            (Motor::Speed { rpm, rise }, factor) => rate(rpm, rise) * factor,
            _ => 0.0,
        });
        let [(first, _), (second, _)] = self.driven;
        let weight = |shaft| self.train.differential().weight(shaft) as f64;
        let third = -(weight(first) * one + weight(second) * other) / weight(self.free);
        Shafts::from_each(|shaft| match shaft {
            _ if shaft == first => one,
            _ if shaft == second => other,
            _ => third,
        })
    }

    /// Motor that moves a driven shaft, and the ratio of the shaft's motion to the motion of the motor.
    fn motor(&self, this: usize) -> (Motor, f64) {
        match (self.driven[this].1, self.driven[1 - this].1) {
            (Motor::Other(factor), other) => (other, factor),
            (motor, _) => (motor, 1.0),
        }
    }
}

fn rise_fault(timed: &TimedInput) -> Option<InputError> {
    if matches!(timed.input.drive, Drive::Tied { .. }) || timed.rise == 0.0 {
        return None;
    }
    let (value, shaft) = (timed.rise, timed.input.shaft);
    let (min, max) = (Turning::MIN_RISE, Turning::MAX_RISE);
    let fault = if !value.is_finite() {
        Fault::NotFinite
    } else if value < min || value > max {
        Fault::OutOfRange { value, min, max }
    } else {
        return None;
    };
    Some(InputError::Rise { shaft, fault })
}

/// Time that a shaft would need at full speed for its angle of rotation since time 0, seconds.
fn run(time: f64, rise: f64) -> f64 {
    if time < rise {
        time * time / (2.0 * rise)
    } else {
        time - 0.5 * rise
    }
}

/// Speed as a fraction of the full speed.
fn speed(time: f64, rise: f64) -> f64 {
    if time < rise { time / rise } else { 1.0 }
}

/// Acceleration divided by the full speed, 1/s.
fn acceleration(time: f64, rise: f64) -> f64 {
    if time < rise { rise.recip() } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_are_speed_times_time() {
        for (rpm, seconds, whole, part) in [
            (90.0, 40.0, 60, 0.0),
            (25.0, 1.0, 0, 25.0 / 60.0),
            (-90.0, 1.0, -1, -0.5),
        ] {
            let turns = Turns::of(rpm, seconds);
            assert_eq!((turns.whole, turns.part), (whole, part), "{rpm}");
        }
    }

    /// A speed that rises over 4 s. After 2 s it is half of the full speed, and the shaft has made as many turns as in
    /// 0.5 s at full speed. After t ≥ 4 s the shaft has made as many turns as in t − 2 s at full speed.
    #[test]
    fn a_linear_rise_costs_half_its_time() {
        for (time, expected) in [
            (2.0, [0.5, 0.5, 0.25]),
            (4.0, [2.0, 1.0, 0.0]),
            (10.0, [8.0, 1.0, 0.0]),
        ] {
            let found = [run(time, 4.0), speed(time, 4.0), acceleration(time, 4.0)];
            assert_eq!(found, expected, "{time}");
        }
    }
}
