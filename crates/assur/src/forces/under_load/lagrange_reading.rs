//! State and end of a run of several freedoms.

use crate::mechanism::Unsolved;

/// State of a run at a time.
#[derive(Clone, Debug, PartialEq)]
pub struct LagrangeReading {
    /// Time since the start.
    pub time: f64,
    /// Coordinates of the drivers; angles of cranks are not reduced to a turn.
    pub coordinates: Vec<f64>,
    /// Their rates.
    pub rates: Vec<f64>,
    /// Their accelerations.
    pub accelerations: Vec<f64>,
    /// Torques of the drives; forces of driven slides.
    pub torques: Vec<f64>,
    /// Kinetic energy.
    pub kinetic: f64,
    /// Potential energy of gravity and springs.
    pub potential: f64,
    /// Work of the drives and of the given forces and torques since the start.
    pub work: f64,
    /// Energy lost in resistances and dampers since the start.
    pub lost: f64,
}

/// End of a run of several freedoms: a singular pose, or the end of the range of a driven slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Blocked {
    /// Time of the last pose.
    pub time: f64,
    /// The reason why there is no pose beyond.
    pub unsolved: Unsolved,
}
