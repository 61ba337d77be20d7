//! Motion of all shafts if two of the three are driven, held, or turn at a multiple of another shaft's speed.

use crate::tolerance;
use nalgebra::Vector3;

use super::differential::GREATEST;
use super::{Differential, Shaft, Shafts};
use crate::Fault;

/// Input of a shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Shaft with the input.
    pub shaft: Shaft,
    /// Prescribed motion of the shaft.
    pub drive: Drive,
}

/// Drive of a shaft from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive {
    /// Prescribed speed or angle of rotation; 0 holds the shaft.
    Given(f64),
    /// A multiple of another shaft's speed, as if the two shafts were geared together.
    Tied {
        /// The other shaft.
        to: Shaft,
        /// Ratio of this shaft's speed to the other shaft's speed.
        factor: f64,
    },
}

/// Reasons why inputs do not determine the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InputError {
    /// A speed or a factor that is not finite, or is out of range.
    Number {
        /// The shaft of the input.
        shaft: Shaft,
        /// The fault.
        fault: Fault,
    },
    /// An invalid rise time of a shaft's speed.
    Rise {
        /// The shaft.
        shaft: Shaft,
        /// The fault.
        fault: Fault,
    },
    /// The inputs make a shaft turn too fast to compute its angles.
    TooFast {
        /// The shaft.
        shaft: Shaft,
        /// Speed of the shaft, revolutions per minute.
        speed: f64,
    },
    /// The shaft is to turn at a multiple of its own speed.
    TiedToItself {
        /// The shaft.
        shaft: Shaft,
    },
    /// A shaft has two inputs.
    Twice {
        /// The shaft.
        shaft: Shaft,
    },
    /// Fewer inputs than the two freedoms of the train.
    Underdetermined {
        /// Number of inputs.
        given: usize,
    },
    /// More inputs than the two freedoms of the train.
    Overdetermined {
        /// Number of inputs.
        given: usize,
    },
    /// The given ratio of two shafts' speeds, together with the other input, leaves the motion undetermined: the train
    /// may be at rest or move at any speed.
    SingularTie {
        /// The shaft of the input.
        shaft: Shaft,
        /// The other shaft.
        to: Shaft,
        /// Ratio of the shaft's speed to the other shaft's speed.
        factor: f64,
    },
}

impl Differential {
    /// Finds the motion of all shafts from exactly two inputs. The inputs are either all speeds or all angles: the
    /// equation holds for both, because it is linear with constant coefficients.
    ///
    /// The train is at rest if both inputs are multiples of other shafts' speeds.
    ///
    /// # Errors
    /// Every fault of a single input; otherwise the reason why the inputs do not determine the motion.
    pub fn solve(&self, inputs: &[Input]) -> Result<Shafts, Vec<InputError>> {
        let reasons: Vec<InputError> = inputs.iter().filter_map(fault).collect();
        if !reasons.is_empty() {
            return Err(reasons);
        }
        let given = inputs.len();
        let [first, second] = match inputs {
            [first, second] => [first, second],
            [] | [_] => return Err(vec![InputError::Underdetermined { given }]),
            _ => return Err(vec![InputError::Overdetermined { given }]),
        };
        let rows = [first, second].map(row);
        let train = Vector3::from(Shaft::ALL.map(|shaft| self.weight(shaft) as f64));
        let across = rows[0].cross(&rows[1]);
        let determinant = train.dot(&across);
        let size = train.norm() * rows[0].norm() * rows[1].norm();
        if determinant.abs() <= tolerance::NEGLIGIBLE * size {
            return Err(vec![singular(first, second)]);
        }
        // Cramer's rule for three equations. The right-hand side of the train's equation is zero.
        let [value, other] = [first, second].map(right_hand_side);
        let solution =
            (rows[1].cross(&train) * value + train.cross(&rows[0]) * other) / determinant;
        let solved = Shafts {
            sun: solution.x,
            carrier: solution.y,
            ring: solution.z,
        };
        // Given values are returned as given, not rounded.
        Ok(Shafts::from_each(|shaft| {
            let given = [first, second].map(|input| match input.drive {
                Drive::Given(value) if input.shaft == shaft => Some(value),
                _ => None,
            });
            given[0].or(given[1]).unwrap_or(solved.of(shaft))
        }))
    }
}

