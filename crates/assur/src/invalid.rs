//! Invalid dimensions of a mechanism, as codes with parameters. The caller supplies the texts.

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
    /// Number of driven wheels.
    Wheels,
    /// Number of teeth of the driven wheel with this index.
    DrivenTeeth(usize),
    /// Module of the wheels.
    Module,
    /// Direction of the line from the driver's centre to the centre of the driven wheel with this index.
    CentreLine(usize),
    /// Number of traced points.
    Tracers,
    /// The body that carries the traced point with this index.
    TracerCarrier(usize),
    /// Coordinate of the traced point with this index along its body.
    TracerX(usize),
    /// Coordinate of the traced point with this index across its body.
    TracerY(usize),
}

/// Reasons why a dimension is invalid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fault {
    /// NaN or infinite.
    NotFinite,
    /// Zero or negative.
    NotPositive {
        /// The given value.
        value: f64,
    },
    /// Outside the range that can be computed and drawn.
    OutOfRange {
        /// The given value.
        value: f64,
        /// Minimum.
        min: f64,
        /// Maximum.
        max: f64,
    },
    /// A count, such as a number of teeth, that is not whole.
    NotWhole {
        /// The given value.
        value: f64,
    },
    /// At least as long as the other links together: the loop closes in one position or not at all.
    TooLong {
        /// Excess over the length of the other links together; 0 or more.
        by: f64,
    },
    /// Internal mesh of wheels with equal numbers of teeth: their centres coincide.
    Concentric,
    /// One driver in internal mesh with both larger and smaller wheels: it cannot be both pinion and ring.
    BothSides,
    /// The body that is referred to does not exist.
    Absent,
}

impl Fault {
    /// Returns the value if it is in the range.
    pub(crate) fn check_within(value: f64, (min, max): (f64, f64)) -> Result<f64, Self> {
        if !value.is_finite() {
            Err(Self::NotFinite)
        } else if value < min || value > max {
            Err(Self::OutOfRange { value, min, max })
        } else {
            Ok(value)
        }
    }

    /// Returns the value if its absolute value is at most the maximum.
    pub(crate) fn check_size(value: f64, max_size: f64) -> Result<f64, Self> {
        Self::check_within(value, (-max_size, max_size))
    }

    /// Returns the value if it is positive and in the range.
    pub(crate) fn check_positive(value: f64, range: (f64, f64)) -> Result<f64, Self> {
        if value.is_finite() && value <= 0.0 {
            Err(Self::NotPositive { value })
        } else {
            Self::check_within(value, range)
        }
    }

    /// Returns the value as an integer if it is whole, positive and in the range.
    pub(crate) fn check_count(value: f64, range: (f64, f64)) -> Result<u32, Self> {
        if value > 0.0 && value.is_finite() && value.fract() != 0.0 {
            return Err(Self::NotWhole { value });
        }
        Self::check_positive(value, range).map(|whole| whole as u32)
    }
}

/// An invalid dimension.
///
/// ```
/// use assur::{Dimension, Fault, FourBar};
/// let faults = FourBar::new([-1.0, 2.0, 2.0, 2.0]).unwrap_err();
/// assert_eq!(faults[0].dimension, Dimension::Crank);
/// assert_eq!(faults[0].fault, Fault::NotPositive { value: -1.0 });
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Invalid {
    /// The dimension at fault.
    pub dimension: Dimension,
    /// The reason why the dimension is invalid.
    pub fault: Fault,
}

impl Invalid {
    pub(crate) fn check_size(dimension: Dimension, value: f64, max_size: f64) -> Result<f64, Self> {
        Fault::check_size(value, max_size).map_err(|fault| Self { dimension, fault })
    }

    pub(crate) fn check_positive(
        dimension: Dimension,
        value: f64,
        range: (f64, f64),
    ) -> Result<f64, Self> {
        Fault::check_positive(value, range).map_err(|fault| Self { dimension, fault })
    }
}

impl fmt::Display for Invalid {
    /// Writes codes for the programmer's log. Texts for users are in string tables.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}: {:?}", self.dimension, self.fault)
    }
}

impl std::error::Error for Invalid {}
