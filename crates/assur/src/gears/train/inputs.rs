//! Two of the three shafts driven, held or tied: what all of them do.

use crate::tolerance;
use nalgebra::Vector3;

use super::differential::GREATEST;
use super::{Differential, Shaft, Shafts};
use crate::Fault;

/// What is wanted of a shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// The shaft.
    pub shaft: Shaft,
    /// How it moves.
    pub drive: Drive,
}

/// How a shaft is moved from outside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive {
    /// With this speed, or by this angle; 0: it is held.
    Given(f64),
    /// With a multiple of another shaft's speed, as by a train between the two.
    Tied {
        /// The other shaft.
        to: Shaft,
        /// The multiple.
        factor: f64,
    },
}

/// Why inputs do not determine the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InputError {
    /// A speed or a factor that is no number, or out of range.
    Number {
        /// Of which shaft's input.
        shaft: Shaft,
        /// What is wrong with it.
        fault: Fault,
    },
    /// A time in which a shaft cannot rise to its speed.
    Rise {
        /// The shaft.
        shaft: Shaft,
        /// What is wrong with it.
        fault: Fault,
    },
    /// A shaft that follows the given ones turns faster than angles can be computed.
    TooFast {
        /// The shaft.
        shaft: Shaft,
        /// Its speed, revolutions per minute.
        speed: f64,
    },
    /// A shaft tied to itself.
    TiedToItself {
        /// The shaft.
        shaft: Shaft,
    },
    /// A shaft has two speeds at once.
    Twice {
        /// The shaft.
        shaft: Shaft,
    },
    /// The train has two freedoms, and fewer inputs are given.
    Underdetermined {
        /// How many.
        given: usize,
    },
    /// The train has two freedoms, and more inputs are given.
    Overdetermined {
        /// How many.
        given: usize,
    },
    /// With this tie the train stands still or moves at any speed: no other input
    /// determines it.
    SingularTie {
        /// The shaft that is tied.
        shaft: Shaft,
        /// To which one.
        to: Shaft,
        /// With which factor.
        factor: f64,
    },
}

impl Differential {
    /// The motion of all shafts from exactly two inputs; of angles as of speeds,
    /// for the equation is linear and has no memory.
    ///
    /// Two ties leave the train at rest.
    ///
    /// # Errors
    /// Every reason why single inputs cannot be; else that they do not determine the motion.
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
        // Cramer's rule for three equations, the train's without right-hand side.
        let [value, other] = [first, second].map(right_hand_side);
        let solution =
            (rows[1].cross(&train) * value + train.cross(&rows[0]) * other) / determinant;
        let solved = Shafts {
            sun: solution.x,
            carrier: solution.y,
            ring: solution.z,
        };
        // What is given is that, not rounded.
        Ok(Shafts::from_each(|shaft| {
            let given = [first, second].map(|input| match input.drive {
                Drive::Given(value) if input.shaft == shaft => Some(value),
                _ => None,
            });
            given[0].or(given[1]).unwrap_or(solved.of(shaft))
        }))
    }
}

/// What is wrong with an input alone.
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

/// The left-hand side of an input as an equation, in the order of [`Shaft::ALL`].
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

/// Why two inputs do not determine the motion: without a tie they are of one shaft.
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
