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
    /// How many wheels are driven.
    Wheels,
    /// Number of teeth of a driven wheel, counted from 0.
    DrivenTeeth(usize),
    /// Module of the wheels.
    Module,
    /// Direction of the line from the driving to a driven wheel's centre.
    CentreLine(usize),
    /// How many points are traced.
    Tracers,
    /// The body that carries a traced point, counted from 0.
    TracerCarrier(usize),
    /// A traced point's place along its body.
    TracerX(usize),
    /// A traced point's place across its body.
    TracerY(usize),
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
    /// Internal mesh of one driver with larger and with smaller wheels: it would
    /// have to be a ring to these and inside of those.
    BothSides,
    /// There is no such part.
    Absent,
}

impl Fault {
    /// `value` if its size is not beyond `most`.
    pub(crate) fn check_size(value: f64, most: f64) -> Result<f64, Self> {
        let (min, max) = (-most, most);
        if !value.is_finite() {
            Err(Self::NotFinite)
        } else if value.abs() > most {
            Err(Self::OutOfRange { value, min, max })
        } else {
            Ok(value)
        }
    }

    /// `value` if it lies in the range, which is positive.
    pub(crate) fn check_positive(value: f64, (min, max): (f64, f64)) -> Result<f64, Self> {
        if !value.is_finite() {
            Err(Self::NotFinite)
        } else if value <= 0.0 {
            Err(Self::NotPositive { value })
        } else if value < min || value > max {
            Err(Self::OutOfRange { value, min, max })
        } else {
            Ok(value)
        }
    }

    /// `value` as a whole number in the range, which is positive.
    pub(crate) fn check_count(value: f64, range: (f64, f64)) -> Result<u32, Self> {
        if value > 0.0 && value.is_finite() && value.fract() != 0.0 {
            return Err(Self::NotWhole { value });
        }
        Self::check_positive(value, range).map(|whole| whole as u32)
    }
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
    /// `value` if its size is not beyond `most`; else the reason.
    pub(crate) fn check_size(dimension: Dimension, value: f64, most: f64) -> Result<f64, Self> {
        Fault::check_size(value, most).map_err(|fault| Self { dimension, fault })
    }

    /// `value` if it lies in the range, which is positive; else the reason.
    pub(crate) fn check_positive(
        dimension: Dimension,
        value: f64,
        range: (f64, f64),
    ) -> Result<f64, Self> {
        Fault::check_positive(value, range).map_err(|fault| Self { dimension, fault })
    }
}

impl fmt::Display for Invalid {
    /// For the programmer's log; the words for people live in string tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}: {:?}", self.dimension, self.fault)
    }
}

impl std::error::Error for Invalid {}