fn fault(input: &Input) -> Option<InputError> {
    let shaft = input.shaft;
    let number = match input.drive {
        Drive::Tied { to, .. } if to == shaft => return Some(InputError::TiedToItself { shaft }),
        Drive::Tied { factor, .. } => factor,
        Drive::Given(value) => value,
    };
    let fault = Fault::check_size(number, GREATEST).err()?;
    Some(InputError::Number { shaft, fault })
}

/// Left-hand side of an input's equation: coefficients of the speeds, in the order of [`Shaft::ALL`].
fn row(input: &Input) -> Vector3<f64> {
    Vector3::from(Shaft::ALL.map(|shaft| match input.drive {
        _ if shaft == input.shaft => 1.0,
        Drive::Tied { to, factor } if shaft == to => -factor,
        _ => 0.0,
    }))
}

fn right_hand_side(input: &Input) -> f64 {
    match input.drive {
        Drive::Given(value) => value,
        Drive::Tied { .. } => 0.0,
    }
}

/// The reason why two inputs do not determine the motion: a given ratio of two speeds, or two inputs of one shaft.
fn singular(first: &Input, second: &Input) -> InputError {
    match (first.drive, second.drive) {
        (Drive::Tied { to, factor }, _) => {
            let shaft = first.shaft;
            InputError::SingularTie { shaft, to, factor }
        }
        (_, Drive::Tied { to, factor }) => {
            let shaft = second.shaft;
            InputError::SingularTie { shaft, to, factor }
        }
        _ => InputError::Twice { shaft: first.shaft },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use Shaft::{Carrier, Ring, Sun};

    fn given(shaft: Shaft, value: f64) -> Input {
        let drive = Drive::Given(value);
        Input { shaft, drive }
    }

    fn tied(shaft: Shaft, to: Shaft, factor: f64) -> Input {
        let drive = Drive::Tied { to, factor };
        Input { shaft, drive }
    }

    /// Sun of 20 and ring of 60 teeth: ω₁ + 3ω₄ = 4ω₃.
    #[test]
    fn two_given_speeds_determine_the_third() {
        let differential = Differential::planar([20.0, 60.0]).unwrap();
        for (inputs, [sun, carrier, ring]) in [
            ([given(Sun, 8.0), given(Ring, 0.0)], [8.0, 2.0, 0.0]),
            ([given(Sun, 0.0), given(Ring, 8.0)], [0.0, 6.0, 8.0]),
            ([given(Carrier, 0.0), given(Ring, 2.0)], [-6.0, 0.0, 2.0]),
            ([given(Carrier, 5.0), given(Sun, 5.0)], [5.0, 5.0, 5.0]),
            // The ring at three times the speed of the sun: 10 ω₁ = 4 ω₃.
            ([tied(Ring, Sun, 3.0), given(Carrier, 5.0)], [2.0, 5.0, 6.0]),
            (
                [tied(Sun, Carrier, 2.0), tied(Ring, Sun, 3.0)],
                [0.0, 0.0, 0.0],
            ),
        ] {
            let found = differential.solve(&inputs).unwrap();
            for (found, expected) in [
                (found.sun, sun),
                (found.carrier, carrier),
                (found.ring, ring),
            ] {
                assert!((found - expected).abs() < 1e-14, "{inputs:?}: {found}");
            }
        }
    }

    /// With the carrier held, 0 = ω₁ + 3ω₄: a ring at −1/3 of the speed of the sun may turn at any speed.
    #[test]
    fn a_ratio_that_the_train_has_already_determines_nothing() {
        let differential = Differential::planar([20.0, 60.0]).unwrap();
        let factor = -1.0 / 3.0;
        let inputs = [given(Carrier, 0.0), tied(Ring, Sun, factor)];
        let singular = InputError::SingularTie {
            shaft: Ring,
            to: Sun,
            factor,
        };
        assert_eq!(differential.solve(&inputs), Err(vec![singular]));
        let close = [given(Carrier, 0.0), tied(Ring, Sun, -0.333)];
        assert_eq!(differential.solve(&close).unwrap().sun.abs(), 0.0);
    }

    #[test]
    fn angles_obey_the_equation_of_the_speeds() {
        let differential = Differential::planar([20.0, 60.0]).unwrap();
        let turn = std::f64::consts::TAU;
        let angles = differential
            .solve(&[given(Sun, turn), given(Ring, 0.0)])
            .unwrap();
        assert!((angles.carrier - 0.25 * turn).abs() < 1e-15);
    }
}
