//! Drives of several freedoms, and the accelerations under them.

use super::Motor;
use super::lagrange::{Coordinates, FREEDOMS, Freedoms, Lagrange};
use crate::mechanism::Unsolved;

/// Coordinates of the drivers, with the work and the lost energy.
pub(super) const WIDTH: usize = FREEDOMS + 2;

/// What moves a driver of a linkage of several freedoms under load.
#[derive(Clone, Debug, PartialEq)]
pub enum Actuator {
    /// A motor, whose torque depends on the rate of the driver; [`Motor::NONE`] for a free one.
    Motor(Motor),
    /// A drive that keeps the rate of the driver, whatever its torque; at the rate zero it holds the driver.
    Rate,
}

/// Accelerations and torques under the drives.
#[derive(Clone, Copy, Debug)]
pub(super) struct Driven {
    pub(super) equations: Lagrange,
    pub(super) accelerations: Coordinates,
    pub(super) torques: Coordinates,
}

/// The equations at coordinates and rates, solved; None inside if nothing with a mass moves.
pub(super) fn driven(
    freedoms: &mut Freedoms,
    actuators: &[Actuator],
    [at, rates]: [&Coordinates; 2],
) -> Result<Option<Driven>, Unsolved> {
    let equations = freedoms.equations(at, rates)?;
    let mut torques = Coordinates::zeros();
    for (index, actuator) in actuators.iter().enumerate() {
        if let Actuator::Motor(motor) = actuator {
            // Coordinates have units, and so has their virtual work.
            let unit = freedoms.units[index];
            torques[index] = motor.torque(rates[index] * unit)[0] * unit;
        }
    }
    let found = equations.accelerations(&freedoms.held, &torques);
    Ok(found.map(|accelerations| {
        let needed = equations.torques(&accelerations);
        for index in (0..actuators.len()).filter(|index| freedoms.held[*index]) {
            torques[index] = needed[index];
        }
        Driven {
            equations,
            accelerations,
            torques,
        }
    }))
}

/// Accelerations, with the powers of the drives and loads and of what is lost, divided by a momentum.
pub(super) fn powers(found: &Driven, rates: &Coordinates, momentum: f64) -> [f64; WIDTH] {
    let mut all = [0.0; WIDTH];
    all[..FREEDOMS].copy_from_slice(found.accelerations.as_slice());
    let along = &found.equations.along;
    all[FREEDOMS] = (found.torques.dot(rates) + along.load) / momentum;
    all[FREEDOMS + 1] = -along.resistance(1.0) / momentum;
    all
}
