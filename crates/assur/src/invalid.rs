//! What is wrong with the dimensions of a mechanism. Codes with parameters:
//! the words are the caller's.

use std::fmt;

/// The dimension at fault.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// Length of the crank, l₁.
    Crank,
    /// Length of the coupler, l₂.
    Coupler,
    /// Length of the rocker, l₃.
    Rocker,
    /// Length of the frame, l₄.
    Frame,
    /// Number of teeth of the driving wheel.
    DriverTeeth,
    /// Number of teeth of the driven wheel.
    DrivenTeeth,
    /// Module of a pair of wheels.
    Module,
    /// Direction of the line from the driving to the driven wheel's centre.
    CentreLine,
}

/// Why a dimension cannot be taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// NaN or infinite.
    NotFinite,
    /// Zero or negative.
    NotPositive {
        /// As given.
        value: f64,
    },
    /// Outside what can be computed (or drawn) with sense.
    OutOfRange {
        /// As given.
        value: f64,
        /// Least that is taken.
        min: f64,
        /// Most that is taken.
        max: f64,
    },
    /// A number of teeth with a fraction.
    NotWhole {
        /// As given.
        value: f64,
    },
    /// At least as long as the other links together: the loop never closes, or
    /// closes in one position only.
    TooLong {
        /// How much longer than the other links together; 0 or more.
        by: f64,
    },
    /// Internal mesh of wheels with equally many teeth: their centres coincide.
    Concentric,
}

/// One reason why dimensions do not make a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Invalid {
    /// The dimension at fault.
    pub dimension: Dimension,
    /// Why it cannot be taken.
    pub fault: Fault,
}

impl Invalid {
    /// `value` if it lies in the range, which is positive; else the reason.
    pub(crate) fn check_positive(
        dimension: Dimension,
        value: f64,
        (min, max): (f64, f64),
    ) -> Result<f64, Self> {
        let fault = if !value.is_finite() {
            Fault::NotFinite
        } else if value <= 0.0 {
            Fault::NotPositive { value }
        } else if value < min || value > max {
            Fault::OutOfRange { value, min, max }
        } else {
            return Ok(value);
        };
        Err(Self { dimension, fault })
    }
}

impl fmt::Display for Invalid {
    /// For the programmer's log; the words for people live in string tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}: {:?}", self.dimension, self.fault)
    }
}

impl std::error::Error for Invalid {}
